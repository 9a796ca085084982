// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed and for wide vectors in every build type, see CMakeLists.txt.
#include "odeum/scene/springs/cloth_engine.hpp"

#include <stdexcept>

#include "odeum/scene/springs/row_threads.hpp"

namespace odeum::scene {

template <class Real>
ClothEngine<Real>::ClothEngine(const Scene& scene, std::size_t threads)
    : ClothEngine(scene, require_grid(scene), threads) {}

template <class Real>
ClothEngine<Real>::ClothEngine(const Scene& scene, const GridStructure& grid, std::size_t threads)
    : state_(scene, grid), springs_(state_.layout, grid.kinds), threads_(threads) {
  if (threads == 0) throw std::invalid_argument("a cloth needs a thread to be stepped on");
}

template <class Real>
std::size_t ClothEngine<Real>::springs() const {
  std::size_t sum = 0;
  for (const SpringKind& kind : springs_.kinds())
    sum += (state_.layout.rows - static_cast<std::size_t>(std::abs(kind.row_offset))) *
           (state_.layout.columns - static_cast<std::size_t>(std::abs(kind.column_offset)));
  return sum;
}

template <class Real>
void ClothEngine<Real>::accelerate(const Arrays& q, const Arrays& v, Arrays& a,
                                   std::size_t row) const {
  springs_.forces(q.data(), v.data(), a.data(), row, row + 1);
  const Real *const m = state_.inverse_mass.data(), *const g = state_.gravity.data();
  Real* const to = a.data();
  state_.each(row, [=](std::size_t i) { to[i] = to[i] * m[i] + g[i]; });
}

template <class Real>
void ClothEngine<Real>::velocity_verlet(double step, std::size_t steps) {
  const Real h = static_cast<Real>(step), half = h / 2;
  Arrays acceleration(state_.v.size()), next(state_.v.size()), predicted(state_.v.size());
  on_rows(
      state_.layout.rows, threads_,
      [&](std::size_t begin, std::size_t end, const std::function<void()>& wait) {
        Real *const q = state_.q.data(), *const v = state_.v.data(), *const a = acceleration.data(),
                    *const p = predicted.data(), *const b = next.data();
        for (std::size_t r = begin; r < end; ++r) accelerate(state_.q, state_.v, acceleration, r);
        for (std::size_t n = 0; n < steps; ++n) {
          wait();  // for all who still read the positions
          for (std::size_t r = begin; r < end; ++r)
            state_.each(r, [=](std::size_t i) {
              q[i] += h * (v[i] + half * a[i]);
              p[i] = v[i] + h * a[i];
            });
          wait();
          for (std::size_t r = begin; r < end; ++r) {
            accelerate(state_.q, predicted, next, r);
            state_.each(r, [=](std::size_t i) {
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
  Arrays acceleration(state_.v.size());
  // The argument of a stage, and that of the next one: neighbours still read the former.
  Arrays stage_q[2] = {state_.q, state_.q}, stage_v[2] = {state_.v, state_.v};
  on_rows(
      state_.layout.rows, threads_,
      [&](std::size_t begin, std::size_t end, const std::function<void()>& wait) {
        Real *const q = state_.q.data(), *const v = state_.v.data(), *const a = acceleration.data();
        Arrays sum_q(state_.q.size()), sum_v(state_.q.size());
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
                state_.each(r, [=](std::size_t i) { sq[i] = w * k[i], sv[i] = w * a[i]; });
              else
                state_.each(r, [=](std::size_t i) { sq[i] += w * k[i], sv[i] += w * a[i]; });
              if (s < 3)
                state_.each(r, [=](std::size_t i) {
                  next_q[i] = q[i] + c * k[i], next_v[i] = v[i] + c * a[i];
                });
              else
                state_.each(r, [=](std::size_t i) {
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
