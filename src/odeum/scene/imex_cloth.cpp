// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed and for wide vectors in every build type, see CMakeLists.txt.
#include "odeum/scene/imex_cloth.hpp"

#include <cmath>
#include <stdexcept>

#include "odeum/scene/row_threads.hpp"

namespace odeum::scene {
namespace {

std::vector<SpringKind> undamped(std::vector<SpringKind> kinds) {
  for (SpringKind& kind : kinds) kind.damping = 0;
  return kinds;
}

/// The rounds of Chebyshev's iteration on a spectrum in [low, high] that bring an error down to
/// `relative` (Saad, Iterative Methods for Sparse Linear Systems, section 12.3).
int chebyshev_rounds(double low, double high, double relative) {
  const double root = std::sqrt(high / low), rate = (root - 1) / (root + 1);
  return rate > 0 ? static_cast<int>(std::ceil(std::log(relative / 2) / std::log(rate))) + 1 : 1;
}

}  // namespace

template <class Real>
ImexCloth<Real>::ImexCloth(const Scene& scene, std::size_t threads)
    : ImexCloth(scene, require_grid(scene), threads) {}

template <class Real>
ImexCloth<Real>::ImexCloth(const Scene& scene, const GridStructure& grid, std::size_t threads)
    : layout_(grid.rows, grid.columns),
      springs_(layout_, undamped(grid.kinds)),
      dampers_(layout_, grid.kinds),
      threads_(threads),
      mass_(3 * layout_.size),
      inverse_mass_(mass_),
      gravity_(mass_),
      damping_(mass_),
      q_(mass_),
      v_(mass_) {
  if (threads == 0) throw std::invalid_argument("a cloth needs a thread to be stepped on");
  std::vector<double> q, v, mass, inverse_mass, gravity;
  for (const Particle& particle : scene.particles)
    for (std::size_t d = 0; d < 3; ++d) {
      q.push_back(particle.position[d]);
      v.push_back(particle.velocity[d]);
      mass.push_back(particle.fixed ? 0 : particle.mass);
      inverse_mass.push_back(particle.fixed ? 0 : 1 / particle.mass);
      gravity.push_back(particle.fixed ? 0 : scene.gravity[d]);
    }
  layout_.scatter(q.data(), q_.data());
  layout_.scatter(v.data(), v_.data());
  layout_.scatter(mass.data(), mass_.data());
  layout_.scatter(inverse_mass.data(), inverse_mass_.data());
  layout_.scatter(gravity.data(), gravity_.data());
  for (const SpringKind& kind : grid.kinds)
    layout_.each_spring(kind, [&](std::size_t i) {
      for (std::size_t d = 0; d < 3; ++d)
        for (const std::size_t end : {i, i + layout_.offset(kind)})
          damping_[d * layout_.size + end] += static_cast<Real>(kind.damping);
    });
}

template <class Real>
void ImexCloth<Real>::read(double* y) const {
  layout_.gather(q_.data(), y);
  layout_.gather(v_.data(), y + 3 * layout_.rows * layout_.columns);
}

template <class Real>
void ImexCloth<Real>::step(double h, std::size_t steps, double relative) {
  const std::size_t n = q_.size();
  Arrays acceleration(n), zero(n), residual(n), change[2] = {zero, zero}, damped(n), inverse(n);
  on_rows(
      layout_.rows, threads_,
      [&](std::size_t begin, std::size_t end, const std::function<void()>& wait) {
        Real *const q = q_.data(), *const v = v_.data(), *const a = acceleration.data();
        const auto each_row = [&](auto&& work) {
          for (std::size_t r = begin; r < end; ++r) work(r);
        };
        const auto accelerate = [&](std::size_t r) {
          springs_.forces(q, zero.data(), a, r, r + 1);
          const Real *const m = inverse_mass_.data(), *const g = gravity_.data();
          each(r, [=](std::size_t i) { a[i] = a[i] * m[i] + g[i]; });
        };

        // v += x with (M - step/2 D) x = step D v, by Chebyshev's iteration on the spectrum
        // [middle - half, middle + half] of Jacobi's matrix (Saad, algorithm 12.1).
        const auto damp = [&](double length) {
          const Real step = static_cast<Real>(length);
          const Real *const m = mass_.data(), *const d = damping_.data(),
                            *const free = inverse_mass_.data();
          Real *const r = residual.data(), *const w = damped.data(), *const inv = inverse.data();
          const double low = lowest_eigenvalue(length), middle = 1, half = 1 - low;
          const int rounds = chebyshev_rounds(low, 2 - low, relative);
          wait();  // for all velocities
          each_row([&](std::size_t row) {
            dampers_.damping(v, r, row, row + 1);
            Real* const x = change[0].data();
            each(row, [=](std::size_t i) {
              inv[i] = free[i] != 0 ? 1 / (m[i] + step / 2 * d[i]) : 0;
              r[i] *= step;
              x[i] = inv[i] * r[i];
            });
          });
          double rho = half / middle;
          for (int round = 0; round < rounds; ++round) {
            wait();
            const Real* const x = change[round % 2].data();
            Real* const next = change[(round + 1) % 2].data();
            const double factor = half > 0 ? 1 / (2 * middle / half - rho) : 0;
            const Real keep = static_cast<Real>(factor * rho),
                       add = static_cast<Real>(half > 0 ? 2 * factor / half : 0);
            const bool last = round + 1 == rounds;
            each_row([&](std::size_t row) {
              each(row, [=](std::size_t i) { v[i] += x[i]; });
              if (last) return;
              dampers_.damping(x, w, row, row + 1);
              each(row, [=](std::size_t i) {
                r[i] -= m[i] * x[i] - step / 2 * w[i];
                next[i] = keep * x[i] + add * inv[i] * r[i];
              });
            });
            rho = factor;
          }
        };

        const Real full = static_cast<Real>(h), half = full / 2;
        damp(h / 2);
        each_row(accelerate);
        for (std::size_t k = 0; k < steps; ++k) {
          wait();  // for all who still read the positions
          each_row([&](std::size_t row) {
            each(row, [=](std::size_t i) {
              v[i] += half * a[i];
              q[i] += full * v[i];
            });
          });
          wait();
          each_row([&](std::size_t row) {
            accelerate(row);
            each(row, [=](std::size_t i) { v[i] += half * a[i]; });
          });
          damp(k + 1 < steps ? h : h / 2);
        }
      });
}

// Of Jacobi's matrix: at least that of a cloth that moves as one, m / (m + step/2 d). The largest
// is as far above 1 as this is below, since the dampers' row sums are twice their diagonal.
template <class Real>
double ImexCloth<Real>::lowest_eigenvalue(double step) const {
  double low = 1;
  for (std::size_t i = 0; i < layout_.size; ++i)
    if (mass_[i] != 0) {
      const auto m = static_cast<double>(mass_[i]);
      low = std::min(low, m / (m + step / 2 * static_cast<double>(damping_[i])));
    }
  return low;
}

template <class Real>
template <class Update>
void ImexCloth<Real>::each(std::size_t row, Update&& update) const {
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t begin = d * layout_.size + layout_.row(row), end = begin + layout_.columns;
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) update(i);
  }
}

template class ImexCloth<double>;
template class ImexCloth<float>;

}  // namespace odeum::scene
