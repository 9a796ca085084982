// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed and for wide vectors in every build type, and more than once where the build
// is not tuned for one processor: each time into a namespace of its own, see CMakeLists.txt.
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

// Which springs the forces are of, chosen when the program is compiled.
struct SpringForm {
  bool damped, moderate;
};

// A spring whose end a is in the row at hand: its force on a goes to `kept`, by columns of a.
template <class Real>
struct StartingSpring {
  SpringNeighbour<Real> to;
  Real* kept;
};

// Where the forces of springs of a kind that start in a row are kept, three lines, until the row
// of their ends b is done.
template <class Real>
Real* kept_lines(const SpringRows<Real>& springs, std::size_t kind, std::size_t row) {
  const auto reach = static_cast<std::size_t>(springs.neighbours[2 * kind].row_offset);
  const std::size_t rows = reach < 2 ? reach + 1 : 4;  // a power of two
  return springs.kept + 3 * (4 * kind + (row & (rows - 1))) * springs.line;
}

// What springs do to their ends a in a row, which is kept for their ends b. With u the vector from
// a to b and l its length, a spring pulls with k (1 - L/l) u. One of no length has no direction:
// the bound under l^2 makes it exert no force instead of NaN.
template <SpringForm form, class Real>
void pull_ends_a(const SpringRows<Real>& springs, const Real* q, const Real* v, Real* force,
                 std::size_t row, const StartingSpring<Real>* begin,
                 const StartingSpring<Real>* end) {
  using V = Vector<Real>;
  const std::size_t n = springs.size, line = springs.line;
  for (std::size_t c = 0; c < springs.columns; c += Lanes<Real>::count) {
    const std::size_t i = place(springs, row) + c;
    const V x = load(q + i), y = load(q + n + i), z = load(q + 2 * n + i);
    [[maybe_unused]] V vx, vy, vz;
    if constexpr (form.damped) vx = load(v + i), vy = load(v + n + i), vz = load(v + 2 * n + i);
    V fx{}, fy{}, fz{};
    for (const StartingSpring<Real>* spring = begin; spring != end; ++spring) {
      const SpringNeighbour<Real>& to = spring->to;
      const Real* const qj = q + i + to.offset;
      const V ux = load(qj) - x, uy = load(qj + n) - y, uz = load(qj + 2 * n) - z;
      const V inverse_length = inverse_sqrt<Real, form.moderate>(
          ux * ux + (uy * uy + (uz * uz + least_square<Real, form.moderate>)));
      const V mask = load(to.mask + c);
      const V elastic =
          larger<Real>(to.stiffness - to.stiffness_length * inverse_length, to.least) * mask;
      V px = elastic * ux, py = elastic * uy, pz = elastic * uz;
      if constexpr (form.damped) {
        const Real* const vj = v + i + to.offset;
        const V d = to.damping * mask;
        px += d * (load(vj) - vx);
        py += d * (load(vj + n) - vy);
        pz += d * (load(vj + 2 * n) - vz);
      }
      fx += px, fy += py, fz += pz;
      store<Real>(spring->kept + c, px);
      store<Real>(spring->kept + line + c, py);
      store<Real>(spring->kept + 2 * line + c, pz);
    }
    if (!force) continue;
    store<Real>(force + i, fx);
    store<Real>(force + n + i, fy);
    store<Real>(force + 2 * n + i, fz);
  }
}

// Subtracts from a row's forces what was kept for the ends b there; with `scale`, what remains is
// multiplied by it, and `add` is added.
template <class Real>
void pull_ends_b(const SpringRows<Real>& springs, Real* force, std::size_t row,
                 const Real* const* begin, const Real* const* end) {
  using V = Vector<Real>;
  const std::size_t n = springs.size, line = springs.line;
  for (std::size_t c = 0; c < springs.columns; c += Lanes<Real>::count) {
    const std::size_t i = place(springs, row) + c;
    V f[3] = {load(force + i), load(force + n + i), load(force + 2 * n + i)};
    for (const Real* const* kept = begin; kept != end; ++kept)
      for (std::size_t d = 0; d < 3; ++d) f[d] -= load(*kept + d * line + c);
    for (std::size_t d = 0; d < 3; ++d) {
      if (springs.scale)
        f[d] = f[d] * load(springs.scale + d * n + i) + load(springs.add + d * n + i);
      store<Real>(force + d * n + i, f[d]);
    }
  }
}

// Every spring is computed once, at its end a, row after row. Of the rows before `begin` those that
// reach beyond it are computed anew, without their own sums: the bits do not depend on where a
// range of rows begins.
template <SpringForm form, class Real>
void row_forces(const SpringRows<Real>& springs, const Real* q, const Real* v, Real* force,
                std::size_t begin, std::size_t end) {
  const std::size_t kinds = springs.count / 2;
  for (std::size_t r = begin < 2 ? 0 : begin - 2; r < end; ++r) {
    StartingSpring<Real> starting[8];
    const Real* kept[8];
    std::size_t starts = 0, ends = 0;
    for (std::size_t k = 0; k < kinds; ++k) {
      const SpringNeighbour<Real>& to = springs.neighbours[2 * k];
      const auto reach = static_cast<std::size_t>(to.row_offset);
      if (r + reach < springs.rows && r + reach >= begin)
        starting[starts++] = {to, kept_lines(springs, k, r)};
      const std::ptrdiff_t columns =
          to.offset - to.row_offset * static_cast<std::ptrdiff_t>(springs.stride);
      if (r >= reach) kept[ends++] = kept_lines(springs, k, r - reach) - columns;
    }
    pull_ends_a<form>(springs, q, v, r < begin ? nullptr : force, r, starting, starting + starts);
    if (r >= begin) pull_ends_b(springs, force, r, kept, kept + ends);
  }
}

template <bool damped, class Real>
void forces_of(const SpringRows<Real>& springs, const Real* q, const Real* v, Real* force,
               std::size_t begin, std::size_t end) {
  if constexpr (guessed_as_float)
    if (springs.moderate)
      return row_forces<SpringForm{damped, true}>(springs, q, v, force, begin, end);
  row_forces<SpringForm{damped, false}>(springs, q, v, force, begin, end);
}

template <class Real>
void forces(const SpringRows<Real>& springs, const Real* q, const Real* v, Real* force,
            std::size_t begin, std::size_t end) {
  if (springs.damped)
    forces_of<true>(springs, q, v, force, begin, end);
  else
    forces_of<false>(springs, q, v, force, begin, end);
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
    constexpr Real shortest = least_square<Real, false>;
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
