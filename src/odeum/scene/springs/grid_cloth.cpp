// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed and for wide vectors in every build type, see CMakeLists.txt.
#include "odeum/scene/springs/grid_cloth.hpp"

#include <algorithm>
#include <cmath>

#include "odeum/scene/springs/grid_matrix.hpp"

namespace odeum::scene {
namespace {

/// The rounds of Chebyshev's iteration on a spectrum in [low, high] that reduce an error to
/// `relative` of it (Saad, Iterative Methods for Sparse Linear Systems, section 12.3).
int chebyshev_rounds(double low, double high, double relative) {
  const double root = std::sqrt(high / low), rate = (root - 1) / (root + 1);
  return rate > 0 ? static_cast<int>(std::ceil(std::log(relative / 2) / std::log(rate))) + 1 : 1;
}

}  // namespace

template <class Real>
GridCloth<Real>::GridCloth(const Scene& scene, std::size_t threads)
    : GridCloth(scene, require_grid(scene), threads) {}

template <class Real>
GridCloth<Real>::GridCloth(const Scene& scene, const GridStructure& grid, std::size_t threads)
    : springs_(GridLayout(grid.rows, grid.columns), grid.kinds),
      mass_(by_place(scene, [](const Particle& p, std::size_t) { return p.fixed ? 0 : p.mass; })),
      inverse_mass_(
          by_place(scene, [](const Particle& p, std::size_t) { return p.fixed ? 0 : 1 / p.mass; })),
      gravity_(by_place(
          scene, [&](const Particle& p, std::size_t d) { return p.fixed ? 0 : scene.gravity[d]; })),
      damping_(size() / 2),
      team_(std::make_unique<Team>(std::min(grid.rows, threads))) {
  for (const SpringKind& kind : grid.kinds)
    layout().each_spring(kind, [&](std::size_t i) {
      for (std::size_t d = 0; d < 3; ++d)
        for (const std::size_t end : {i, i + layout().offset(kind)})
          damping_[d * layout().size + end] += static_cast<Real>(kind.damping);
    });
}

template <class Real>
template <class Of>
std::vector<Real> GridCloth<Real>::by_place(const Scene& scene, Of&& of) const {
  std::vector<double> numbers;
  for (const Particle& particle : scene.particles)
    for (std::size_t d = 0; d < 3; ++d) numbers.push_back(of(particle, d));
  std::vector<Real> arrays(size() / 2);
  layout().scatter(numbers.data(), arrays.data());
  return arrays;
}

template <class Real>
template <class Update>
void GridCloth<Real>::each(std::size_t row, Update&& update) const {
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t begin = d * layout().size + layout().row(row), end = begin + layout().columns;
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) update(i);
  }
}

template <class Real>
std::vector<Real> GridCloth<Real>::scattered(const std::vector<double>& y) const {
  std::vector<Real> state(size());
  layout().scatter(y.data(), state.data());
  layout().scatter(y.data() + y.size() / 2, state.data() + size() / 2);
  return state;
}

template <class Real>
std::vector<double> GridCloth<Real>::gathered(const std::vector<Real>& state) const {
  std::vector<double> y(6 * particles());
  layout().gather(state.data(), y.data());
  layout().gather(state.data() + size() / 2, y.data() + y.size() / 2);
  return y;
}

template <class Real>
void GridCloth<Real>::acceleration(Real, const Real* q, const Real* v, Real* a) const {
  team_->run(layout().rows, [&](std::size_t begin, std::size_t end) {
    springs_.forces(q, v, a, begin, end, inverse_mass_.data(), gravity_.data());
  });
}

// v += x with (M - h/2 D) x = h D v. The iteration's spectrum is that of Jacobi's matrix: its
// smallest eigenvalue is at least that of a motion of the whole, m / (m + h/2 d), and its largest
// is as far above 1 as that is below, since the row sums of -D are twice its diagonal (Saad,
// algorithm 12.1).
template <class Real>
std::uint64_t GridCloth<Real>::damp(Real, const Real*, Real h, Real* v, double relative) const {
  const Real half_h = h / 2;
  const Real *const m = mass_.data(), *const d = damping_.data();
  double low = 1;
  for (std::size_t i = 0; i < layout().size; ++i)
    if (m[i] != 0) low = std::min(low, static_cast<double>(m[i] / (m[i] + half_h * d[i])));
  const double half_width = 1 - low;
  const int rounds = chebyshev_rounds(low, 2 - low, relative);

  const std::size_t n = size() / 2;
  thread_local std::vector<Real> space;  // one for each thread: threads share the problem
  space.assign(5 * n, Real(0));
  Real *const r = space.data(), *const w = r + n, *const inverse = w + n, *x = inverse + n,
              *next = x + n;
  const auto on_rows = [&](auto&& work) {
    team_->run(layout().rows, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row) work(row);
    });
  };
  on_rows([&, x](std::size_t row) {
    springs_.damping(v, r, row, row + 1);
    each(row, [=](std::size_t i) {
      inverse[i] = m[i] != 0 ? 1 / (m[i] + half_h * d[i]) : 0;
      r[i] *= h;
      x[i] = inverse[i] * r[i];
    });
  });
  double rho = half_width;
  for (int round = 1; round < rounds; ++round) {
    const double factor = half_width > 0 ? 1 / (2 / half_width - rho) : 0;
    const Real keep = static_cast<Real>(factor * rho),
               add = static_cast<Real>(half_width > 0 ? 2 * factor / half_width : 0);
    on_rows([&, x, next](std::size_t row) {
      springs_.damping(x, w, row, row + 1);
      each(row, [=](std::size_t i) {
        v[i] += x[i];
        r[i] -= m[i] * x[i] - half_h * w[i];
        next[i] = keep * x[i] + add * inverse[i] * r[i];
      });
    });
    std::swap(x, next);
    rho = factor;
  }
  on_rows([&, x](std::size_t row) { each(row, [=](std::size_t i) { v[i] += x[i]; }); });
  return static_cast<std::uint64_t>(rounds);
}

template <class Real>
std::unique_ptr<ShiftedSolver> GridCloth<Real>::shifted_solver()
    const requires std::same_as<Real, double> {
  for (const SpringKind& kind : springs_.kinds())
    if (kind.stiffness * kind.rest_length < 0) return nullptr;
  // Clang before 16 instantiates this for float too.
  if constexpr (std::same_as<Real, double>)
    return std::make_unique<GridShiftedSolver>(springs_, mass_.data());
  return nullptr;
}

template class GridCloth<double>;
template class GridCloth<float>;

}  // namespace odeum::scene
