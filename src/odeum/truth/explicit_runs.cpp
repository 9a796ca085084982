// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/methods/verner98.hpp"
#include "odeum/problem/extended_problem.hpp"
#include "odeum/truth/march.hpp"

namespace odeum::truth {
namespace {

/// The states of a midpoint rule, kept from one to the next.
struct MidpointStates {
  State before, now, at, f;
  explicit MidpointStates(std::size_t n) : before(n), now(n), at(n), f(n) {}
};

/// Gragg's modified midpoint rule with n substeps of h / n, as an increment of y, with smoothing.
void midpoint_rule(const System& system, Real t, Real h, int n, const State& y, const State& f0,
                   MidpointStates& states, State& increment) {
  const std::size_t size = y.size();
  const Real part = h / n;
  auto& [before, now, at, f] = states;
  std::ranges::fill(before, 0);
  for (std::size_t i = 0; i < size; ++i) now[i] = part * f0[i];
  for (int k = 1; k <= n; ++k) {
    for (std::size_t i = 0; i < size; ++i) at[i] = y[i] + now[i];
    system.rhs(t + k * part, at.data(), f.data());
    for (std::size_t i = 0; i < size; ++i) {
      if (k == n) {
        increment[i] = (before[i] + now[i] + part * f[i]) / 2;
      } else {
        const Real next = before[i] + 2 * part * f[i];
        before[i] = now[i];
        now[i] = next;
      }
    }
  }
}

}  // namespace

Run taylor_run(const System& system, const std::vector<Real>& times, const Effort& effort) {
  constexpr int order = 28;
  const std::size_t n = system.states;
  State c((order + 1) * n), coefficient(n);
  const auto bound = [&](int k, const State& sizes) {
    std::copy_n(c.begin() + static_cast<std::ptrdiff_t>(n) * k, n, coefficient.begin());
    return largest_ratio(coefficient, sizes) / effort.tolerance;
  };
  return march(system, times, effort, order,
               [&](Real t, Real h, const State& y, const State& sizes) {
                 Trial trial{.y = State(n), .work = system.work * order * order / 2};
                 system.taylor(t, y.data(), order, c.data());
                 for (std::size_t i = 0; i < n; ++i) {
                   Real sum = 0;
                   for (std::size_t k = order + 1; k-- > 0;) sum = sum * h + c[k * n + i];
                   trial.y[i] = sum;
                 }
                 // The last two terms: in odd or even series every other one is zero.
                 trial.error = std::max(bound(order, sizes) * std::pow(h, order),
                                        bound(order - 1, sizes) * std::pow(h, order - 1) * 0.1L);
                 return trial;
               });
}

Run extrapolation_run(const System& system, const std::vector<Real>& times, const Effort& effort) {
  constexpr int lines = 7;
  const std::size_t n = system.states;
  std::array<State, lines> table;
  State f0(n), line(n), difference(n);
  MidpointStates states(n);
  Noise noise(system);
  return march(
      system, times, effort, 2 * lines - 1,
      [&](Real t, Real h, const State& y, const State& sizes) {
        Trial trial{.y = y, .work = 0};
        system.rhs(t, y.data(), f0.data());
        for (int j = 0; j < lines; ++j) {
          const int parts = 2 * (j + 1);
          midpoint_rule(system, t, h, parts, y, f0, states, line);
          trial.work += (system.work + 20 + 6 * static_cast<double>(n)) * parts;
          extrapolate(table, j, line, difference, [&](int k) {  // in h^2
            const Real ratio = static_cast<Real>(parts) / (2 * (j - k));
            return 1 / (ratio * ratio - 1);
          });
        }
        for (std::size_t i = 0; i < n; ++i) trial.y[i] += line[i];
        trial.error = noise.ratio(t, h, y, difference, sizes, effort.tolerance);
        return trial;
      },
      short_memory);
}

Run verner_run(const System& system, const std::vector<Real>& times, const Effort& effort) {
  ExtendedProblem problem{.f = system.rhs, .y0 = system.y0, .truth = {}};
  ExplicitRungeKutta<methods::verner98_digits, ExtendedProblem> stepper(problem);
  State error(system.states);
  Noise noise(system);
  return march(
      system, times, effort, 9,
      [&](Real t, Real h, const State& y, const State& sizes) {
        Trial trial{.y = y, .work = 19 * (system.work + 20) + 100 * static_cast<double>(y.size())};
        stepper.step(t, h, trial.y, error);
        trial.error = noise.ratio(t, h, y, error, sizes, effort.tolerance);
        for (const Real x : trial.y) trial.error += 0 * x;
        return trial;
      },
      short_memory);
}

}  // namespace odeum::truth
