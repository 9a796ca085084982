// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed and for wide vectors in every build type, see CMakeLists.txt.
#include "odeum/scene/springs/grid_matrix.hpp"

#include <algorithm>
#include <cmath>

#include "odeum/scene/springs/lanes.hpp"

namespace odeum::scene {
namespace {

using V = Vector<double>;

/// Calls visit(place) for each vector of particles.
template <class Visit>
void each_vector(const GridLayout& layout, Visit&& visit) {
  for (std::size_t r = 0; r < layout.rows; ++r)
    for (std::size_t c = 0; c < layout.columns; c += Lanes<double>::count) visit(layout.row(r) + c);
}

}  // namespace

GridMatrix::GridMatrix(const GridSprings<double>& springs, const double* mass,
                       const Surfaces* surfaces)
    : springs_(springs),
      layout_(springs.layout()),
      mass_(mass, mass + layout_.size),
      free_(layout_.size),
      cg_(3 * layout_.size) {
  for (std::size_t i = 0; i < layout_.size; ++i) free_[i] = mass_[i] != 0 ? 1 : 0;
  const std::vector<double> zeros(layout_.size);
  for (const SpringKind& kind : springs.kinds()) {
    Kind& added = kinds_.emplace_back();
    added.offset = layout_.offset(kind);
    added.damping = added.stiffness = zeros;
    added.components.resize(4 * layout_.size);
    layout_.each_spring(kind, [&](std::size_t i) { added.damping[i] = kind.damping; });
  }
  for (std::vector<double>& entry : inverse_) entry = zeros;
  if (surfaces) surfaces_.emplace(*surfaces);
}

void GridMatrix::assemble(const double* q, double g, bool clamped) {
  g_ = g;
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    Kind& kind = kinds_[k];
    double *const c = kind.components.data(), *const s = c + layout_.size;
    double* const stiffness = kind.stiffness.data();
    springs_.stiffness(k, q, clamped, stiffness, s);
    for (std::size_t i = 0; i < 3 * layout_.size; ++i) s[i] *= g;
    for (std::size_t i = 0; i < layout_.size; ++i) {
      stiffness[i] *= g * g;
      c[i] = stiffness[i] + g * kind.damping[i];
    }
  }
  if (surfaces_) {
    std::vector<double> places(3 * surfaces_->particles());
    layout_.gather(q, places.data());
    surfaces_->assemble(places.data(), clamped);
  }
  invert_diagonal();
}

// The inverse of a symmetric 3 x 3 matrix by its cofactors; that of a fixed particle is zero, which
// keeps it out of every direction of conjugate gradients.
void GridMatrix::invert_diagonal() {
  const std::size_t n = layout_.size;
  for (std::vector<double>& entry : inverse_) std::ranges::fill(entry, 0.0);
  if (surfaces_ && !surfaces_->empty()) {
    std::vector<std::array<double, 6>> blocks(surfaces_->particles());
    surfaces_->add_diagonal(-g_ * g_, blocks);
    for (std::size_t p = 0; p < blocks.size(); ++p)
      for (std::size_t e = 0; e < 6; ++e)
        inverse_[e][layout_.row(p / layout_.columns) + p % layout_.columns] = blocks[p][e];
  }
  each_vector(layout_, [&](std::size_t i) {
    const V free = load(free_.data() + i), alone = load(mass_.data() + i) + (1 - free);
    const auto added = [&](std::size_t entry) { return free * load(inverse_[entry].data() + i); };
    V xx = alone + added(0), yy = alone + added(3), zz = alone + added(5);
    V xy = added(1), xz = added(2), yz = added(4);
    for (const Kind& kind : kinds_)
      for (const std::size_t spring : {i, i - kind.offset}) {
        const double* const of = kind.components.data() + spring;
        const V c = load(of), sx = load(of + n), sy = load(of + 2 * n), sz = load(of + 3 * n);
        xx += c + sx * sx, yy += c + sy * sy, zz += c + sz * sz;
        xy += sx * sy, xz += sx * sz, yz += sy * sz;
      }
    const V ax = yy * zz - yz * yz, ay = xz * yz - xy * zz, az = xy * yz - xz * yy;
    const V scale = free / (xx * ax + xy * ay + xz * az);
    store<double>(inverse_[0].data() + i, scale * ax);
    store<double>(inverse_[1].data() + i, scale * ay);
    store<double>(inverse_[2].data() + i, scale * az);
    store<double>(inverse_[3].data() + i, scale * (xx * zz - xz * xz));
    store<double>(inverse_[4].data() + i, scale * (xy * xz - xx * yz));
    store<double>(inverse_[5].data() + i, scale * (xx * yy - xy * xy));
  });
}

void GridMatrix::precondition(const double* r, double* z) const {
  const std::size_t n = layout_.size;
  each_vector(layout_, [&](std::size_t i) {
    const V x = load(r + i), y = load(r + n + i), w = load(r + 2 * n + i);
    const V xy = load(inverse_[1].data() + i), xz = load(inverse_[2].data() + i),
            yz = load(inverse_[4].data() + i);
    store<double>(z + i, load(inverse_[0].data() + i) * x + xy * y + xz * w);
    store<double>(z + n + i, xy * x + load(inverse_[3].data() + i) * y + yz * w);
    store<double>(z + 2 * n + i, xz * x + yz * y + load(inverse_[5].data() + i) * w);
  });
}

