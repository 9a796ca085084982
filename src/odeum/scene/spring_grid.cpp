// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed and for wide vectors in every build type, see CMakeLists.txt.
#include "odeum/scene/spring_grid.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "odeum/scene/lanes.hpp"

namespace odeum::scene {

GridLayout::GridLayout(std::size_t rows_, std::size_t columns_) : rows(rows_), columns(columns_) {
  // A row may be read and written in whole vectors, of 16 numbers at most, from any neighbour.
  constexpr std::size_t widest = 16;
  stride = margin + (columns + widest - 1) / widest * widest + margin;
  size = (rows + 2 * margin) * stride + widest;
}

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
  for (const SpringKind& kind : kinds)
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

// Calls visit(place, column, neighbours in reach, their number) for each vector of particles.
template <class Real>
template <class Visit>
void GridSprings<Real>::gather(std::size_t begin, std::size_t end, Visit&& visit) const {
  std::array<Neighbour, 16> reached;
  for (std::size_t r = begin; r < end; ++r) {
    std::size_t count = 0;
    for (const Neighbour& n : neighbours_) {
      const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(r) + n.row_offset;
      if (row >= 0 && row < static_cast<std::ptrdiff_t>(layout_.rows)) reached[count++] = n;
    }
    for (std::size_t c = 0; c < layout_.columns; c += Lanes<Real>::count)
      visit(layout_.row(r) + c, c, reached.data(), reached.data() + count);
  }
}

// With u the vector to a neighbour and l its length, the spring pulls with k (1 - L/l) u. A spring
// of no length has no direction: the bound under l^2 makes it exert no force instead of NaN.
template <class Real>
void GridSprings<Real>::forces(const Real* q, const Real* v, Real* force, std::size_t begin,
                               std::size_t end) const {
  using V = Vector<Real>;
  const std::size_t n = layout_.size;
  constexpr Real shortest = std::numeric_limits<Real>::min();
  gather(begin, end,
         [&](std::size_t i, std::size_t c, const Neighbour* near, const Neighbour* end_near) {
           const V x = load(q + i), y = load(q + n + i), z = load(q + 2 * n + i);
           V fx{}, fy{}, fz{}, damping{};
           for (; near != end_near; ++near) {
             const Real* const qj = q + i + near->offset;
             const Real* const vj = v + i + near->offset;
             const V ux = load(qj) - x, uy = load(qj + n) - y, uz = load(qj + 2 * n) - z;
             const V inverse_length =
                 inverse_sqrt<Real>(ux * ux + (uy * uy + (uz * uz + shortest)));
             const V mask = load(near->mask + c);
             const V pull = larger<Real>(near->stiffness - near->stiffness_length * inverse_length,
                                         near->least) *
                            mask;
             const V d = near->damping * mask;
             damping += d;
             fx += pull * ux;
             fx += d * load(vj);
             fy += pull * uy;
             fy += d * load(vj + n);
             fz += pull * uz;
             fz += d * load(vj + 2 * n);
           }
           store<Real>(force + i, fx - damping * load(v + i));
           store<Real>(force + n + i, fy - damping * load(v + n + i));
           store<Real>(force + 2 * n + i, fz - damping * load(v + 2 * n + i));
         });
}

// The derivative of k (1 - L/l) u in the direction w is k (1 - L/l) w + k L/l^3 (u . w) u.
template <class Real>
void GridSprings<Real>::derivative(const Real* q, const Real* dq, const Real* dv, Real* change,
                                   std::size_t begin, std::size_t end) const {
  using V = Vector<Real>;
  const std::size_t n = layout_.size;
  constexpr Real shortest = std::numeric_limits<Real>::min();
  gather(begin, end,
         [&](std::size_t i, std::size_t c, const Neighbour* near, const Neighbour* end_near) {
           const V x = load(q + i), y = load(q + n + i), z = load(q + 2 * n + i);
           const V dx = load(dq + i), dy = load(dq + n + i), dz = load(dq + 2 * n + i);
           V fx{}, fy{}, fz{}, damping{};
           for (; near != end_near; ++near) {
             const Real* const qj = q + i + near->offset;
             const Real* const dqj = dq + i + near->offset;
             const Real* const dvj = dv + i + near->offset;
             V ux = load(qj) - x, uy = load(qj + n) - y, uz = load(qj + 2 * n) - z;
             const V wx = load(dqj) - dx, wy = load(dqj + n) - dy, wz = load(dqj + 2 * n) - dz;
             const V inverse_length =
                 inverse_sqrt<Real>(ux * ux + (uy * uy + (uz * uz + shortest)));
             const V mask = load(near->mask + c);
             const V shrunk = near->stiffness_length * inverse_length;
             const V pull = near->stiffness - shrunk;
             ux *= inverse_length, uy *= inverse_length, uz *= inverse_length;
             V along = shrunk * (ux * wx + uy * wy + uz * wz) * mask;
             V across = larger<Real>(pull, near->least) * mask;
             along = pull < near->least ? V{} : along;
             const V d = near->damping * mask;
             damping += d;
             fx += across * wx;
             fx += along * ux;
             fx += d * load(dvj);
             fy += across * wy;
             fy += along * uy;
             fy += d * load(dvj + n);
             fz += across * wz;
             fz += along * uz;
             fz += d * load(dvj + 2 * n);
           }
           store<Real>(change + i, fx - damping * load(dv + i));
           store<Real>(change + n + i, fy - damping * load(dv + n + i));
           store<Real>(change + 2 * n + i, fz - damping * load(dv + 2 * n + i));
         });
}

template class GridSprings<double>;
template class GridSprings<float>;

}  // namespace odeum::scene
