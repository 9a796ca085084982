// SPDX-License-Identifier: BSD-3-Clause
// The runs that a run is compared with, and which of them does better.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "odeum/advise/inquiry.hpp"
#include "odeum/judge/errors.hpp"

namespace odeum::advise {
namespace {

/// Those that a run is compared with: explicit and implicit ones of several orders. Which of them
/// does better is measured.
constexpr std::array comparisons = {"odeum/dormand_prince853", "odeum/rodas4", "odeum/radau_iia5",
                                    "odeum/tsitouras54"};
/// The order in which one is taken for the truth, by its order and damping.
constexpr std::array by_trust = {"odeum/radau_iia5", "odeum/rodas4", "odeum/dormand_prince853",
                                 "odeum/tsitouras54"};
/// For a fixed step, where no tolerance was asked for.
constexpr double usual_tolerance = 1e-6;

/// Evaluations, and those that Jacobians by differences would take: about ten where it is sparse.
double work_of(const Counters& counters, const Case& c) {
  const std::size_t each =
      c.problem.view.sparsity ? std::min<std::size_t>(10, c.y0.size()) : c.y0.size();
  return static_cast<double>(counters.rhs_evaluations + counters.jacobian_evaluations * each);
}

Request comparable(const Inquiry& q) {
  Request request = q.run.request;
  request.record_steps = false;
  request.mode = Mode::adaptive;
  if (!q.adaptive()) set_tolerance(request, q.c, usual_tolerance);
  return request;
}

/// Whether another run is what to do instead: it ends well, in less than half of the work or with
/// less than half of the error of one that is far off.
bool is_better(const Inquiry& q, const Other& other) {
  if (other.status != Status::ok) return false;
  // Where the solution ends before, a run that ends before it does.
  if (other.reached < q.run.request.stops.back()) return !q.run.ok();
  const bool known = !std::isnan(other.error) && !std::isnan(q.why.error);
  const double theirs = known ? other.error : other.difference,
               ours = known ? q.why.error : q.difference(q.run);
  if (q.difference(q.run) > far_off) return !(theirs > 0.5 * ours);
  if (!q.run.ok()) return true;
  return work_of(other.counters, q.c) < 0.5 * work_of(q.why.outcome.counters, q.c) &&
         !(theirs > std::max(3 * ours, 1e-3 * far_off));
}

}  // namespace

double Inquiry::error_at_end(const Request& request, const Outcome& outcome) const {
  if (outcome.status != Status::ok || !c.truth.at) return nan;
  const double* const last = outcome.states.data() + outcome.states.size() - c.y0.size();
  const double error = judge::error_at(c, request.stops.back(), last);
  return std::isinf(error) ? nan : error;  // the solution has ended before
}

void Inquiry::find_sizes(const Run& from) {
  sizes.assign(c.y0.size(), 0);
  for (const Moment& at : from.moments)
    for (std::size_t i = 0; i < sizes.size(); ++i)
      if (std::isfinite(at.y[i])) sizes[i] = std::max(sizes[i], std::abs(at.y[i]));
  // A component that is the rounding of others has no size of its own.
  const double least = 16 * epsilon * *std::ranges::max_element(sizes);
  for (double& size : sizes)
    if (size < least) size = 0;
}

Run Inquiry::along(const Run& of) const { return make(c, of.solver, of.request, 60, 0.3); }

std::size_t Inquiry::also(const std::string& solver, const Request& request, double share) {
  others.push_back(make(c, solver, request, 0, share));
  Run& made = others.back();
  made.trace.times = {};  // nothing asks for them
  Other other{.solver = solver,
              .request = request,
              .status = made.outcome.status,
              .counters = made.outcome.counters,
              .reached = made.ends.back()};
  if (made.ok()) other.reached = request.stops.back();
  other.error = error_at_end(request, made.outcome);
  why.others.push_back(std::move(other));
  return others.size() - 1;
}

double Inquiry::difference(const Run& of) const {
  if (!trusted) return nan;
  if (!of.ok()) return infinity;
  if (of.request.stops.back() != trusted->request.stops.back()) return nan;
  const std::size_t n = c.y0.size();
  const double *const exact = trusted->outcome.states.data() + trusted->outcome.states.size() - n,
                      *const end = of.outcome.states.data() + of.outcome.states.size() - n;
  double most = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!(sizes[i] > 0)) continue;
    const double each = std::abs(end[i] - exact[i]) / sizes[i];
    if (!(each <= most)) most = each;
  }
  return most;
}

