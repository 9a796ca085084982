// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed and for wide vectors in every build type, see CMakeLists.txt.
#include "odeum/scene/cloth_engine.hpp"

#include <stdexcept>

#include "odeum/scene/row_threads.hpp"

namespace odeum::scene {

template <class Real>
ClothEngine<Real>::ClothEngine(const Scene& scene, std::size_t threads)
    : ClothEngine(scene, require_grid(scene), threads) {}

template <class Real>
ClothEngine<Real>::ClothEngine(const Scene& scene, const GridStructure& grid, std::size_t threads)
    : layout_(grid.rows, grid.columns),
      springs_(layout_, grid.kinds),
      threads_(threads),
      inverse_mass_(3 * layout_.size),
      gravity_(inverse_mass_),
      q_(inverse_mass_),
      v_(inverse_mass_) {
  if (threads == 0) throw std::invalid_argument("a cloth needs a thread to be stepped on");
  std::vector<double> q, v, inverse_mass, gravity;
  for (const Particle& particle : scene.particles)
    for (std::size_t d = 0; d < 3; ++d) {
      q.push_back(particle.position[d]);
      v.push_back(particle.velocity[d]);
      inverse_mass.push_back(particle.fixed ? 0 : 1 / particle.mass);
      gravity.push_back(particle.fixed ? 0 : scene.gravity[d]);
    }
  layout_.scatter(q.data(), q_.data());
  layout_.scatter(v.data(), v_.data());
  layout_.scatter(inverse_mass.data(), inverse_mass_.data());
  layout_.scatter(gravity.data(), gravity_.data());
}

template <class Real>
std::size_t ClothEngine<Real>::springs() const {
  std::size_t sum = 0;
  for (const SpringKind& kind : springs_.kinds())
    sum += (layout_.rows - static_cast<std::size_t>(std::abs(kind.row_offset))) *
           (layout_.columns - static_cast<std::size_t>(std::abs(kind.column_offset)));
  return sum;
}

template <class Real>
void ClothEngine<Real>::read(double* y) const {
  layout_.gather(q_.data(), y);
  layout_.gather(v_.data(), y + 3 * particles());
}

template <class Real>
template <class Update>
void ClothEngine<Real>::each(std::size_t row, Update&& update) const {
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t begin = d * layout_.size + layout_.row(row), end = begin + layout_.columns;
#pragma GCC ivdep
    for (std::size_t i = begin; i < end; ++i) update(i);
  }
}

template <class Real>
void ClothEngine<Real>::accelerate(const Arrays& q, const Arrays& v, Arrays& a,
                                   std::size_t row) const {
  springs_.forces(q.data(), v.data(), a.data(), row, row + 1);
  const Real *const m = inverse_mass_.data(), *const g = gravity_.data();
  Real* const to = a.data();
  each(row, [=](std::size_t i) { to[i] = to[i] * m[i] + g[i]; });
}

template <class Real>
void ClothEngine<Real>::velocity_verlet(double step, std::size_t steps) {
  const Real h = static_cast<Real>(step), half = h / 2;
  Arrays acceleration(v_.size()), next(v_.size()), predicted(v_.size());
  on_rows(layout_.rows, threads_,
          [&](std::size_t begin, std::size_t end, const std::function<void()>& wait) {
            Real *const q = q_.data(), *const v = v_.data(), *const a = acceleration.data(),
                        *const p = predicted.data(), *const b = next.data();
            for (std::size_t r = begin; r < end; ++r) accelerate(q_, v_, acceleration, r);
            for (std::size_t n = 0; n < steps; ++n) {
              wait();  // for all who still read the positions
              for (std::size_t r = begin; r < end; ++r)
                each(r, [=](std::size_t i) {
                  q[i] += h * (v[i] + half * a[i]);
                  p[i] = v[i] + h * a[i];
                });
              wait();
              for (std::size_t r = begin; r < end; ++r) {
                accelerate(q_, predicted, next, r);
                each(r, [=](std::size_t i) {
                  v[i] += half * (a[i] + b[i]);
                  a[i] = b[i];
                });
              }
            }
          });
}

template <class Real>
void ClothEngine<Real>::rk4(double step, std::size_t steps) {
  const Real h = static_cast<Real>(step);
  Arrays acceleration(v_.size());
  // The argument of a stage, and that of the next one: neighbours still read the former.
  Arrays stage_q[2] = {q_, q_}, stage_v[2] = {v_, v_};
  on_rows(layout_.rows, threads_,
          [&](std::size_t begin, std::size_t end, const std::function<void()>& wait) {
            Real *const q = q_.data(), *const v = v_.data(), *const a = acceleration.data();
            Arrays sum_q(q_.size()), sum_v(q_.size());
            Real *const sq = sum_q.data(), *const sv = sum_v.data();
            constexpr Real weight[4] = {Real(1) / 6, Real(1) / 3, Real(1) / 3, Real(1) / 6};
            const Real reach[3] = {h / 2, h / 2, h};
            for (std::size_t n = 0; n < steps; ++n) {
              for (std::size_t s = 0; s < 4; ++s) {
                const Arrays &at_q = stage_q[s % 2], &at_v = stage_v[s % 2];
                const Real* const k = at_v.data();
                Real *const next_q = stage_q[(s + 1) % 2].data(), *const next_v =
                                                                      stage_v[(s + 1) % 2].data();
                const Real w = weight[s], c = s < 3 ? reach[s] : 0;
                for (std::size_t r = begin; r < end; ++r) {
                  accelerate(at_q, at_v, acceleration, r);
                  if (s == 0)
                    each(r, [=](std::size_t i) { sq[i] = w * k[i], sv[i] = w * a[i]; });
                  else
                    each(r, [=](std::size_t i) { sq[i] += w * k[i], sv[i] += w * a[i]; });
                  if (s < 3)
                    each(r, [=](std::size_t i) {
                      next_q[i] = q[i] + c * k[i], next_v[i] = v[i] + c * a[i];
                    });
                  else
                    each(r, [=](std::size_t i) {
                      next_q[i] = q[i] += h * sq[i];
                      next_v[i] = v[i] += h * sv[i];
                    });
                }
                wait();
              }
            }
          });
}

template class ClothEngine<double>;
template class ClothEngine<float>;

}  // namespace odeum::scene
