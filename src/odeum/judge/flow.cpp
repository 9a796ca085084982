// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "odeum/core/guarded.hpp"
#include "odeum/problem/events.hpp"
#include "odeum/solvers/event_run.hpp"
#include "odeum/solvers/own_methods.hpp"
#include "odeum/solvers/pieces.hpp"

namespace odeum::judge {
namespace {

constexpr std::uint64_t explicit_budget = 20'000, implicit_budget = 1'000'000;

/// The watch of a run whose evaluations are recorded.
struct Recorder {
  std::vector<double>* times;
  template <class Size, class Call>
  int evaluate(double t, double*, Size&&, bool, Call&& call, int = 1) const {
    times->push_back(t);
    call();
    return 0;
  }
  void count_jacobian() const {}
  void count_products(std::uint64_t) const {}
  static constexpr bool tripped() { return false; }
};
std::unique_ptr<ShiftedSolver> counted(std::unique_ptr<ShiftedSolver> solver, const Recorder&) {
  return solver;
}

Outcome run(std::string_view method, const Tolerance& tolerance, const Case& c, double start,
            const std::vector<double>& y, const std::vector<double>& stops, std::uint64_t budget,
            std::vector<double>* times) {
  // An autonomous problem starts at time 0, where short first steps are not lost in rounding.
  const double shift = c.problem.view.time_derivative || c.problem.events ? 0 : start;
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = tolerance.requested(tolerance.relative);
  for (const double stop : stops) request.stops.push_back(stop - shift);
  request.budget.evaluations = budget;
  ErasedContest contest = c.problem;
  if (contest.events && start > c.t0) {
    if (contest.events->remembers)
      return refused("delays of events, which are not in its state, make a run one whole");
    auto resumed = std::make_shared<Events>(*contest.events);
    resumed->resumed = true;
    contest.events = std::move(resumed);
  }
  contest.t0 = start - shift;
  contest.y0 = std::make_shared<const std::vector<double>>(y);
  const SharedOde problem(c.problem.view, nullptr);
  const Guarded<SharedOde, Recorder> recorded(problem, {times});
  if (times) {
    const OdeView all = view_of(recorded);
    contest.view = {.problem = all.problem,
                    .dimension = all.dimension,
                    .rhs = all.rhs,
                    .jacobian = all.jacobian,
                    .jacobian_entries = all.jacobian_entries,
                    .time_derivative = all.time_derivative,
                    .sparsity = all.sparsity};
  }
  const Solver& own = own_solver(method);
  Outcome outcome = enrolled(own, contest).solve(request);
  if (times)
    for (double& t : *times) t += shift;
  return outcome;
}

/// The evaluations that the explicit method needs to the end, where its run ended over budget; the
/// implicit method's budget otherwise, and at most.
std::uint64_t foreseen_evaluations(const Outcome& ended, const std::vector<double>& evaluated,
                                   double start, double end) {
  if (ended.status != Status::over_budget) return implicit_budget;
  const double reached = *std::ranges::max_element(evaluated) - start;
  const double all = static_cast<double>(explicit_budget) * (end - start) / reached;
  return all < static_cast<double>(implicit_budget) ? static_cast<std::uint64_t>(all)
                                                    : implicit_budget;
}

}  // namespace

Flow::Flow(const Case& c, double end, const char* explicit_method, const Tolerance& tolerance)
    : case_(c), explicit_method_(explicit_method), method_(explicit_method), tolerance_(tolerance) {
  if (c.problem.events && c.problem.events->isolated)
    throw std::runtime_error(
        "it takes runs that begin between events, where the FMU's discrete states are not told");
  const auto attempt = [&](const char* method, std::uint64_t budget) {
    method_ = method;
    evaluated_.clear();
    return run(method, tolerance, c, c.t0, c.y0, {end}, budget, &evaluated_);
  };
  Outcome outcome = attempt(explicit_method, explicit_budget);
  // The implicit method solves with full matrices of few unknowns, or with sparse ones.
  const bool implicit = c.y0.size() <= dense_dimension_limit || c.problem.view.sparsity;
  if (outcome.status != Status::ok && implicit) {
    // Fast oscillations need as many evaluations of either method, and the implicit one solves
    // systems besides.
    const std::uint64_t foreseen = foreseen_evaluations(outcome, evaluated_, c.t0, end);
    outcome = attempt("radau_iia5", foreseen);
    if (outcome.status != Status::ok && foreseen < implicit_budget) {
      outcome = attempt(explicit_method, implicit_budget);
      if (outcome.status != Status::ok) outcome = attempt("radau_iia5", implicit_budget);
    }
  }
  if (outcome.status != Status::ok)
    throw std::runtime_error(fmt::format("{} to {:.0e} ends {}, {}", method_, tolerance.relative,
                                         to_string(outcome.status), outcome.detail));
  std::ranges::sort(evaluated_);
  for (const EventMet& event : outcome.events) happened_.push_back(event.t);
}

std::vector<double> Flow::solve(double start, const std::vector<double>& y,
                                const std::vector<double>& stops) {
  Outcome outcome = run(method_, tolerance_, case_, start, y, stops, implicit_budget, nullptr);
  if (outcome.status != Status::ok)
    throw std::runtime_error(fmt::format("{} to {:.0e} from t = {} ends {}, {}", method_,
                                         tolerance_.relative, start, to_string(outcome.status),
                                         outcome.detail));
  return std::move(outcome.states);
}

std::vector<double> Flow::states(const std::vector<double>& stops, double relative) const {
  Outcome outcome = run(method_, tolerance_.with_relative(relative), case_, case_.t0, case_.y0,
                        stops, implicit_budget, nullptr);
  if (outcome.status != Status::ok) return {};
  return std::move(outcome.states);
}

std::vector<double> Flow::checkpoints(const std::vector<double>& stops, std::size_t count) const {
  std::vector<double> times = stops;
  times.push_back(case_.t0);
  for (std::size_t k = 1; k <= count; ++k)
    times.push_back(between_events(evaluated_[k * evaluated_.size() / (count + 1)], happened_,
                                   case_.t0, stops.back()));
  std::ranges::sort(times);
  std::vector<double> apart;
  for (const double t : times) {
    if (t > stops.back()) break;
    // An interval at the rounding of its times would be none.
    const bool near = !apart.empty() && t - apart.back() <= 1e-9 * std::abs(t);
    if (!near)
      apart.push_back(t);
    else if (std::ranges::binary_search(stops, t) && apart.back() != case_.t0)
      apart.back() = t;
  }
  return apart;
}

}  // namespace odeum::judge
