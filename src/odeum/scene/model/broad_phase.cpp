// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "odeum/scene/model/terms.hpp"

namespace odeum::scene {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct Placed {
  Cell cell;
  std::uint32_t particle;
  auto operator<=>(const Placed&) const = default;
};

// Far out and not finite positions share the outermost cells: no contact is lost, and none of them
// overflows.
std::int64_t cell_of(double x, double width) {
  constexpr double edge = 1e15;
  const double cell = std::floor(x / width);
  return static_cast<std::int64_t>(std::isnan(cell) ? edge : std::clamp(cell, -edge, edge));
}

}  // namespace

void possible_contacts(const Bodies& bodies, const double* q,
                       std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
  pairs.clear();
  double widest = 0;
  for (const double radius : bodies.radius) widest = std::max(widest, radius);
  if (widest == 0) return;
  std::vector<Placed> placed(bodies.size());
  for (std::uint32_t i = 0; i < placed.size(); ++i) {
    placed[i].particle = i;
    for (std::size_t d = 0; d < 3; ++d) placed[i].cell[d] = cell_of(q[3 * i + d], 2 * widest);
  }
  std::ranges::sort(placed);
  const auto starts_at = [&](const Cell& cell) {
    return std::ranges::lower_bound(placed, Placed{cell, 0});
  };
  // Three cells that follow each other in z are one run; of the nine runs around a particle.
  for (const Placed& one : placed)
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        Cell cell{one.cell[0] + dx, one.cell[1] + dy, one.cell[2] - 1};
        const Cell end{cell[0], cell[1], cell[2] + 2};
        for (auto other = starts_at(cell); other != placed.end() && other->cell <= end; ++other) {
          const std::uint32_t i = one.particle, j = other->particle;
          if (i >= j || bodies.radius[i] + bodies.radius[j] == 0) continue;
          if (bodies.free(i) || bodies.free(j)) pairs.emplace_back(i, j);
        }
      }
  std::ranges::sort(pairs);
}

}  // namespace odeum::scene
