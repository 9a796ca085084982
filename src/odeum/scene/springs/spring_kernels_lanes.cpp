// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed and for wide vectors in every build type, and more than once where the build
// is not tuned for one processor: each time into a namespace of its own, see CMakeLists.txt.
#include <limits>

#include "odeum/scene/springs/lanes.hpp"
#include "odeum/scene/springs/spring_kernels.hpp"

#ifndef ODEUM_LANE_SET
#define ODEUM_LANE_SET target
#endif
#define ODEUM_TEXT_OF(name) #name
#define ODEUM_NAME_OF(name) ODEUM_TEXT_OF(name)

namespace odeum::scene {
namespace {

template <class Real>
std::size_t place(const SpringRows<Real>& springs, std::size_t row) {
  return (row + springs.margin) * springs.stride + springs.margin;
}

// std::sqrt is an inline function of the library, and which copy of it is kept is the linker's.
double root_of(double x) { return __builtin_sqrt(x); }
float root_of(float x) { return __builtin_sqrtf(x); }

// Calls visit(place, column, neighbours in reach, their number) for each vector of particles.
template <class Real, class Visit>
[[gnu::always_inline]] inline void gather(const SpringRows<Real>& springs, std::size_t begin,
                                          std::size_t end, Visit&& visit) {
  SpringNeighbour<Real> reached[16];
  for (std::size_t r = begin; r < end; ++r) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < springs.count; ++k) {
      const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(r) + springs.neighbours[k].row_offset;
      if (row >= 0 && row < static_cast<std::ptrdiff_t>(springs.rows))
        reached[count++] = springs.neighbours[k];
    }
    for (std::size_t c = 0; c < springs.columns; c += Lanes<Real>::count)
      visit(place(springs, r) + c, c, reached, reached + count);
  }
}

// With u the vector to a neighbour and l its length, the spring pulls with k (1 - L/l) u. A spring
// of no length has no direction: the bound under l^2 makes it exert no force instead of NaN.
template <bool damped, class Real>
void gather_forces(const SpringRows<Real>& springs, const Real* q, const Real* v, Real* force,
                   std::size_t begin, std::size_t end) {
  using V = Vector<Real>;
  const std::size_t n = springs.size;
  constexpr Real shortest = std::numeric_limits<Real>::min();
  gather(
      springs, begin, end,
      [&](std::size_t i, std::size_t c, const SpringNeighbour<Real>* near,
          const SpringNeighbour<Real>* end_near) {
        const V x = load(q + i), y = load(q + n + i), z = load(q + 2 * n + i);
        V fx{}, fy{}, fz{};
        [[maybe_unused]] V damping{};
        for (; near != end_near; ++near) {
          const Real* const qj = q + i + near->offset;
          [[maybe_unused]] const Real* const vj = v + i + near->offset;
          const V ux = load(qj) - x, uy = load(qj + n) - y, uz = load(qj + 2 * n) - z;
          const V inverse_length = inverse_sqrt<Real>(ux * ux + (uy * uy + (uz * uz + shortest)));
          const V mask = load(near->mask + c);
          const V elastic =
              larger<Real>(near->stiffness - near->stiffness_length * inverse_length, near->least) *
              mask;
          fx += elastic * ux;
          fy += elastic * uy;
          fz += elastic * uz;
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
void forces(const SpringRows<Real>& springs, const Real* q, const Real* v, Real* force,
            std::size_t begin, std::size_t end) {
  if (springs.damped)
    gather_forces<true>(springs, q, v, force, begin, end);
  else
    gather_forces<false>(springs, q, v, force, begin, end);
}

template <class Real>
void damping(const SpringRows<Real>& springs, const Real* v, Real* force, std::size_t begin,
             std::size_t end) {
  using V = Vector<Real>;
  const std::size_t n = springs.size;
  gather(springs, begin, end,
         [&](std::size_t i, std::size_t c, const SpringNeighbour<Real>* near,
             const SpringNeighbour<Real>* end_near) {
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

template <class Real>
void derivative(const SpringRows<Real>& springs, const Real* q, const Real* dq, const Real* dv,
                Real* change, std::size_t begin, std::size_t end) {
  using V = Vector<Real>;
  const std::size_t n = springs.size;
  gather(springs, begin, end,
         [&](std::size_t i, std::size_t c, const SpringNeighbour<Real>* near,
             const SpringNeighbour<Real>* end_near) {
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
void stiffness(const SpringRows<Real>& springs, std::size_t kind, const Real* q, bool clamped,
               Real* across, Real* s) {
  const std::size_t n = springs.size;
  const SpringNeighbour<Real>& near = springs.neighbours[2 * kind];  // seen from a
  const auto reach = static_cast<std::size_t>(near.row_offset);
  const std::size_t rows = springs.rows > reach ? springs.rows - reach : 0;
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < springs.columns; c += Lanes<Real>::count) {
      const std::size_t i = place(springs, r) + c;
      const Real* const qj = q + i + near.offset;
      const Stiffness<Real> k(load(qj) - load(q + i), load(qj + n) - load(q + n + i),
                              load(qj + 2 * n) - load(q + 2 * n + i), near.stiffness,
                              near.stiffness_length, near.least);
      const Vector<Real> mask = load(near.mask + c);
      Vector<Real> root = k.along * mask;
      for (std::size_t lane = 0; lane < Lanes<Real>::count; ++lane)
        root[lane] = root_of(root[lane]);
      store<Real>(
          across + i,
          larger<Real>(k.across, clamped ? Real(0) : std::numeric_limits<Real>::lowest()) * mask);
      store<Real>(s + i, root * k.nx);
      store<Real>(s + n + i, root * k.ny);
      store<Real>(s + 2 * n + i, root * k.nz);
    }
}

template <class Real>
constexpr SpringKernels<Real> kernels{ODEUM_NAME_OF(ODEUM_LANE_SET), &forces<Real>, &damping<Real>,
                                      &derivative<Real>, &stiffness<Real>};

}  // namespace

namespace ODEUM_LANE_SET {
extern const SpringKernelSet kernel_set;
const SpringKernelSet kernel_set{kernels<double>, kernels<float>};
}  // namespace ODEUM_LANE_SET

}  // namespace odeum::scene
