// SPDX-License-Identifier: BSD-3-Clause
// The runs that a run is compared with, and what is known of the solution by them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "odeum/judge/errors.hpp"
#include "odeum/why/inquiry.hpp"

namespace odeum::why {
namespace {

/// Solvers that a run is compared with, from each family that runs to a tolerance, explicit and
/// implicit, of low and of high order. Which of them does better is measured; those of another
/// family come first, since two that agree have to be of two families.
constexpr std::array comparisons = {"cvode/bdf",
                                    "odeum/dormand_prince853",
                                    "odeum/radau_iia5",
                                    "odeum/rodas4",
                                    "odeum/tsitouras54",
                                    "cvode/adams",
                                    "odeum/verner98",
                                    "odeum/rodas5p",
                                    "odeum/radau_iia_variable",
                                    "odeum/gragg_bulirsch_stoer",
                                    "odeum/sdirk4",
                                    "odeum/taylor"};
}  // namespace

Request comparable(const Inquiry& q) {
  Request request = q.run.request;
  request.record_steps = false;
  request.mode = Mode::adaptive;
  if (q.adaptive()) return request;
  set_tolerance(request, q.c, usual_tolerance);
  double start = 0;
  for (const double y : q.c.y0) start = std::max(start, std::abs(y));
  if (q.run.ok() || !(start > 0)) return request;
  // The scale along a solution that ends may be far beyond what it was at the start.
  std::vector<double> absolute(q.c.y0.size());
  for (std::size_t i = 0; i < absolute.size(); ++i)
    absolute[i] = std::min(request.tolerance.absolute(i), usual_tolerance * start);
  request.tolerance = Tolerance(usual_tolerance, absolute);
  return request;
}

double work_of(const Counters& counters, const Case& c) {
  const std::size_t each =
      c.problem.view.sparsity ? std::min<std::size_t>(10, c.y0.size()) : c.y0.size();
  return static_cast<double>(counters.rhs_evaluations + counters.jacobian_evaluations * each);
}

std::size_t states_along(const Inquiry& q) {
  constexpr std::size_t most = 400, numbers = 100'000;
  return std::clamp<std::size_t>(numbers / q.c.y0.size(), 60, most);
}

double Inquiry::error_at_end(const Request& request, const Outcome& outcome) const {
  if (outcome.status != Status::ok || !c.truth.at) return nan;
  const double* const last = outcome.states.data() + outcome.states.size() - c.y0.size();
  const double error = judge::error_at(c, request.stops.back(), last);
  return std::isinf(error) ? nan : error;  // the solution has ended before
}

void Inquiry::find_sizes(const Run& from) {
  sizes.assign(c.y0.size(), 0);
  const auto extend = [&](const std::vector<double>& y) {
    for (std::size_t i = 0; i < sizes.size(); ++i)
      if (std::isfinite(y[i])) sizes[i] = std::max(sizes[i], std::abs(y[i]));
  };
  if (c.truth.closed_form) {
    constexpr int looks = 200;
    std::vector<double> y = c.y0;
    for (int k = 0; k <= looks; ++k)
      if (c.truth.at(c.t0 + (run.request.stops.back() - c.t0) * k / looks, y.data())) extend(y);
  } else {
    for (const Moment& at : from.moments) extend(at.y);
  }
  // A component that is the rounding of others has no size of its own.
  const double least = 16 * epsilon * *std::ranges::max_element(sizes);
  for (double& size : sizes)
    if (size < least) size = 0;
}

Run Inquiry::along(const Run& of) const {
  return make(c, of.solver, of.request, states_along(*this), 0.3);
}

std::size_t Inquiry::also(const std::string& solver, const Request& request, double share) {
  for (std::size_t k = 0; k < others.size(); ++k) {
    const Request& made = others[k].request;
    if (others[k].solver == solver && others[k].ok() && made.mode == request.mode &&
        made.steps == request.steps && made.stops == request.stops &&
        made.tolerance.relative == request.tolerance.relative &&
        made.tolerance.absolutes() == request.tolerance.absolutes())
      return k;
  }
  keep(make(c, solver, request, 0, share));
  return others.size() - 1;
}

void Inquiry::keep(const Run& from) {
  others.push_back(from);
  Run& made = others.back();
  const Request& request = from.request;
  made.trace.times = {};  // nothing asks for them
  made.moments.resize(1);
  Other other;
  other.take(c, c.entrants.find(made.solver)->info, request, made.outcome);
  other.request = request;
  other.reached = made.ok() ? request.stops.back() : made.ends.back();
  other.error = error_at_end(request, made.outcome);
  other.request.record_steps = false;
  why.others.push_back(std::move(other));
}

double Inquiry::distance(const double* one, const double* other) const {
  double most = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (!(sizes[i] > 0)) continue;
    const double each = std::abs(one[i] - other[i]) / sizes[i];
    if (!(each <= most)) most = each;
  }
  return most;
}

double Inquiry::apart(const Run& one, const Run& other) const {
  return distance(one.end(), other.end());
}

double Inquiry::difference(const Run& of) const {
  if (!known) return nan;
  if (!of.ok()) return infinity;
  if (of.request.stops.back() != run.request.stops.back()) return nan;
  return distance(of.end(), known->end.data());
}

bool Inquiry::time_for_more(double share) const { return left() > share * seconds; }

void try_others(Inquiry& q) {
  // Few evaluations at first: whoever needs ten times those of another is none to compare with.
  constexpr std::uint64_t least = 200'000, times = 5;
  std::uint64_t most = 1'000'000;
  for (const char* id : comparisons) {
    const Entrant* const entrant = q.c.entrants.find(id);
    if (!entrant || !entrant->unfit.empty() || (id == q.why.solver && q.adaptive())) continue;
    if (!q.time_for_more(0.6)) break;
    Request request = comparable(q);
    request.budget.evaluations = most;
    const Run& made = q.others[q.also(id, request, 0.12)];
    q.progress.advance();
    if (made.ok())
      most = std::min(most, std::max(least, times * made.outcome.counters.rhs_evaluations));
  }
  find_known(q);
}

}  // namespace odeum::why
