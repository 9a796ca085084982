// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/springs/spring_grid.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace odeum::scene {

namespace {

// Numbers of a row that are read and written, in whole vectors of 16 at most.
constexpr std::size_t widest = 16;
std::size_t in_vectors(std::size_t columns) { return (columns + widest - 1) / widest * widest; }

}  // namespace

// The margin right of a row is that left of the next, which a row's last vector may reach.
GridLayout::GridLayout(std::size_t rows_, std::size_t columns_)
    : rows(rows_),
      columns(columns_),
      stride(std::max(columns + margin, in_vectors(columns))),
      size((rows + 2 * margin) * stride + margin + widest) {}

template <class Real>
void GridLayout::scatter(const double* particles, Real* arrays) const {
  for (std::size_t r = 0; r < rows; ++r, particles += 3 * columns) {
    Real *const x = arrays + row(r), *const y = x + size, *const z = y + size;
    for (std::size_t c = 0; c < columns; ++c) {
      x[c] = static_cast<Real>(particles[3 * c]);
      y[c] = static_cast<Real>(particles[3 * c + 1]);
      z[c] = static_cast<Real>(particles[3 * c + 2]);
    }
  }
}

template <class Real>
void GridLayout::gather(const Real* arrays, double* particles) const {
  for (std::size_t r = 0; r < rows; ++r, particles += 3 * columns) {
    const Real *const x = arrays + row(r), *const y = x + size, *const z = y + size;
    for (std::size_t c = 0; c < columns; ++c) {
      particles[3 * c] = static_cast<double>(x[c]);
      particles[3 * c + 1] = static_cast<double>(y[c]);
      particles[3 * c + 2] = static_cast<double>(z[c]);
    }
  }
}

template void GridLayout::scatter(const double*, double*) const;
template void GridLayout::scatter(const double*, float*) const;
template void GridLayout::gather(const double*, double*) const;
template void GridLayout::gather(const float*, double*) const;

template <class Real>
GridSprings<Real>::GridSprings(const GridLayout& layout, const std::vector<SpringKind>& kinds)
    : layout_(layout), kinds_(kinds) {
  const std::size_t width = layout.stride;
  masks_.assign(5 * width, 0);
  for (std::ptrdiff_t dc = -2; dc <= 2; ++dc)
    for (std::size_t c = 0; c < layout.columns; ++c) {
      const std::ptrdiff_t neighbour = static_cast<std::ptrdiff_t>(c) + dc;
      if (neighbour >= 0 && neighbour < static_cast<std::ptrdiff_t>(layout.columns))
        masks_[static_cast<std::size_t>(dc + 2) * width + c] = 1;
    }
  for (const SpringKind& kind : kinds) {
    damped_ = damped_ || kind.damping != 0;
    // Then the rounding of positions, at least L 1e-16, is more than what a bound of 1e-19 m under
    // the length changes, and so is the rounding of k more than k L/l where l is beyond 1e19 m.
    const double length = std::abs(kind.rest_length);
    moderate_ = moderate_ && (length == 0 || (length > 1e-3 && length < 1e3));
    for (const int side : {1, -1}) {
      const int dr = side * kind.row_offset, dc = side * kind.column_offset;
      neighbours_.push_back(
          {.row_offset = dr,
           .offset = dr * static_cast<std::ptrdiff_t>(width) + dc,
           .stiffness = static_cast<Real>(kind.stiffness),
           .stiffness_length = static_cast<Real>(kind.stiffness * kind.rest_length),
           .damping = static_cast<Real>(kind.damping),
           .least = kind.tension_only ? Real(0) : std::numeric_limits<Real>::lowest(),
           .mask = masks_.data() + static_cast<std::size_t>(dc + 2) * width});
    }
  }
}

template <class Real>
void GridSprings<Real>::forces(const Real* q, const Real* v, Real* force, std::size_t begin,
                               std::size_t end, const Real* scale, const Real* add) const {
  // Lines start where a vector register's address would, and zeros are between them.
  constexpr std::size_t alignment = 64 / sizeof(Real);
  SpringRows<Real> rows = view();
  rows.damped = rows.damped && v;
  rows.scale = scale;
  rows.add = add;
  rows.line = in_vectors(layout_.columns) + widest;
  const std::size_t needed = 12 * kinds_.size() * rows.line + widest + alignment;
  thread_local std::vector<Real> space;
  thread_local std::size_t columns = 0;
  if (columns != rows.columns || space.size() < needed) space.assign(needed, 0);
  columns = rows.columns;
  const auto place = reinterpret_cast<std::uintptr_t>(space.data() + widest) / sizeof(Real);
  rows.kept = space.data() + widest + (alignment - place % alignment) % alignment;
  kernels_->forces(rows, q, v ? v : q, force, begin, end);
}

template <class Real>
SpringRows<Real> GridSprings<Real>::view() const {
  return {.rows = layout_.rows,
          .columns = layout_.columns,
          .stride = layout_.stride,
          .size = layout_.size,
          .margin = GridLayout::margin,
          .neighbours = neighbours_.data(),
          .count = neighbours_.size(),
          .damped = damped_,
          .moderate = moderate_,
          .kept = nullptr,
          .line = 0,
          .scale = nullptr,
          .add = nullptr};
}

template class GridSprings<double>;
template class GridSprings<float>;

}  // namespace odeum::scene
