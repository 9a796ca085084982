// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "odeum/core/lanes.hpp"

/// Which of many boxes are near to a box: a grid of cells that are as wide as two boxes and the
/// distance, in a block that repeats, so that its size does not depend on where things are.
namespace odeum::scene {

struct Box {
  std::array<double, 3> low{big, big, big}, high{-big, -big, -big};
  static constexpr double big = std::numeric_limits<double>::max();

  void add(const double* x) {
    for (std::size_t d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], x[d]);
      high[d] = std::max(high[d], x[d]);
    }
  }
  /// No axis separates them by more than this.
  bool is_near(const Box& other, double distance) const {
    for (std::size_t d = 0; d < 3; ++d)
      if (!(low[d] - other.high[d] <= distance && other.low[d] - high[d] <= distance)) return false;
    return true;
  }
  double distance(const Box& other) const {
    double squared = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double gap = std::max({0.0, low[d] - other.high[d], other.low[d] - high[d]});
      squared += gap * gap;
    }
    return std::sqrt(squared);
  }
  double half() const {
    return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}) / 2;
  }
};

class Cells {
 public:
  /// Queries are made with these boxes, or with others.
  Cells(std::span<const Box> boxes, double distance) : Cells(boxes, distance, boxes) {}
  Cells(std::span<const Box> boxes, double distance, std::span<const Box> queries)
      : distance_(distance) {
    while (bits_ < 6 && std::size_t{6} << (2 * bits_) < boxes.size()) ++bits_;
    double mine = 0, theirs = 0;
    for (const Box& box : boxes) mine = std::max(mine, box.half());
    for (const Box& box : queries) theirs = std::max(theirs, box.half());
    width_ = mine + theirs + distance;
    const std::size_t count = std::size_t{1} << (3 * bits_);
    starts_.assign(count + 1, 0);
    std::vector<std::uint32_t> cells(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      cells[i] = index(cell_of(boxes[i]));
      ++starts_[cells[i] + 1];
    }
    for (std::size_t c = 0; c < count; ++c) starts_[c + 1] += starts_[c];
    // Vectors of numbers are read from any of them.
    sorted_.resize(boxes.size());
    for (std::size_t d = 0; d < 3; ++d) {
      low_[d].assign(boxes.size() + Lanes::count, 0);
      high_[d].assign(boxes.size() + Lanes::count, 0);
    }
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      const std::uint32_t place = next[cells[i]]++;
      sorted_[place] = i;
      for (std::size_t d = 0; d < 3; ++d)
        low_[d][place] = boxes[i].low[d], high_[d][place] = boxes[i].high[d];
    }
  }

  /// Calls use(i), ascending, for each box with i >= first that is near.
  template <class Use>
  void visit(const Box& box, std::size_t first, const Use& use) const {
    thread_local std::vector<std::uint32_t> found;
    found.clear();
    const Cell centre = cell_of(box);
    const std::uint32_t mask = (1U << bits_) - 1;
    for (std::uint32_t dx = 0; dx < 3; ++dx)
      for (std::uint32_t dy = 0; dy < 3; ++dy) {
        const std::uint32_t x = centre[0] + dx - 1, y = centre[1] + dy - 1, z = centre[2];
        if (z > 0 && z < mask) {  // three cells that follow each other
          const std::uint32_t middle = index({x, y, z});
          look(starts_[middle - 1], starts_[middle + 2], box, first, found);
          continue;
        }
        for (std::uint32_t dz = 0; dz < 3; ++dz) {
          const std::uint32_t one = index({x, y, z + dz - 1});
          look(starts_[one], starts_[one + 1], box, first, found);
        }
      }
    std::ranges::sort(found);
    for (const std::uint32_t i : found) use(i);
  }

 private:
  using Cell = std::array<std::uint32_t, 3>;
  void look(std::uint32_t from, std::uint32_t to, const Box& box, std::size_t first,
            std::vector<std::uint32_t>& found) const {
    for (std::uint32_t k = from; k < to; k += Lanes::count) {
      LaneMask near = lanes_at(low_[0], k) - box.high[0] <= distance_;
      for (std::size_t d = 0; d < 3; ++d)
        near = near & (lanes_at(low_[d], k) - box.high[d] <= distance_) &
               (box.low[d] - lanes_at(high_[d], k) <= distance_);
      if (!any(near)) continue;
      for (std::uint32_t lane = 0; lane < Lanes::count && k + lane < to; ++lane)
        if (near[lane] && sorted_[k + lane] >= first) found.push_back(sorted_[k + lane]);
    }
  }
  static Lanes lanes_at(const std::vector<double>& numbers, std::size_t k) {
    LaneVector v;
    std::memcpy(&v, numbers.data() + k, sizeof v);
    return Lanes(v);
  }
  // Where a box is far out or not finite, the first one.
  Cell cell_of(const Box& box) const {
    Cell cell{};
    for (std::size_t d = 0; d < 3; ++d) {
      const double at = std::floor((box.low[d] / 2 + box.high[d] / 2) / width_);
      if (std::abs(at) < 1e15)
        cell[d] = static_cast<std::uint32_t>(static_cast<std::int64_t>(at)) & ((1U << bits_) - 1);
    }
    return cell;
  }
  std::uint32_t index(const Cell& cell) const {
    const std::uint32_t mask = (1U << bits_) - 1;
    return (((cell[0] & mask) << bits_ | (cell[1] & mask)) << bits_) | (cell[2] & mask);
  }

  double distance_, width_ = 0;
  std::uint32_t bits_ = 2;  ///< of the number of cells along an axis of the block
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> sorted_;     ///< the boxes of cell after cell
  std::vector<double> low_[3], high_[3];  ///< of these
};

}  // namespace odeum::scene
