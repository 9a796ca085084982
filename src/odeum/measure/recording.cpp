// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/measure/recording.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "odeum/cases/set_problem.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/problem/events.hpp"

namespace odeum::measure {
namespace {

constexpr std::size_t most_times = 6'000'000;

/// Each capability of the problem within, so that a solver finds all that it finds there.
template <auto member, class Log, class R, class... Arguments>
constexpr auto forward(R (*OdeView::*)(const void*, Arguments...)) {
  return +[](const void* log, Arguments... all) -> R {
    const OdeView& inner = static_cast<const Log*>(log)->inner;
    return (inner.*member)(inner.problem, all...);
  };
}

/// The ends of the steps of a solver that does not tell them: where its evaluations had got to
/// after each equal share of them.
std::vector<double> estimated_ends(const Trace& trace, const Outcome& outcome, double t0) {
  std::vector<double> ends{t0};
  double reached = t0;
  std::size_t k = 0;
  for (std::uint64_t step = 1; step <= outcome.counters.steps; ++step) {
    const double until = static_cast<double>(trace.times.size()) * static_cast<double>(step) /
                         static_cast<double>(outcome.counters.steps);
    for (; k < trace.times.size() && static_cast<double>(k) < until; ++k)
      reached = std::max(reached, trace.times[k]);
    if (reached > ends.back()) ends.push_back(reached);
  }
  return ends;
}

void set_ends(Run& run, double t0) {
  run.ends.assign(1, t0);
  if (run.request.mode == Mode::fixed) {
    const FixedGrid grid(t0, run.request);
    // Events add shorter steps between those of the grid.
    const bool all = run.ok() && !run.outcome.events.empty();
    for (std::uint64_t i = 1;
         i <= (all ? grid.steps() : std::min(run.outcome.counters.steps, grid.steps())); ++i)
      run.ends.push_back(grid.t(i));
  } else if (!run.outcome.step_ends.empty() || run.outcome.counters.steps == 0) {
    // A peer may take steps below the rounding of t.
    for (const double t : run.outcome.step_ends)
      if (t > run.ends.back()) run.ends.push_back(t);
  } else {
    run.ends = estimated_ends(run.trace, run.outcome, t0);
    run.exact = false;
  }
}

/// Indices of `ends`: evenly in steps and in time, the last ones ever closer to the end.
std::set<std::size_t> chosen(const std::vector<double>& ends, std::size_t most) {
  std::set<std::size_t> at;
  const std::size_t last = ends.size() - 1, parts = std::max<std::size_t>(1, most / 2);
  for (std::size_t k = 0; k <= parts; ++k) {
    at.insert(last * k / parts);
    const double t = ends.front() + (ends.back() - ends.front()) * static_cast<double>(k) /
                                        static_cast<double>(parts);
    const auto found = std::ranges::lower_bound(ends, t);
    at.insert(std::min(last, static_cast<std::size_t>(found - ends.begin())));
  }
  for (std::size_t before = 1; before <= last; before *= 2) at.insert(last - before);
  return at;
}

Outcome solve_recorded(const Case& c, const std::string& solver, const Request& request,
                       Trace* trace) {
  const Recording recording(c, c.t0, c.y0);
  const Entrant* const entrant = recording.solver(solver);
  Outcome outcome = (entrant ? entrant : c.entrants.find(solver))->solve(request);
  if (interrupted) throw Interrupted();
  if (trace) *trace = recording.trace();
  return outcome;
}

}  // namespace

bool Recording::Log::note(double t, const double* values, std::size_t n, std::size_t first) {
  if (trace.times.size() < most_times) trace.times.push_back(t);
  if (!std::isnan(trace.first_bad.t) || is_finite(values, n)) return false;
  std::size_t i = 0;
  while (std::isfinite(values[i])) ++i;
  trace.first_bad = {t, {}, first + i, values[i]};
  return true;
}

Recording::Recording(const Case& c, double t0, const std::vector<double>& y0)
    : log_(std::make_shared<Log>(Log{c.problem.view, c.problem.keep_alive, {}})) {
  const ErasedContest& contest = c.problem;
  OdeView view = contest.view;
  view.problem = log_.get();
#define ODEUM_FORWARD(concept_name, function, charge, ...) \
  if (view.function) view.function = forward<&OdeView::function, Log>(&OdeView::function);
  ODEUM_CAPABILITIES(ODEUM_FORWARD)
#undef ODEUM_FORWARD
  view.rhs = [](const void* problem, double t, const double* y, double* f) {
    Log& log = *static_cast<Log*>(const_cast<void*>(problem));
    log.inner.rhs(log.inner.problem, t, y, f);
    if (log.note(t, f, log.inner.dimension, 0))
      log.trace.first_bad.y.assign(y, y + log.inner.dimension);
  };
  if (view.acceleration)
    view.acceleration = [](const void* problem, double t, const double* q, const double* v,
                           double* a) {
      Log& log = *static_cast<Log*>(const_cast<void*>(problem));
      log.inner.acceleration(log.inner.problem, t, q, v, a);
      const std::size_t half = log.inner.degrees_of_freedom;
      if (!log.note(t, a, half, half)) return;
      // A separable problem is asked for no velocities.
      log.trace.first_bad.y.assign(q, q + half);
      log.trace.first_bad.y.resize(2 * half, nan);
    };
  std::shared_ptr<ImplicitForm> implicit;
  if (contest.implicit) {
    implicit = std::make_shared<ImplicitForm>(*contest.implicit);
    implicit->residual = [log = log_, inner = contest.implicit](double t, const double* y,
                                                                const double* rates, double* r) {
      inner->residual(t, y, rates, r);
      if (log->note(t, r, inner->dimension, 0))
        log->trace.first_bad.y.assign(y, y + inner->dimension);
    };
  }
  std::shared_ptr<const Events> events = contest.events;
  if (events && t0 > c.t0) {  // what happens at that state has happened
    auto resumed = std::make_shared<Events>(*events);
    resumed->resumed = true;
    events = std::move(resumed);
  }
  entrants_ = cases::enroll({view, log_, t0, std::make_shared<const std::vector<double>>(y0),
                             contest.scene, implicit, contest.switches, events});
}

std::pair<double, double> Run::around(double t) const {
  const std::size_t wide = std::max<std::size_t>(3, steps() / 200);
  const auto above = std::ranges::upper_bound(ends, t);
  const std::size_t i = std::max<std::size_t>(1, above - ends.begin()) - 1;
  return {ends[i - std::min(i, wide)], ends[std::min(steps(), i + 1 + wide)]};
}

double Run::steps_in(double from, double to) const {
  const auto place = [&](double t) {
    const auto above = std::ranges::upper_bound(ends, t);
    if (above == ends.begin()) return 0.0;
    if (above == ends.end()) return static_cast<double>(steps());
    const double before = *(above - 1);
    return static_cast<double>(above - ends.begin() - 1) + (t - before) / (*above - before);
  };
  return place(to) - place(from);
}

double Run::step_at(double t) const {
  const auto [from, to] = around(t);
  return (to - from) / steps_in(from, to);
}

Run record(const Case& c, const std::string& solver, const Request& request, std::size_t most) {
  Run run{.solver = solver, .request = request};
  run.request.record_steps = true;
  run.outcome = solve_recorded(c, solver, run.request, &run.trace);
  set_ends(run, c.t0);
  const std::size_t last = run.steps();
  const auto moment = [&](std::size_t k, const double* y) {
    run.moments.push_back(
        {run.ends[k], k < last ? run.ends[k + 1] - run.ends[k] : 0, k, {y, y + c.y0.size()}});
  };
  moment(0, c.y0.data());
  if (most == 0 || last == 0) return run;
  const std::set<std::size_t> at = chosen(run.ends, most);
  Request again = run.request;
  again.over_stops = true;
  again.record_steps = false;
  again.stops.clear();
  for (const std::size_t k : at)
    if (k > 0 && run.ends[k] < request.stops.back()) again.stops.push_back(run.ends[k]);
  again.stops.push_back(request.stops.back());
  const Outcome outcome = solve_recorded(c, solver, again, nullptr);
  const std::size_t reached = outcome.states.size() / c.y0.size();
  std::size_t stop = 0;
  for (const std::size_t k : at) {
    if (k == 0) continue;
    if (stop == reached) break;
    moment(k, outcome.states.data() + stop++ * c.y0.size());
  }
  return run;
}

}  // namespace odeum::measure
