// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/why.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "odeum/advise/inquiry.hpp"
#include "odeum/core/clocks.hpp"

namespace odeum::advise {
const char* name_of(Cause cause) {
  constexpr std::array names{"accuracy",       "stability", "kink",     "sliding",
                             "pole",           "growth",    "singular", "domain",
                             "wrong_jacobian", "rounding",  "absolute", "energy",
                             "too_coarse",     "astray",    "newton",   "unfit"};
  return names[static_cast<std::size_t>(cause)];
}

Inquiry::Inquiry(const Case& given, const std::string& solver, const Request& request,
                 double seconds_given)
    : c(given), seconds(seconds_given), names(component_names(given)), region(solver) {
  why.solver = solver;
  why.request = request;
  run.request = request;
}

double Inquiry::left() const { return seconds - seconds_since(start); }

Run Inquiry::make(const Case& on, const std::string& solver, Request request, std::size_t moments,
                  double share) const {
  request.budget.evaluations = std::min<std::uint64_t>(request.budget.evaluations, 5'000'000);
  // To a tenth, since a message has it.
  request.budget.seconds = std::max(0.1, 0.1 * std::floor(5 * share * left()));
  return record(on, solver, request, moments);
}

void Inquiry::add(Cause cause, double share, double from, std::string text) {
  why.findings.push_back({cause, share, from, std::move(text)});
}

bool Inquiry::found(Cause cause) const {
  return std::ranges::any_of(why.findings,
                             [&](const Finding& each) { return each.cause == cause; });
}

namespace {

/// Of an adaptive run.
void look_at_steps(Inquiry& q) {
  Request looser = q.run.request;
  q.looser_by = looser.tolerance.relative > 1e-3 ? 0.01 : 100;
  looser.tolerance = looser.tolerance.with_relative(q.looser_by * looser.tolerance.relative);
  q.looser = q.make(q.c, q.why.solver, looser, 0, 0.3);
  q.looser->trace.times = {};
  look_for_kinks(q);
  look_at_tolerances(q);
  sample(q, q.run, 0);
  share_out(q);
  const bool explained = std::ranges::any_of(q.why.findings, [](const Finding& finding) {
    return finding.cause != Cause::accuracy && finding.cause != Cause::stability;
  });
  if (q.run.outcome.status == Status::newton_failed && !explained)
    q.add(Cause::newton, nan, q.run.ends.back(),
          fmt::format(
              "the equations of a step are not solved at t = {:.6g}, down to a step of {:.2g}",
              q.run.ends.back(), q.run.step_at(q.run.ends.back())));
  if (q.run.ok() && q.sure && !explained && q.difference(q.run) > far_off) look_for_leaving(q);
  if (q.run.ok() || q.run.outcome.status == Status::over_budget || !q.trusted || explained) return;
  // Its own states may have been far from the solution already.
  q.samples.clear();
  sample(q, *q.trusted, 0);
  std::erase_if(q.samples, [&](const Sample& s) { return s.at.t > q.run.ends.back(); });
  look_at_edge(q);
}

}  // namespace

Why why(const Case& c, const std::string& solver, const Request& request, double seconds) {
  Inquiry q(c, solver, request, seconds);
  const Entrant* const entrant = c.entrants.find(solver);
  if (!entrant || !entrant->unfit.empty()) {
    q.run.outcome.status = q.why.outcome.status = Status::refused;
    q.run.ends = {c.t0};
    q.run.moments.push_back({c.t0, 0, 0, c.y0});
    q.add(Cause::unfit, nan, nan, entrant ? entrant->unfit : "no such solver");
    try_others(q);
    choose(q);
    return q.why;
  }
  q.run = q.make(c, solver, request, 200, 0.3);
  q.why.outcome = q.run.outcome;
  q.why.outcome.states.clear();
  q.why.reached = q.run.ok() ? request.stops.back() : q.run.ends.back();
  q.why.exact_steps = q.run.exact;
  if (q.run.steps() > 0)
    q.why.steps_left = (request.stops.back() - q.why.reached) / q.run.step_at(q.why.reached);
  q.why.error = q.error_at_end(request, q.run.outcome);
  if (q.run.outcome.status == Status::refused) q.add(Cause::unfit, nan, nan, q.run.outcome.detail);
  try_others(q);
  // Where others reach the end, so does the solution, and a run that was cut short says no more;
  // nor does a fixed step about where it ends.
  const bool unpaid = q.run.outcome.status == Status::over_budget;
  if (!q.run.ok() && !q.found(Cause::unfit)) {
    if (!q.trusted)
      look_at_end(q, q.adaptive() ? q.run : q.along(farthest(q)));
    else if (q.adaptive() && !unpaid)
      look_for_leaving(q);
  }
  look_at_jacobian(q);
  if (q.adaptive()) {
    look_at_steps(q);
  } else if (q.trusted) {
    sample(q, *q.trusted, step_of(request, c.t0));
    look_at_fixed_step(q);
  }
  // Causes of a failure are found first and stay so. Of a run that ended the largest share leads;
  // that the error test bounds steps is as it should be, and a defect comes before it.
  if (q.run.ok() || unpaid)
    std::ranges::stable_sort(q.why.findings, [](const Finding& a, const Finding& b) {
      const auto weight = [](const Finding& f) {
        if (std::isnan(f.share)) return 0.6;
        return f.cause == Cause::accuracy ? 0.5 * f.share : f.share;
      };
      return weight(a) > weight(b);
    });
  try_settings(q);
  choose(q);
  q.why.difference = q.difference(q.run);
  return q.why;
}

}  // namespace odeum::advise
