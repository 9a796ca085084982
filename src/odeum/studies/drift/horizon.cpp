// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "odeum/core/numbers.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/studies/drift/drift.hpp"

namespace odeum::study {
namespace {

constexpr double threshold = 1e-3;

/// The times within five horizons of the case at which the truth is known, out of twenty a horizon.
std::vector<double> times_of_truth(const Case& c) {
  std::vector<double> times, exact(c.y0.size());
  for (int k = 1; k <= 100; ++k) {
    const double t = c.t0 + (c.stops.back() - c.t0) * k / 20;
    if (c.truth.at(t, exact.data())) times.push_back(t);
  }
  return times;
}

/// Settings from coarse to fine: steps that fall on all those times, and tolerances.
std::vector<Request> settings_of(const Case& c, const SolverInfo& info,
                                 const std::vector<double>& times) {
  std::vector<Request> requests;
  Request request;
  request.stops = times;
  if (info.fixed) {
    const double twentieth = (c.stops.back() - c.t0) / 20;
    const auto pieces = std::llround((times.back() - c.t0) / twentieth);
    for (const int steps_a_piece : {16, 64, 256}) {
      request.steps = static_cast<std::uint64_t>(pieces * steps_a_piece);
      request.budget.evaluations = 64 * request.steps;
      requests.push_back(request);
    }
  }
  if (info.adaptive) {
    request.mode = Mode::adaptive;
    request.budget.evaluations = 400'000;
    for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
      set_tolerance(request, c, tolerance);
      requests.push_back(request);
    }
  }
  return requests;
}

}  // namespace

double time_of_reaching(const std::vector<double>& times, const std::vector<double>& errors,
                        double limit) {
  for (std::size_t k = 0; k < errors.size(); ++k) {
    if (errors[k] < limit) continue;
    if (k == 0 || !(errors[k - 1] > 0)) return times[k];
    const double share = std::log(limit / errors[k - 1]) / std::log(errors[k] / errors[k - 1]);
    return times[k - 1] + share * (times[k] - times[k - 1]);
  }
  return nan;
}

std::vector<HorizonRow> measure_horizons(const Case& c, const Entrant& entrant) {
  const auto blank = named_row<HorizonRow>(c, entrant.info);
  if (!entrant.unfit.empty()) return {not_applicable(blank, entrant.unfit)};
  const std::vector<double> times = times_of_truth(c);
  std::vector<HorizonRow> rows;
  for (const Request& request : settings_of(c, entrant.info, times)) {
    HorizonRow row;
    Outcome outcome = entrant.solve(request);
    row.take(c, entrant.info, request, outcome);
    // Times before a failure count: the horizon may lie there.
    const std::size_t reached = outcome.states.size() / c.y0.size();
    const std::vector<double> seen(times.begin(),
                                   times.begin() + static_cast<std::ptrdiff_t>(reached));
    std::vector<double> errors;
    for (const judge::StopError& error : judge::Judge(c, seen).errors(outcome))
      errors.push_back(error.error_max);
    row.horizon = time_of_reaching(seen, errors, threshold);
    if (!std::isnan(row.horizon)) {
      row.status = to_string(Status::ok);
      row.detail.clear();
    } else if (outcome.status == Status::ok) {
      row.detail = "within 1e-3 to the last time of the truth";
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace odeum::study
