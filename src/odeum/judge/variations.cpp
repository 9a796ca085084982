// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/variations.hpp"

#include <algorithm>

#include "odeum/problem/sparsity.hpp"
#include "odeum/solvers/own_methods.hpp"
#include "odeum/solvers/pieces.hpp"

namespace odeum::judge {
namespace {

/// The equations with the rows of Phi after the state.
struct Equations {
  const OdeView& view;
  mutable std::vector<double> jacobian, entries;

  void rhs(double t, const double* y, double* slope) const {
    const std::size_t n = view.dimension;
    view.rhs(view.problem, t, y, slope);
    fill(t, y);
    for (std::size_t i = 0; i < n; ++i) {
      double* const row = slope + n + i * n;
      std::fill(row, row + n, 0.0);
      for (std::size_t k = 0; k < n; ++k) {
        const double by = jacobian[i * n + k];
        if (by == 0) continue;
        const double* const phi = y + n + k * n;
        for (std::size_t j = 0; j < n; ++j) row[j] += by * phi[j];
      }
    }
  }

 private:
  void fill(double t, const double* y) const {
    if (view.jacobian) return view.jacobian(view.problem, t, y, jacobian.data());
    view.jacobian_entries(view.problem, t, y, entries.data());
    fill_dense(*view.sparsity, entries.data(), jacobian.data());
  }
};

}  // namespace

std::vector<double> with_variations(const Case& c, double start, const std::vector<double>& y,
                                    double to, const Tolerance& tolerance,
                                    const std::vector<double>& units) {
  constexpr std::uint64_t most_evaluations = 100'000;
  const OdeView& view = c.problem.view;
  if (!view.jacobian && !(view.jacobian_entries && view.sparsity)) return {};
  const std::size_t n = y.size();
  const Equations equations{view, std::vector<double>(n * n),
                            std::vector<double>(view.sparsity ? view.sparsity->entries() : 0)};
  // An autonomous problem starts at time 0, where short first steps are not lost in rounding.
  const double shift = view.time_derivative ? 0 : start;
  std::vector<double> from = y, thresholds;
  for (std::size_t i = 0; i < n; ++i) thresholds.push_back(tolerance.threshold(i));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      from.push_back(i == j ? 1 : 0);
      thresholds.push_back(units[i] / units[j]);
    }
  ErasedContest contest;
  contest.view.problem = &equations;
  contest.view.dimension = from.size();
  contest.view.rhs = [](const void* problem, double t, const double* at, double* slope) {
    static_cast<const Equations*>(problem)->rhs(t, at, slope);
  };
  contest.switches = c.problem.switches;
  contest.t0 = start - shift;
  contest.y0 = std::make_shared<const std::vector<double>>(from);
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = Tolerance::of_thresholds(tolerance.relative, thresholds);
  request.stops = {to - shift};
  request.budget.evaluations = most_evaluations;
  Outcome outcome = enrolled(own_solver("dormand_prince853"), contest).solve(request);
  if (outcome.status != Status::ok) return {};
  return std::move(outcome.states);
}

}  // namespace odeum::judge
