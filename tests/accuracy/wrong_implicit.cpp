// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "accuracy/wrong_solvers.hpp"
#include "odeum/linear/dense_lu.hpp"

namespace odeum::tests {
namespace {

/// How the equation Y = y + gamma h f(t + gamma h, Y) of a step is solved.
struct Solution {
  double tolerance = 1e-13;  ///< of the residual, or of the last change
  bool newton = true;        ///< or by fixed-point iteration
  double linear_error = 0;   ///< relative, of the linear systems
  bool stale = false;        ///< one Jacobian for the run, one correction a step
};

/// I - gamma h J by differences, factorised.
linear::DenseLu newton_matrix(const OdeView& problem, double t, double gamma_h, const Vector& y) {
  const std::size_t n = y.size();
  linear::DenseLu lu(n);
  Vector f(n), moved_f(n), moved = y;
  problem.rhs(problem.problem, t, y.data(), f.data());
  for (std::size_t j = 0; j < n; ++j) {
    const double step = 1e-7 * std::max(1.0, std::abs(y[j]));
    moved[j] += step;
    problem.rhs(problem.problem, t, moved.data(), moved_f.data());
    moved[j] = y[j];
    for (std::size_t i = 0; i < n; ++i)
      lu.data()[i * n + j] = (i == j ? 1 : 0) - gamma_h * (moved_f[i] - f[i]) / step;
  }
  lu.factorise();
  return lu;
}

/// gamma = 1: implicit Euler; 1/2: implicit midpoint, whose new state is 2 Y - y.
MakeStep implicit_step(double gamma, const Solution& solution) {
  return [=](const OdeView& problem) -> Step {
    return [=, kept = linear::DenseLu(0)](std::uint64_t i, double t, double h, Vector& y) mutable {
      const double gamma_h = gamma * h, time = t + gamma_h;
      Vector stage = y, rest(y.size());
      if (solution.newton && (i == 0 || !solution.stale))
        kept = newton_matrix(problem, time, gamma_h, y);
      for (int iteration = 0; iteration < (solution.stale ? 1 : 30); ++iteration) {
        problem.rhs(problem.problem, time, stage.data(), rest.data());
        double size = 0;
        for (std::size_t n = 0; n < y.size(); ++n) {
          rest[n] = y[n] + gamma_h * rest[n] - stage[n];
          size = std::max(size, std::abs(rest[n]));
        }
        if (size <= solution.tolerance) break;
        if (solution.newton) kept.solve(rest.data());
        for (std::size_t n = 0; n < y.size(); ++n)
          stage[n] += (1 - solution.linear_error) * rest[n];
      }
      for (std::size_t n = 0; n < y.size(); ++n) y[n] += (stage[n] - y[n]) / gamma;
    };
  };
}

}  // namespace

std::vector<WrongSolver> wrong_implicit_steps() {
  std::vector<WrongSolver> solvers;
  for (const double gamma : {1., 0.5}) {
    const char* const name = gamma == 1 ? "implicit Euler" : "implicit midpoint";
    const auto add = [&](const std::string& fault, const Solution& solution) {
      solvers.push_back({fmt::format("{}, {}", name, fault), 1 / gamma,
                         implicit_step(gamma, solution), implicit_step(gamma, {})});
    };
    for (const double tolerance : {1e-3, 1e-4, 1e-6}) {
      add(fmt::format("Newton to {:.0e}", tolerance), {.tolerance = tolerance});
      add(fmt::format("fixed point to {:.0e}", tolerance),
          {.tolerance = tolerance, .newton = false});
    }
    add("one Jacobian for all steps", {.stale = true});
    for (const double error : {1e-1, 1e-3})
      add(fmt::format("linear systems to {:.0e}, Newton to 1e-5", error),
          {.tolerance = 1e-5, .linear_error = error});
  }
  return solvers;
}

}  // namespace odeum::tests
