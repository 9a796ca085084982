// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed and for wide vectors in every build type, see CMakeLists.txt.
#include "odeum/scene/springs/imex_cloth.hpp"

#include <cmath>
#include <stdexcept>

#include "odeum/scene/springs/row_threads.hpp"

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
    : state_(scene, grid),
      springs_(state_.layout, undamped(grid.kinds)),
      dampers_(state_.layout, grid.kinds),
      threads_(threads),
      damping_(3 * state_.layout.size) {
  if (threads == 0) throw std::invalid_argument("a cloth needs a thread to be stepped on");
  for (const SpringKind& kind : grid.kinds)
    state_.layout.each_spring(kind, [&](std::size_t i) {
      for (std::size_t d = 0; d < 3; ++d)
        for (const std::size_t end : {i, i + state_.layout.offset(kind)})
          damping_[d * state_.layout.size + end] += static_cast<Real>(kind.damping);
    });
}

template <class Real>
void ImexCloth<Real>::step(double h, std::size_t steps, double relative) {
  const std::size_t n = state_.q.size();
  Arrays acceleration(n), zero(n), residual(n), change[2] = {zero, zero}, damped(n), inverse(n);
  on_rows(
      state_.layout.rows, threads_,
      [&](std::size_t begin, std::size_t end, const std::function<void()>& wait) {
        Real *const q = state_.q.data(), *const v = state_.v.data(), *const a = acceleration.data();
        const auto each_row = [&](auto&& work) {
          for (std::size_t r = begin; r < end; ++r) work(r);
        };
        const auto accelerate = [&](std::size_t r) {
          springs_.forces(q, zero.data(), a, r, r + 1);
          const Real *const m = state_.inverse_mass.data(), *const g = state_.gravity.data();
          state_.each(r, [=](std::size_t i) { a[i] = a[i] * m[i] + g[i]; });
        };

        // v += x with (M - step/2 D) x = step D v, by Chebyshev's iteration on the spectrum
        // [middle - half, middle + half] of Jacobi's matrix (Saad, algorithm 12.1).
        const auto damp = [&](double length) {
          const Real step = static_cast<Real>(length);
          const Real *const m = state_.mass.data(), *const d = damping_.data(),
                            *const free = state_.inverse_mass.data();
          Real *const r = residual.data(), *const w = damped.data(), *const inv = inverse.data();
          const double low = lowest_eigenvalue(length), middle = 1, half = 1 - low;
          const int rounds = chebyshev_rounds(low, 2 - low, relative);
          wait();  // for all velocities
          each_row([&](std::size_t row) {
            dampers_.damping(v, r, row, row + 1);
            Real* const x = change[0].data();
            state_.each(row, [=](std::size_t i) {
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
              state_.each(row, [=](std::size_t i) { v[i] += x[i]; });
              if (last) return;
              dampers_.damping(x, w, row, row + 1);
              state_.each(row, [=](std::size_t i) {
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
            state_.each(row, [=](std::size_t i) {
              v[i] += half * a[i];
              q[i] += full * v[i];
            });
          });
          wait();
          each_row([&](std::size_t row) {
            accelerate(row);
            state_.each(row, [=](std::size_t i) { v[i] += half * a[i]; });
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
  for (std::size_t i = 0; i < state_.layout.size; ++i)
    if (state_.mass[i] != 0) {
      const auto m = static_cast<double>(state_.mass[i]);
      low = std::min(low, m / (m + step / 2 * static_cast<double>(damping_[i])));
    }
  return low;
}

template class ImexCloth<double>;
template class ImexCloth<float>;

}  // namespace odeum::scene
