// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed and for wide vectors in every build type, see CMakeLists.txt.
#include "odeum/scene/spring_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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
  for (const SpringKind& kind : kinds) {
    damped_ = damped_ || kind.damping != 0;
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
template <bool damped>
void GridSprings<Real>::gather_forces(const Real* q, const Real* v, Real* force, std::size_t begin,
                                      std::size_t end) const {
  using V = Vector<Real>;
  const std::size_t n = layout_.size;
  constexpr Real shortest = std::numeric_limits<Real>::min();
  gather(begin, end,
         [&](std::size_t i, std::size_t c, const Neighbour* near, const Neighbour* end_near) {
           const V x = load(q + i), y = load(q + n + i), z = load(q + 2 * n + i);
           V fx{}, fy{}, fz{};
           [[maybe_unused]] V damping{};
           for (; near != end_near; ++near) {
             const Real* const qj = q + i + near->offset;
             [[maybe_unused]] const Real* const vj = v + i + near->offset;
             const V ux = load(qj) - x, uy = load(qj + n) - y, uz = load(qj + 2 * n) - z;
             const V inverse_length =
                 inverse_sqrt<Real>(ux * ux + (uy * uy + (uz * uz + shortest)));
             const V mask = load(near->mask + c);
             const V pull = larger<Real>(near->stiffness - near->stiffness_length * inverse_length,
                                         near->least) *
                            mask;
             fx += pull * ux;
             fy += pull * uy;
             fz += pull * uz;
             if constexpr (damped) {
               const V d = near->damping * mask;
               damping += d;
               fx += d * load(vj);
               fy += d * load(vj + n);
               fz += d * load(vj + 2 * n);
             }
           }
           if constexpr (damped) {
             fx -= damping * load(v + i);
             fy -= damping * load(v + n + i);
             fz -= damping * load(v + 2 * n + i);
           }
           store<Real>(force + i, fx);
           store<Real>(force + n + i, fy);
           store<Real>(force + 2 * n + i, fz);
         });
}

template <class Real>
void GridSprings<Real>::forces(const Real* q, const Real* v, Real* force, std::size_t begin,
                               std::size_t end) const {
  if (damped_)
    gather_forces<true>(q, v, force, begin, end);
  else
    gather_forces<false>(q, v, force, begin, end);
}

template <class Real>
void GridSprings<Real>::damping(const Real* v, Real* force, std::size_t begin,
                                std::size_t end) const {
  using V = Vector<Real>;
  const std::size_t n = layout_.size;
  gather(begin, end,
         [&](std::size_t i, std::size_t c, const Neighbour* near, const Neighbour* end_near) {
           V x{}, y{}, z{}, total{};
           for (; near != end_near; ++near) {
             const Real* const vj = v + i + near->offset;
             const V d = near->damping * load(near->mask + c);
             total += d;
             x += d * load(vj);
             y += d * load(vj + n);
             z += d * load(vj + 2 * n);
           }
           store<Real>(force + i, x - total * load(v + i));
           store<Real>(force + n + i, y - total * load(v + n + i));
           store<Real>(force + 2 * n + i, z - total * load(v + 2 * n + i));
         });
}

namespace {

/// The derivative of k (1 - L/l) u: across w + along n (n . w) in the direction w, where n is the
/// direction of u. Nothing of slack springs, nor of those of no length.
template <class Real>
struct Stiffness {
  Vector<Real> nx, ny, nz, across, along;

  [[gnu::always_inline]] Stiffness(Vector<Real> ux, Vector<Real> uy, Vector<Real> uz,
                                   Real stiffness, Real stiffness_length, Real least) {
    constexpr Real shortest = std::numeric_limits<Real>::min();
    const Vector<Real> squared = ux * ux + (uy * uy + (uz * uz + shortest));
    const Vector<Real> inverse_length = inverse_sqrt<Real>(squared);
    nx = ux * inverse_length, ny = uy * inverse_length, nz = uz * inverse_length;
    along = stiffness_length * inverse_length;
    across = stiffness - along;
    const auto none = (across < least) | (squared <= shortest);
    along = none ? Vector<Real>{} : along;
    across = none ? Vector<Real>{} : across;
  }
};

}  // namespace

template <class Real>
void GridSprings<Real>::derivative(const Real* q, const Real* dq, const Real* dv, Real* change,
                                   std::size_t begin, std::size_t end) const {
  using V = Vector<Real>;
  const std::size_t n = layout_.size;
  gather(begin, end,
         [&](std::size_t i, std::size_t c, const Neighbour* near, const Neighbour* end_near) {
           const V x = load(q + i), y = load(q + n + i), z = load(q + 2 * n + i);
           const V dx = load(dq + i), dy = load(dq + n + i), dz = load(dq + 2 * n + i);
           V fx{}, fy{}, fz{}, damping{};
           for (; near != end_near; ++near) {
             const Real* const qj = q + i + near->offset;
             const Real* const dqj = dq + i + near->offset;
             const Real* const dvj = dv + i + near->offset;
             const Stiffness<Real> k(load(qj) - x, load(qj + n) - y, load(qj + 2 * n) - z,
                                     near->stiffness, near->stiffness_length, near->least);
             const V wx = load(dqj) - dx, wy = load(dqj + n) - dy, wz = load(dqj + 2 * n) - dz;
             const V mask = load(near->mask + c);
             const V along = k.along * (k.nx * wx + k.ny * wy + k.nz * wz) * mask;
             const V across = k.across * mask;
             const V d = near->damping * mask;
             damping += d;
             fx += across * wx;
             fx += along * k.nx;
             fx += d * load(dvj);
             fy += across * wy;
             fy += along * k.ny;
             fy += d * load(dvj + n);
             fz += across * wz;
             fz += along * k.nz;
             fz += d * load(dvj + 2 * n);
           }
           store<Real>(change + i, fx - damping * load(dv + i));
           store<Real>(change + n + i, fy - damping * load(dv + n + i));
           store<Real>(change + 2 * n + i, fz - damping * load(dv + 2 * n + i));
         });
}

template <class Real>
void GridSprings<Real>::stiffness(std::size_t kind, const Real* q, bool clamped, Real* across,
                                  Real* s) const {
  const std::size_t n = layout_.size;
  const Neighbour& near = neighbours_[2 * kind];  // seen from a
  const auto rows =
      layout_.rows - std::min(layout_.rows, static_cast<std::size_t>(near.row_offset));
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < layout_.columns; c += Lanes<Real>::count) {
      const std::size_t i = layout_.row(r) + c;
      const Real* const qj = q + i + near.offset;
      const Stiffness<Real> k(load(qj) - load(q + i), load(qj + n) - load(q + n + i),
                              load(qj + 2 * n) - load(q + 2 * n + i), near.stiffness,
                              near.stiffness_length, near.least);
      const Vector<Real> mask = load(near.mask + c);
      Vector<Real> root = k.along * mask;
      for (std::size_t lane = 0; lane < Lanes<Real>::count; ++lane)
        root[lane] = std::sqrt(root[lane]);
      store<Real>(
          across + i,
          larger<Real>(k.across, clamped ? Real(0) : std::numeric_limits<Real>::lowest()) * mask);
      store<Real>(s + i, root * k.nx);
      store<Real>(s + n + i, root * k.ny);
      store<Real>(s + 2 * n + i, root * k.nz);
    }
}

template class GridSprings<double>;
template class GridSprings<float>;

}  // namespace odeum::scene
