// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "odeum/cases/catalogue.hpp"
#include "odeum/solvers/case.hpp"

/// Adapters against programs that use a library alone, written as its documentation shows, on hard
/// cases: what such a program solves, the adapter must solve at the same tolerance.
namespace odeum::test {

/// Integrates a case to its horizon with one tolerance, relative and absolute. True where the
/// library reports success; y, the initial state at first, is then the state at the horizon.
using Program = std::function<bool(const Case&, double tolerance, std::vector<double>& y)>;

inline std::vector<Case> hard_cases() {
  std::vector<Case> hard;
  for (const Case& c : all_cases())
    for (const char* id :
         {"robertson_40", "robertson", "vdp_mu1000", "vdp_eps1e_6", "hires", "oregonator"})
      if (c.id == id) hard.push_back(c);
  return hard;
}

/// At the horizon, relative to the largest component there.
inline double error_at_end(const Case& c, const double* y) {
  std::vector<double> exact(c.y0.size());
  if (!c.truth.at(c.stops.back(), exact.data())) throw std::logic_error("no truth: " + c.id);
  double error = 0, size = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    error = std::max(error, std::abs(y[i] - exact[i]));
    size = std::max(size, std::abs(exact[i]));
  }
  return std::isfinite(error) ? error / size : std::numeric_limits<double>::infinity();
}

inline Outcome solve_adaptively(const Case& c, const Entrant& entrant, double tolerance) {
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = tolerance;
  request.stops = c.stops;
  request.budget.evaluations = 300'000;
  return entrant.solve(request);
}

/// Whether a program solves a case, and not by chance: Robertson's problem drifts to negative
/// concentrations or not depending on the last digits of a run (reports/findings/sundials.md), so
/// that initial states changed by 1e-10 must be solved as well.
inline bool solves(const Program& program, const Case& c, double tolerance) {
  for (int change = 0; change < 20; ++change) {
    std::vector<double> y = c.y0;
    for (double& component : y) component *= 1 + 1e-10 * change;
    if (!program(c, tolerance, y) || !(error_at_end(c, y.data()) < 0.1)) return false;
  }
  return true;
}

inline void expect_no_worse_than_alone(const std::string& id, const Program& program) {
  for (const Case& c : hard_cases()) {
    int solved = 0;
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
      if (!solves(program, c, tolerance)) continue;
      ++solved;
      for (const Entrant& entrant : c.entrants) {
        if (entrant.info.id() != id) continue;
        const Outcome outcome = solve_adaptively(c, entrant, tolerance);
        EXPECT_EQ(outcome.status, Status::ok)
            << id << " on " << c.id << " at " << tolerance << ": " << outcome.detail;
        EXPECT_LT(outcome.counters.steps, outcome.counters.rhs_evaluations) << id << ' ' << c.id;
      }
    }
    EXPECT_GT(solved, 0) << "the program of " << id << " solves nothing on " << c.id;
  }
}

/// On every hard case a solver of the library ends within an error of a hundredth.
inline void expect_each_case_solved(const std::string& library) {
  for (const Case& c : hard_cases()) {
    double best = std::numeric_limits<double>::infinity();
    for (const double tolerance : {1e-5, 1e-9}) {
      for (const Entrant& entrant : c.entrants) {
        const SolverInfo& info = entrant.info;
        if (best < 0.01) break;
        if (info.library != library || !info.adaptive || info.family == "explicit_rk") continue;
        const Outcome outcome = solve_adaptively(c, entrant, tolerance);
        if (outcome.status != Status::ok) continue;
        const double* const end = outcome.states.data() + outcome.states.size() - c.y0.size();
        best = std::min(best, error_at_end(c, end));
      }
    }
    EXPECT_LT(best, 0.01) << library << " on " << c.id;
  }
}

}  // namespace odeum::test
