// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/why/why.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "odeum/core/clocks.hpp"
#include "odeum/isolated/isolated_times.hpp"
#include "odeum/solvers/event_run.hpp"
#include "odeum/why/inquiry.hpp"

namespace odeum::why {
const char* name_of(Cause cause) {
  constexpr std::array names{
      "accuracy", "stability",      "kink",     "sliding", "pole",     "growth",        "singular",
      "domain",   "wrong_jacobian", "rounding", "pulse",   "aliasing", "amplification", "absolute",
      "energy",   "too_coarse",     "too_fine", "astray",  "newton",   "unfit",         "events"};
  return names[static_cast<std::size_t>(cause)];
}

namespace {

/// Processor seconds of this program and of solves in processes of their own.
double used_seconds() {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec) +
         isolated_times.processor_s;
}

}  // namespace

Inquiry::Inquiry(const Case& given, const std::string& solver, const Request& request,
                 double seconds_given, cases::Conditions conditions_given)
    : c(given),
      conditions(std::move(conditions_given)),
      seconds(seconds_given),
      processor_start(used_seconds()),
      names(component_names(given)),
      region(solver) {
  why.solver = solver;
  why.request = request;
  run.request = request;
}

double Inquiry::left() const {
  constexpr double most_by_the_clock = 3;
  return seconds -
         std::max(used_seconds() - processor_start, seconds_since(start) / most_by_the_clock);
}

Run Inquiry::make(const Case& on, const std::string& solver, Request request, std::size_t moments,
                  double share) const {
  // The run itself comes first.
  const std::uint64_t most = why.outcome.counters.work == 0 ? 20'000'000 : 5'000'000;
  request.budget.evaluations = std::min(request.budget.evaluations, most);
  // The bound is in seconds of the clock, which other programs stretch; to a tenth, since a message
  // has it.
  const double used = used_seconds() - processor_start, wall = seconds_since(start),
               crowding = used > 0.1 ? std::clamp(wall / used, 1.0, 3.0) : 1;
  request.budget.seconds = std::min(request.budget.seconds,
                                    std::max(0.1, std::floor(5 * share * crowding * left()) / 10));
  return measure::record(on, solver, request, moments);
}

void Inquiry::add(Cause cause, double share, double from, std::string text) {
  why.findings.push_back({cause, share, from, std::move(text)});
}

bool Inquiry::found(Cause cause) const {
  return std::ranges::any_of(why.findings,
                             [&](const Finding& each) { return each.cause == cause; });
}

namespace {

/// Looks at what bounds the steps of an adaptive run.
void look_at_steps(Inquiry& q) {
  for (const double by : {100.0, 0.01}) {
    Request looser = q.run.request;
    const double relative = looser.tolerance.relative;
    if (by > 1 ? relative > 1e-3 : q.looser && by * relative < 1e-13) continue;
    looser.tolerance = looser.tolerance.with_relative(by * relative);
    q.looser_by = by;
    q.looser = q.make(q.c, q.why.solver, looser, 0, 0.2);
    q.looser->trace.times = {};
    // A looser run that fails where this one does not says nothing of its steps.
    if (q.looser->ok() || !q.run.ok()) break;
  }
  if (!q.found(Cause::rounding)) look_for_kinks(q);
  if (q.run.ok() && !q.found(Cause::sliding)) look_for_unseen(q);
  look_at_tolerances(q);
  compare_samples(q);
  share_out(q);
  const bool explained = std::ranges::any_of(q.why.findings, [](const Finding& finding) {
    return finding.cause != Cause::accuracy && finding.cause != Cause::stability &&
           finding.cause != Cause::events;
  });
  if (q.run.outcome.status == Status::newton_failed && !explained) {
    const double end = q.run.ends.back(), step = q.run.step_at(end);  // NaN: none was made
    q.add(Cause::newton, nan, end,
          fmt::format("the equations of {} step are not solved at t = {:.6g}{}",
                      std::isnan(step) ? "the first" : "a", end,
                      std::isnan(step) ? "" : fmt::format(", down to a step of {:.2g}", step)));
  }
  if (q.run.ok()) {
    const bool missed = q.found(Cause::pulse) || q.found(Cause::aliasing);
    if (!missed && !q.found(Cause::absolute)) look_for_growth_from_below(q);
    if (!missed) look_at_amplification(q);
    // Where no tolerance helps, a run that ends near the solution does so by chance.
    if (q.trusted && !explained && !q.no_tolerance_helps() && q.difference(q.run) > far_off)
      look_for_leaving(q);
    return;
  }
  if (q.run.outcome.status == Status::over_budget || !q.trusted || explained) return;
  // Its own states may have been far from the solution already.
  sample(q, *q.trusted, 0);
  compare_samples(q);
  std::erase_if(q.samples, [&](const Sample& s) { return s.at.t > q.run.ends.back(); });
  look_at_edge(q);
}

/// What the events of a run take; whether it ended since they follow one another without end.
bool look_at_events(Inquiry& q) {
  constexpr double least_share = 0.01;
  const Outcome& outcome = q.run.outcome;
  std::vector<double> times;
  for (const EventMet& met : outcome.events) times.push_back(met.t);
  if (times.empty()) return false;
  const std::string some =
      fmt::format("the first at t = {:.6g}, the last at {:.6g}", times.front(), times.back());
  const double since = without_end_since(times, q.run.request.stops.back() - q.c.t0);
  if (outcome.status == Status::step_too_small && !std::isnan(since)) {
    q.add(Cause::events, nan, since,
          fmt::format("{} events, {}: {}", times.size(), some, outcome.detail));
    q.why.advice =
        "an event that stops the run before, or that changes the equations to those of the motion "
        "that follows, lets it go on";
    return true;
  }
  times.erase(std::unique(times.begin(), times.end()), times.end());
  const auto steps = static_cast<double>(std::max<std::uint64_t>(1, outcome.counters.steps));
  const double share = std::min(1.0, static_cast<double>(times.size()) / steps);
  if (share >= least_share)
    q.add(Cause::events, share, times.front(),
          fmt::format("{} of {} steps end at events ({}), after each of which the run begins anew",
                      times.size(), outcome.counters.steps, some));
  return false;
}

/// Causes of a failure are found first and stay so. Of a run that ended what harms it leads where
/// it is far off, and then the largest share; that the error test bounds steps is as it should be,
/// and a defect comes before it.
void put_in_order(Inquiry& q) {
  const bool off = !(q.difference(q.run) <= 10 * wanted(q));
  const auto weight = [&](const Finding& f) {
    constexpr std::array harms{Cause::sliding,  Cause::astray,   Cause::pulse,
                               Cause::aliasing, Cause::absolute, Cause::amplification};
    if (off && std::ranges::find(harms, f.cause) != harms.end())
      return f.cause == Cause::amplification && !q.no_tolerance_helps() ? 1.5 : 2.0;
    if (std::isnan(f.share)) return 0.6;
    return f.cause == Cause::accuracy ? 0.5 * f.share : f.share;
  };
  std::ranges::stable_sort(
      q.why.findings, [&](const Finding& a, const Finding& b) { return weight(a) > weight(b); });
}

}  // namespace

