// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "odeum/scene/model/scene.hpp"
#include "odeum/scene/springs/spring_kernels.hpp"

namespace odeum::scene {

/// All springs of one offset (rows, columns) between their ends: the same everywhere on the grid.
/// The offset is at most 2 each way and points down the rows, or along one.
struct SpringKind {
  int row_offset = 0, column_offset = 0;  ///< from a to b
  double stiffness = 0, damping = 0, rest_length = 0;
  bool tension_only = false;
};

/// Where a grid of rows x columns particles lies in memory: one array a component, row after row,
/// with a margin of two rows and columns around it and between rows, so that no neighbour lies
/// outside.
struct GridLayout {
  static constexpr std::size_t margin = 2;
  std::size_t rows = 0, columns = 0;
  std::size_t stride = 0;  ///< from row to row, in numbers
  std::size_t size = 0;    ///< of one component's array

  GridLayout() = default;
  GridLayout(std::size_t rows, std::size_t columns);
  bool operator==(const GridLayout&) const = default;
  std::size_t row(std::size_t r) const { return (r + margin) * stride + margin; }
  /// The distance from the place of end a of a spring to that of end b, in numbers.
  std::size_t offset(const SpringKind& kind) const {
    return static_cast<std::size_t>(kind.row_offset) * stride +
           static_cast<std::size_t>(kind.column_offset);
  }
  /// Calls visit(place of end a) for each spring of one kind.
  template <class Visit>
  void each_spring(const SpringKind& kind, Visit&& visit) const {
    const int dr = kind.row_offset, dc = kind.column_offset;
    const int most_rows = static_cast<int>(rows), most_columns = static_cast<int>(columns);
    for (int r = 0; r + dr < most_rows; ++r)
      for (int c = std::max(0, -dc); c < most_columns - std::max(0, dc); ++c)
        visit(row(static_cast<std::size_t>(r)) + static_cast<std::size_t>(c));
  }

  /// Moves x y z of particle after particle to three arrays of this layout, and back.
  template <class Real>
  void scatter(const double* particles, Real* arrays) const;
  template <class Real>
  void gather(const Real* arrays, double* particles) const;
};

/// Springs on a regular grid, of as many particles at once as a vector holds. The force of each
/// spring is computed once, and kept for its other end; all else by gathering: each particle sums
/// up what all its neighbours do to it, so that no result is scattered. In this form the arrays
/// have GridLayout, three components one after the other (x, y, z; each layout().size numbers),
/// whose margins may hold any finite numbers.
template <class Real>
class GridSprings {
 public:
  GridSprings(const GridLayout& layout, const std::vector<SpringKind>& kinds);
  GridSprings(const GridSprings&) = delete;  // neighbours point into the masks
  GridSprings(GridSprings&&) noexcept = default;
  GridSprings& operator=(const GridSprings&) = delete;

  const GridLayout& layout() const { return layout_; }
  const std::vector<SpringKind>& kinds() const { return kinds_; }

  /// Force on each particle of rows [begin, end); q, v and force have 3 * layout().size numbers.
  /// v may be null: without the dampers. Where `scale` is not null, the force times it, plus `add`.
  void forces(const Real* q, const Real* v, Real* force, std::size_t begin, std::size_t end,
              const Real* scale = nullptr, const Real* add = nullptr) const;
  /// The part of the dampers alone, D v with a constant D that is the same in all components.
  void damping(const Real* v, Real* force, std::size_t begin, std::size_t end) const {
    kernels_->damping(view(), v, force, begin, end);
  }
  /// Its derivative at q in the direction (dq, dv).
  void derivative(const Real* q, const Real* dq, const Real* dv, Real* change, std::size_t begin,
                  std::size_t end) const {
    kernels_->derivative(view(), q, dq, dv, change, begin, end);
  }
  /// The stiffness of the springs of one kind, each at the index of its end a: the derivative of
  /// the force on a with respect to the position of b is across I + s s^T. `across` has
  /// layout().size numbers, `s` three times as many; where there is no spring they are zero in the
  /// rows, and not written in the margins. No rest length may be negative. `clamped`: without the
  /// part across a compressed spring, which is negative, so that the sum over all springs is
  /// semidefinite.
  void stiffness(std::size_t kind, const Real* q, bool clamped, Real* across, Real* s) const {
    kernels_->stiffness(view(), kind, q, clamped, across, s);
  }

 private:
  SpringRows<Real> view() const;

  GridLayout layout_;
  std::vector<SpringKind> kinds_;
  std::vector<SpringNeighbour<Real>> neighbours_;
  std::vector<Real> masks_;  // of column offsets -2 ... 2
  bool damped_ = false, moderate_ = true;
  const SpringKernels<Real>* kernels_ = spring_kernels<Real>().back();
};

extern template class GridSprings<double>;
extern template class GridSprings<float>;

/// The grid that all particles and springs form, if they do: particle r * columns + c at row r and
/// column c, every kind of spring at every place, alike to a few roundings (rest lengths: of the
/// coordinates), none with axial damping.
struct GridStructure {
  std::size_t rows = 0, columns = 0;
  std::vector<SpringKind> kinds;
};
std::optional<GridStructure> find_grid(const std::vector<Particle>& particles,
                                       const std::vector<Spring>& springs);
/// The grid of a scene; throws std::invalid_argument where it is none or has a velocity_matrix.
GridStructure require_grid(const Scene& scene);

}  // namespace odeum::scene