const Run& farthest(const Inquiry& q) {
  // A fixed step goes past the end of a solution.
  const Run* best = q.adaptive() || q.others.empty() ? &q.run : &q.others.front();
  for (const Run& other : q.others)
    if (other.ends.back() > best->ends.back()) best = &other;
  return *best;
}

void try_others(Inquiry& q) {
  for (const char* id : comparisons) {
    const Entrant* const entrant = q.c.entrants.find(id);
    if (id == q.why.solver && q.adaptive()) continue;
    if (entrant && entrant->unfit.empty()) q.also(id, comparable(q), 0.15);
  }
  const Run* best = nullptr;
  for (const char* id : by_trust)
    for (const Run& other : q.others)
      if (!best && other.solver == id && other.ok()) best = &other;
  if (!best && q.run.ok()) best = &q.run;
  if (!best) {
    q.find_sizes(q.run);
    return;
  }
  q.find_sizes(best == &q.run ? q.run : q.along(*best));
  // The same to a hundredth of the tolerance, of each component by its own size.
  Request tighter = comparable(q);
  const double relative = std::max(1e-13, 1e-2 * tighter.tolerance.relative);
  std::vector<double> absolute;
  for (std::size_t i = 0; i < q.sizes.size(); ++i)
    absolute.push_back(q.sizes[i] > 0 ? relative * q.sizes[i] : tighter.tolerance.absolute(i));
  tighter.tolerance = Tolerance(relative, absolute);
  Run trusted = q.make(q.c, best->solver, tighter, 60, 0.3);
  q.sure = trusted.ok();
  if (!trusted.ok() && best != &q.run) trusted = q.along(*best);
  if (!trusted.ok()) return;
  q.find_sizes(trusted);
  q.trusted = std::move(trusted);
}

void choose(Inquiry& q) {
  for (std::size_t k = 0; k < q.others.size(); ++k)
    q.why.others[k].difference = q.difference(q.others[k]);
  // Those that are near the solution come before those that are only nearer than the run.
  std::pair least{true, infinity};
  for (std::size_t k = 0; k < q.why.others.size(); ++k) {
    const Other& other = q.why.others[k];
    const std::pair cost{q.sure && other.difference > far_off, work_of(other.counters, q.c)};
    if (is_better(q, other) && cost < least) least = cost, q.why.better = k;
  }
}

void try_settings(Inquiry& q) {
  Request request = q.run.request;
  request.record_steps = false;
  const double t0 = q.c.t0, end = request.stops.back();
  const auto worth = [&](Cause cause) { return q.found(cause) && q.left() > 0.1 * q.seconds; };
  if (worth(Cause::rounding)) {
    request.tolerance =
        q.run.request.tolerance.with_relative(std::max(1e-12, request.tolerance.relative));
    q.also(q.why.solver, request, 0.3);
  } else if (worth(Cause::absolute)) {
    std::vector<double> absolute(q.sizes.size());
    for (std::size_t i = 0; i < absolute.size(); ++i)
      absolute[i] = std::min(request.tolerance.absolute(i),
                             q.sizes[i] > 0 ? request.tolerance.relative * q.sizes[i] : infinity);
    request.tolerance = Tolerance(request.tolerance.relative, absolute);
    q.also(q.why.solver, request, 0.3);
  }
  if (worth(Cause::kink)) {
    // Steps that end there see a smooth right-hand side on either side.
    request = q.run.request;
    request.stops.clear();
    for (const Kink& kink : q.kinks)
      if (kink.t > t0 && kink.t < end) request.stops.push_back(kink.t);
    request.stops.push_back(end);
    const Outcome parts = q.make(q.c, q.why.solver, request, 0, 0.3).outcome;
    if (parts.status == Status::ok &&
        parts.counters.rhs_evaluations < q.why.outcome.counters.rhs_evaluations)
      q.why.advice = fmt::format("with steps that end at the kinks the run takes {} evaluations",
                                 parts.counters.rhs_evaluations);
  }
  for (const Finding& finding : q.why.findings)
    if (finding.cause == Cause::pole || finding.cause == Cause::singular) {
      request = q.run.request;
      request.record_steps = false;
      request.stops = {t0 + 0.99 * (std::min(finding.from, end) - t0)};
      if (request.stops.front() > t0) q.also(q.why.solver, request, 0.3);
      break;
    }
}

}  // namespace odeum::advise
