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
  const double root = std::sqrt(high / low);
  const double rate = (root - 1) / (root + 1);
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
}

template <class Real>
void ImexCloth<Real>::read(double* y) const {
  layout_.gather(q_.data(), y);
  layout_.gather(v_.data(), y + 3 * layout_.rows * layout_.columns);
}

template <class Real>
void ImexCloth<Real>::step(double h, std::size_t steps, double relative) {
  const std::size_t n = q_.size();
  Arrays acceleration(n), zero(n), residual(n), direction(n), product(n), inverse_diagonal(n);
  // Jacobi's eigenvalues: from those of a cloth that moves as one, to twice those of one particle.
  const auto spectrum = [&](double step) {
    double low = 1;
    for (std::size_t i = 0; i < layout_.size; ++i)
      if (mass_[i] != 0) {
        const double m = static_cast<double>(mass_[i]);
        low = std::min(low, m / (m + step / 2 * static_cast<double>(dampers_.total()[i])));
      }
    return std::pair{low, 2 - low};
  };

  on_rows(layout_.rows, threads_,
          [&](std::size_t begin, std::size_t end, const std::function<void()>& wait) {
            Real *const q = q_.data(), *const v = v_.data(), *const a = acceleration.data();
            const auto rows = [&](auto&& update) {
              for (std::size_t r = begin; r < end; ++r)
                for (std::size_t d = 0; d < 3; ++d) {
                  const std::size_t first = d * layout_.size + layout_.row(r);
#pragma GCC ivdep
                  for (std::size_t i = first; i < first + layout_.columns; ++i) update(i);
                }
            };
            const auto accelerate = [&] {
              springs_.forces(q, zero.data(), a, begin, end);
              const Real *const m = inverse_mass_.data(), *const g = gravity_.data();
              rows([=](std::size_t i) { a[i] = a[i] * m[i] + g[i]; });
            };
            // v += x, where (M - step/2 D) x = step D v.
            const auto damp = [&](double step_length) {
              const Real step = static_cast<Real>(step_length), half = step / 2;
              const auto [low, high] = spectrum(step_length);
              const Real *const m = mass_.data(), *const total = dampers_.total().data(),
                                *const free = inverse_mass_.data();
              Real *const r = residual.data(), *const p = direction.data(),
                          *const w = product.data(), *const inverse = inverse_diagonal.data();
              rows([=, size = layout_.size](std::size_t i) {
                inverse[i] = free[i] != 0 ? 1 / (m[i] + half * total[i % size]) : 0;
              });
              wait();  // for all velocities
              dampers_.times(v, r, begin, end);
              // Saad's algorithm 12.1, preconditioned: theta is the middle, delta half the width.
              const double theta = (high + low) / 2, delta = (high - low) / 2,
                           sigma = theta / delta;
              double rho = 1 / sigma;
              rows([=, scale = static_cast<Real>(1 / theta)](std::size_t i) {
                r[i] *= step;
                p[i] = scale * inverse[i] * r[i];
              });
              const int rounds = low < 1 ? chebyshev_rounds(low, high, relative) : 1;
              for (int round = 0; round < rounds; ++round) {
                wait();
                rows([=](std::size_t i) { v[i] += p[i]; });
                if (round + 1 == rounds) break;
                dampers_.times(p, w, begin, end);
                wait();  // before p changes under a neighbour
                const double next = 1 / (2 * sigma - rho);
                const Real keep = static_cast<Real>(next * rho),
                           add = static_cast<Real>(2 * next / delta);
                rows([=](std::size_t i) {
                  r[i] -= m[i] * p[i] - half * w[i];
                  p[i] = keep * p[i] + add * inverse[i] * r[i];
                });
                rho = next;
              }
            };
            const Real full = static_cast<Real>(h), half = full / 2;
            damp(h / 2);
            accelerate();
            for (std::size_t step = 0; step < steps; ++step) {
              rows([=](std::size_t i) { v[i] += half * a[i]; });
              wait();  // for all who still read the positions
              rows([=](std::size_t i) { q[i] += full * v[i]; });
              wait();
              accelerate();
              rows([=](std::size_t i) { v[i] += half * a[i]; });
              damp(step + 1 < steps ? h : h / 2);
            }
          });
}

template class ImexCloth<double>;
template class ImexCloth<float>;

}  // namespace odeum::scene