Why why(const Case& c, const std::string& solver, const Request& request, double seconds,
        cases::Conditions conditions) {
  Inquiry q(c, solver, request, seconds, std::move(conditions));
  const Entrant* const entrant = c.entrants.find(solver);
  if (!entrant || !entrant->unfit.empty()) {
    q.run.outcome.status = q.why.outcome.status = Status::refused;
    q.run.ends = {c.t0};
    q.run.moments.push_back({c.t0, 0, 0, c.y0});
    q.add(Cause::unfit, nan, nan,
          solver + (entrant ? " does not fit: " + entrant->unfit : " is not there"));
    try_others(q);
    choose(q);
    return q.why;
  }
  q.run = q.make(c, solver, request, states_along(q), 0.5);
  q.progress.advance();
  q.why.outcome = q.run.outcome;
  q.why.reached = q.run.ok() ? request.stops.back() : q.run.ends.back();
  q.why.exact_steps = q.run.exact;
  if (q.run.steps() > 0)
    q.why.steps_left = (request.stops.back() - q.why.reached) / q.run.step_at(q.why.reached);
  q.why.error = q.error_at_end(request, q.run.outcome);
  if (q.run.outcome.status == Status::refused) q.add(Cause::unfit, nan, nan, q.run.outcome.detail);
  if (look_at_events(q)) return q.why;
  q.find_sizes(q.run);
  look_at_jacobian(q);
  const double step = q.adaptive() ? 0 : step_of(request, c.t0);
  sample(q, q.run, step);
  q.progress.advance();
  try_others(q);
  if (q.adaptive()) look_at_start(q), look_at_absolutes(q);
  // Where others reach the end, so does the solution, and a run that was cut short says no more;
  // nor does a fixed step about where it ends.
  const bool unpaid = q.run.outcome.status == Status::over_budget;
  if (!q.run.ok() && !q.found(Cause::unfit)) {
    if (!q.trusted)
      look_at_end(q, q.adaptive() ? q.run : q.along(farthest(q)));
    else if (q.adaptive() && !unpaid && !q.found(Cause::absolute))
      look_for_leaving(q);
  }
  if (q.adaptive()) {
    look_at_steps(q);
  } else if (q.known || q.run.ok()) {
    // Samples of a run that is far off are not samples of the solution.
    if (q.trusted && !(q.difference(q.run) <= far_off)) sample(q, *q.trusted, step);
    compare_samples(q);
    look_at_fixed_step(q);
  }
  if (q.run.ok() || unpaid) put_in_order(q);
  try_settings(q);
  try_as_exact(q);
  choose(q);
  q.why.difference = q.difference(q.run);
  if (q.known) {
    q.why.known_by = q.known->by;
    q.why.doubt = q.known->doubt;
  }
  return q.why;
}

}  // namespace odeum::why
