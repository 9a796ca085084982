// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <vector>

#include "odeum/scene/surface/pair_lanes.hpp"

namespace odeum::scene {

/// The derivatives K of the forces between surfaces by positions, without friction: symmetric, kept
/// as one matrix of r, e1 and e2 for each pair between which a force acts.
class SurfaceStiffness {
 public:
  explicit SurfaceStiffness(const Surfaces& surfaces) : surfaces_(surfaces) {}
  std::size_t particles() const { return surfaces_.numbers() / 3; }
  bool empty() const { return pairs_.empty(); }

  /// At the places q. `clamped`: the part by the distance alone, which makes K negative
  /// semidefinite.
  void assemble(const double* q, bool clamped);
  /// product += factor K x, by particle.
  void add_product(const Quads& x, double factor, Quads& product) const;
  /// Adds factor times the blocks of K on its diagonal: xx, xy, xz, yy, yz, zz of each particle.
  void add_diagonal(double factor, std::vector<std::array<double, 6>>& blocks) const;

 private:
  static constexpr std::size_t unknowns = 9;  ///< r, e1, e2
  struct Pairs {
    PairLanes lanes;
    std::array<Lanes, unknowns*(unknowns + 1) / 2> entries{};  ///< row by row from the diagonal
    const Lanes& at(std::size_t row, std::size_t column) const {
      if (row > column) std::swap(row, column);
      return entries[row * unknowns - row * (row + 1) / 2 + column];
    }
  };

  const Surfaces& surfaces_;
  std::vector<Pairs> pairs_;
  Quads places_;
};

}  // namespace odeum::scene
