// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "odeum/scene/springs/spring_grid.hpp"

namespace odeum::scene {
namespace {

bool alike(double a, double b) {
  return std::abs(a - b) <= 1e-14 * std::max(std::abs(a), std::abs(b));
}

// Rest lengths come from differences of positions, which round differently along a grid.
bool alike(const SpringKind& kind, const Spring& spring, double rounding) {
  return !(spring.axial && spring.damping != 0) && alike(kind.stiffness, spring.stiffness) &&
         alike(kind.damping, spring.damping) &&
         std::abs(kind.rest_length - spring.rest_length) <= rounding &&
         kind.tension_only == spring.tension_only;
}

/// A few roundings of the largest coordinate.
double rounding_of_positions(const std::vector<Particle>& particles) {
  double largest = 0;
  for (const Particle& particle : particles)
    for (const double coordinate : particle.position)
      largest = std::max(largest, std::abs(coordinate));
  return 8 * std::numeric_limits<double>::epsilon() * largest;
}

/// The offset of a spring, pointing down the rows or along one.
SpringKind kind_of(const Spring& spring, std::size_t columns) {
  const auto [first, last] = std::minmax(spring.a, spring.b);
  return {.row_offset = static_cast<int>(last / columns - first / columns),
          .column_offset = static_cast<int>(last % columns) - static_cast<int>(first % columns),
          .stiffness = spring.stiffness,
          .damping = spring.damping,
          .rest_length = spring.rest_length,
          .tension_only = spring.tension_only};
}

std::optional<GridStructure> as_grid(const std::vector<Particle>& particles,
                                     const std::vector<Spring>& springs, std::size_t columns) {
  GridStructure grid{.rows = particles.size() / columns, .columns = columns, .kinds = {}};
  const double rounding = rounding_of_positions(particles);
  std::vector<std::vector<bool>> seen;  // by kind, by the first end
  for (const Spring& spring : springs) {
    const SpringKind wanted = kind_of(spring, columns);
    if (wanted.row_offset > 2 || std::abs(wanted.column_offset) > 2) return std::nullopt;
    // No spring of a cloth joins a row to the next but two columns on: a chain of 21 does so, wound
    // into rows of 3.
    if (wanted.row_offset + std::abs(wanted.column_offset) == 3) return std::nullopt;
    auto kind = std::ranges::find_if(grid.kinds, [&](const SpringKind& k) {
      return k.row_offset == wanted.row_offset && k.column_offset == wanted.column_offset;
    });
    if (kind == grid.kinds.end()) {
      kind = grid.kinds.insert(kind, wanted);
      seen.emplace_back(particles.size());
    }
    if (!alike(*kind, spring, rounding)) return std::nullopt;
    auto place = seen[static_cast<std::size_t>(kind - grid.kinds.begin())].begin() +
                 static_cast<std::ptrdiff_t>(std::min(spring.a, spring.b));
    if (*place) return std::nullopt;  // two springs between the same ends
    *place = true;
  }
  if (grid.kinds.size() > 8) return std::nullopt;
  for (std::size_t k = 0; k < grid.kinds.size(); ++k) {
    const auto dr = static_cast<std::size_t>(grid.kinds[k].row_offset);
    const auto dc = static_cast<std::size_t>(std::abs(grid.kinds[k].column_offset));
    const std::size_t places = grid.rows > dr ? (grid.rows - dr) * (columns - dc) : 0;
    if (static_cast<std::size_t>(std::ranges::count(seen[k], true)) != places) return std::nullopt;
  }
  return grid;
}

}  // namespace

std::optional<GridStructure> find_grid(const std::vector<Particle>& particles,
                                       const std::vector<Spring>& springs) {
  if (springs.empty()) return std::nullopt;
  const std::size_t count = particles.size();
  for (std::size_t columns = 3; 3 * columns <= count; ++columns)
    if (count % columns == 0)
      if (auto grid = as_grid(particles, springs, columns)) return grid;
  return std::nullopt;
}

GridStructure require_grid(const Scene& scene) {
  auto grid = find_grid(scene.particles, scene.springs);
  if (!grid) throw std::invalid_argument("the springs of the scene form no regular grid");
  if (scene.velocity_matrix != Mat3{})
    throw std::invalid_argument("a grid of springs has no velocity_matrix");
  return *grid;
}

}  // namespace odeum::scene
