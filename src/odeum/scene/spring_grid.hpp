// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "odeum/scene/scene.hpp"

namespace odeum::scene {

/// Where a grid of rows x columns particles lies in memory: one array a component, row after row,
/// with a margin of two rows and columns around it, so that no neighbour lies outside.
struct GridLayout {
  static constexpr std::size_t margin = 2;
  std::size_t rows = 0, columns = 0;
  std::size_t stride = 0;  ///< from row to row, in numbers
  std::size_t size = 0;    ///< of one component's array

  GridLayout() = default;
  GridLayout(std::size_t rows, std::size_t columns);
  std::size_t row(std::size_t r) const { return (r + margin) * stride + margin; }

  /// From x y z of particle after particle to three arrays of this layout, and back.
  template <class Real>
  void scatter(const double* particles, Real* arrays) const;
  template <class Real>
  void gather(const Real* arrays, double* particles) const;
};

/// All springs of one offset (rows, columns) between their ends: the same everywhere on the grid.
struct SpringKind {
  int row_offset = 0, column_offset = 0;  ///< from a to b; each at most 2 in size
  double stiffness = 0, damping = 0, rest_length = 0;
  bool tension_only = false;
};

/// Springs on a regular grid, computed by gathering: each particle sums up what all its neighbours
/// do to it, eight (or sixteen) particles at once. Every spring is computed twice, and no result
/// is scattered. In this form the arrays have GridLayout, three components one after the other
/// (x, y, z; each layout().size numbers), whose margins may hold any finite numbers.
template <class Real>
class GridSprings {
 public:
  GridSprings(const GridLayout& layout, const std::vector<SpringKind>& kinds);

  const GridLayout& layout() const { return layout_; }
  const std::vector<SpringKind>& kinds() const { return kinds_; }

  /// Force on each particle of rows [begin, end); q, v and force have 3 * layout().size numbers.
  void forces(const Real* q, const Real* v, Real* force, std::size_t begin, std::size_t end) const;
  /// Its derivative at q in the direction (dq, dv).
  void derivative(const Real* q, const Real* dq, const Real* dv, Real* change, std::size_t begin,
                  std::size_t end) const;

 private:
  struct Neighbour {
    int row_offset;
    std::ptrdiff_t offset;  // in a component's array
    Real stiffness, stiffness_length, damping;
    Real least;        // of k (1 - L/l): 0 for tension-only springs
    const Real* mask;  // by column: 1 where the neighbour is on the grid
  };
  template <class Visit>
  void gather(std::size_t begin, std::size_t end, Visit&& visit) const;

  GridLayout layout_;
  std::vector<SpringKind> kinds_;
  std::vector<Neighbour> neighbours_;
  std::vector<Real> masks_;  // of column offsets -2 ... 2
};

extern template class GridSprings<double>;
extern template class GridSprings<float>;

/// The grid that all particles and springs of a scene form, if they do: particle r * columns + c
/// at row r and column c, every kind of spring at every place, alike to a few roundings.
struct GridStructure {
  std::size_t rows = 0, columns = 0;
  std::vector<SpringKind> kinds;
};
std::optional<GridStructure> find_grid(const Scene& scene);

}  // namespace odeum::scene
