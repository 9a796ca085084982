// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "odeum/contest/case.hpp"
#include "support/own_runs.hpp"

namespace odeum::tests {

/// The largest |component| of the truth at the stops and of the initial state, at least 1.
inline double size_of_solution(const Case& c) {
  double size = 1;
  const auto look = [&](const std::vector<double>& y) {
    for (const double value : y) size = std::max(size, std::abs(value));
  };
  look(c.y0);
  std::vector<double> y(c.y0.size());
  for (const double stop : c.stops)
    if (c.truth.at(stop, y.data())) look(y);
  return size;
}

/// The amplification, by the problem itself, of an error made at any one time up to the case's
/// later stops: each component i of the state is perturbed by d (1 + |y_i|), and the effects are
/// summed, in units of d times the size of the solution. At least 1. Measured at 16 times, at the
/// start more densely, by runs of Radau IIA to 1e-10 with d = 1e-6.
inline double amplification(const Case& c) {
  constexpr double d = 1e-6;
  const std::size_t n = c.y0.size();
  // An autonomous problem is started at time 0, where short steps are not lost in the rounding of
  // t.
  const double shift_by = c.problem.view.time_derivative ? 0 : 1;
  const auto solve = [&](double start, const std::vector<double>& y0, std::vector<double> stops) {
    const double t0 = start - shift_by * start;
    for (double& stop : stops) stop -= shift_by * start;
    ErasedContest contest = c.problem;
    contest.t0 = t0;
    contest.y0 = std::make_shared<const std::vector<double>>(y0);
    Request request;
    request.mode = Mode::adaptive;
    request.tolerance = 1e-10;
    request.stops = std::move(stops);
    Outcome outcome = run_own("radau_iia5", contest, request);
    if (outcome.status != Status::ok)
      throw std::runtime_error("no amplification of " + c.id + ": " + outcome.detail);
    return outcome.states;
  };
  std::vector<double> times{c.t0};
  for (int k = 15; k > 0; --k)
    times.push_back(c.t0 + (c.stops.back() - c.t0) * std::pow(1 - k / 16.0, 2));
  std::vector<double> path = solve(c.t0, c.y0, {times.begin() + 1, times.end()});
  path.insert(path.begin(), c.y0.begin(), c.y0.end());
  double worst = 1;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const std::vector<double> start(path.begin() + k * n, path.begin() + (k + 1) * n);
    std::vector<double> stops;
    for (const double stop : c.stops)
      if (stop > times[k]) stops.push_back(stop);
    const std::vector<double> end = solve(times[k], start, stops);
    std::vector<double> moved_by(end.size(), 0);
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<double> moved = start;
      moved[i] += d * (1 + std::abs(moved[i]));
      const std::vector<double> there = solve(times[k], moved, stops);
      for (std::size_t m = 0; m < end.size(); ++m) moved_by[m] += std::abs(there[m] - end[m]) / d;
    }
    for (const double amount : moved_by) worst = std::max(worst, amount);
  }
  return std::max(1.0, worst / size_of_solution(c));
}

}  // namespace odeum::tests
