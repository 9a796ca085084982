// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "odeum/cases/set_problem.hpp"
#include "odeum/cases/text_events.hpp"
#include "odeum/formula/text_ode.hpp"

namespace odeum::tests {

/// A text with events, and runs of it.
struct HybridText {
  explicit HybridText(const std::string& text)
      : problem(formula::read_problem("events.yaml", text)),
        ode(std::make_shared<formula::TextOde>(problem, formula::TextOde::Code::interpreted)),
        contest{ode->view(), ode, static_cast<double>(problem.t0),
                std::make_shared<const std::vector<double>>(problem.y0.begin(), problem.y0.end()),
                nullptr} {
    contest.events = cases::events_of(problem);
  }
  Outcome run(const std::string& solver, double tolerance) const {
    Request request;
    request.mode = Mode::adaptive;
    request.tolerance = tolerance;
    request.stops = problem.stops;
    return cases::enroll(contest).find(solver)->solve(request);
  }
  Outcome run_fixed(const std::string& solver, std::uint64_t steps) const {
    Request request;
    request.steps = steps;
    request.stops = problem.stops;
    return cases::enroll(contest).find(solver)->solve(request);
  }

  formula::Problem problem;
  std::shared_ptr<formula::TextOde> ode;
  ErasedContest contest;
};

}  // namespace odeum::tests