// Sums up what the springs of a particle make of the difference x_i - x_j: all of A's share, or
// that of the stiffness alone.
template <bool whole>
void GridMatrix::spring_times(const double* x, double* product) const {
  const std::size_t n = layout_.size;
  each_vector(layout_, [&](std::size_t i) {
    const V xi = load(x + i), yi = load(x + n + i), zi = load(x + 2 * n + i);
    const V mass = whole ? load(mass_.data() + i) : V{};
    V px = mass * xi, py = mass * yi, pz = mass * zi;
    for (const Kind& kind : kinds_) {
      const auto add = [&](std::size_t spring, std::size_t j) {
        const V dx = xi - load(x + j), dy = yi - load(x + n + j), dz = zi - load(x + 2 * n + j);
        const double* const of = kind.components.data() + spring;
        const V sx = load(of + n), sy = load(of + 2 * n), sz = load(of + 3 * n);
        const V c = load(whole ? of : kind.stiffness.data() + spring);
        const V along = sx * dx + (sy * dy + sz * dz);
        px += c * dx, py += c * dy, pz += c * dz;
        px += along * sx, py += along * sy, pz += along * sz;
      };
      add(i, i + kind.offset);
      add(i - kind.offset, i - kind.offset);
    }
    const V free = load(free_.data() + i);
    store<double>(product + i, free * px);
    store<double>(product + n + i, free * py);
    store<double>(product + 2 * n + i, free * pz);
  });
}

void GridMatrix::multiply(const double* x, double* product) const {
  spring_times<true>(x, product);
  add_surfaces(x, -g_ * g_, product);
}

void GridMatrix::add_surfaces(const double* x, double factor, double* product) const {
  if (!surfaces_ || surfaces_->empty()) return;
  const std::size_t n = layout_.size, particles = surfaces_->particles();
  x_.resize(4 * particles);
  sum_.assign(4 * particles, 0);
  const auto each = [&](const auto& use) {
    for (std::size_t r = 0; r < layout_.rows; ++r)
      for (std::size_t c = 0; c < layout_.columns; ++c)
        use(4 * (r * layout_.columns + c), layout_.row(r) + c);
  };
  each([&](std::size_t quad, std::size_t i) {
    for (std::size_t d = 0; d < 3; ++d) x_[quad + d] = x[d * n + i];
  });
  surfaces_->add_product(x_, factor, sum_);
  each([&](std::size_t quad, std::size_t i) {
    for (std::size_t d = 0; d < 3; ++d) product[d * n + i] += free_[i] * sum_[quad + d];
  });
}

void GridMatrix::stiffness_times(const double* x, double* product) const {
  spring_times<false>(x, product);
  const double scale = -1 / g_;
  for (std::size_t i = 0; i < 3 * layout_.size; ++i) product[i] *= scale;
  add_surfaces(x, g_, product);
}

void GridMatrix::mass_times(const double* x, double* product) const {
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < layout_.size; ++i)
      product[d * layout_.size + i] = mass_[i] * x[d * layout_.size + i];
}

void GridMatrix::clear_free(double* x) const {
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < layout_.size; ++i) x[d * layout_.size + i] *= 1 - free_[i];
}

bool GridMatrix::solve(const double* b, double* x, double relative_tolerance) {
  return cg_.solve([this](const double* p, double* ap) { multiply(p, ap); },
                   [this](const double* r, double* z) { precondition(r, z); }, b, x,
                   relative_tolerance);
}

GridShiftedSolver::GridShiftedSolver(const GridSprings<double>& springs, const double* mass,
                                     const Surfaces* surfaces)
    : matrix_(springs, mass, surfaces),
      n_(3 * springs.layout().size),
      right_(n_),
      scratch_(n_),
      last_(n_) {}

bool GridShiftedSolver::factorise(double, const double* y, double gamma_h) {
  g_ = gamma_h;
  matrix_.assemble(y, g_, once_);
  return std::all_of(y, y + 2 * n_, [](double x) { return std::isfinite(x); });
}

bool GridShiftedSolver::solve(double* x, double relative) {
  double *const xq = x, *const xv = x + n_;
  matrix_.mass_times(xv, right_.data());
  if (g_ != 0) {
    matrix_.stiffness_times(xq, scratch_.data());
    for (std::size_t i = 0; i < n_; ++i) right_[i] += scratch_[i];
  }
  matrix_.clear_free(xv);
  std::copy_n(xv, n_, scratch_.data());
  if (once_)
    for (std::size_t i = 0; i < n_; ++i) xv[i] += last_[i];
  if (!matrix_.solve(right_.data(), xv, relative)) return false;
  for (std::size_t i = 0; i < n_; ++i) last_[i] = xv[i] - scratch_[i];
  for (std::size_t i = 0; i < n_; ++i) xq[i] += g_ * xv[i];
  return true;
}

}  // namespace odeum::scene
