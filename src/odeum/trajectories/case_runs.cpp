// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/case_runs.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "odeum/core/numbers.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/record/csv.hpp"

namespace odeum::trajectories {
namespace {

record::CsvRow row_of(const Case& c, const std::string& library, const std::string& solver) {
  return record::CsvRow().text(c.id).text(library).text(solver);
}

std::vector<double> exact_at(const Case& c, double t) {
  std::vector<double> y(c.y0.size(), nan);
  if (t == c.t0) return c.y0;
  if (!c.truth.at(t, y.data())) y.assign(y.size(), nan);
  return y;
}

double largest_error(const Case& c, const double* y, const std::vector<double>& exact) {
  double largest = 0;
  for (const std::size_t i : judge::measured_components(c)) {
    const double error = std::abs(y[i] - exact[i]);
    if (!(error <= largest)) largest = error;
  }
  return largest;
}

}  // namespace

ExactStates exact_states(const Case& c, const std::vector<CaseRun>& runs) {
  std::set<double> times{c.t0};
  double end = c.t0;
  for (const CaseRun& run : runs) {
    times.insert(run.request.stops.begin(), run.request.stops.end());
    end = std::max(end, run.request.stops.back());
  }
  const std::size_t outputs = times.size();
  for (const double t : c.stops)
    if (t <= end) times.insert(t);
  ExactStates exact;
  for (const double t : times) {
    std::vector<double> y = exact_at(c, t);
    if (std::isnan(y.front())) continue;
    exact.times.push_back(t);
    exact.states.push_back(std::move(y));
  }
  exact.everywhere = exact.times.size() >= outputs;
  return exact;
}

record::CsvTable case_trajectory(const Case& c, const std::vector<CaseRun>& runs,
                                 const ExactStates& exact) {
  std::string columns = "case,library,solver,time";
  for (const std::string& name : component_names(c)) columns += "," + name;
  record::CsvTable table(columns + ",energy,error", true);
  const std::size_t n = c.y0.size();
  const auto add = [&](const std::string& library, const std::string& solver, double t,
                       const double* y, double error) {
    record::CsvRow row = row_of(c, library, solver).number(t);
    for (std::size_t i = 0; i < n; ++i) row.number(y[i]);
    table.add(row.number(c.energy ? c.energy(y) : nan).number(error));
  };
  for (const CaseRun& run : runs) {
    const SolverInfo& info = run.entrant->info;
    add(info.library, info.method, c.t0, c.y0.data(), 0);
    for (std::size_t k = 0; k < run.reached(n); ++k) {
      const double t = run.request.stops[k], *const y = run.outcome.states.data() + k * n;
      add(info.library, info.method, t, y, largest_error(c, y, exact_at(c, t)));
    }
  }
  for (std::size_t k = 0; k < exact.times.size(); ++k)
    add("truth", "exact", exact.times[k], exact.states[k].data(), 0);
  return table;
}

record::CsvTable case_solution(const Case& c, const std::vector<CaseRun>& runs) {
  record::CsvTable table("case,library,solver,status,time,component,value,exact,error,name");
  const std::vector<std::string> names = component_names(c);
  const std::size_t n = c.y0.size();
  for (const CaseRun& run : runs) {
    if (run.outcome.status != Status::ok) continue;
    const double t = run.request.stops.back();
    const std::vector<double> exact = exact_at(c, t);
    const double* const y = run.outcome.states.data() + (run.reached(n) - 1) * n;
    for (std::size_t i = 0; i < n; ++i)
      table.add(row_of(c, run.entrant->info.library, run.entrant->info.method)
                    .text(to_string(run.outcome.status))
                    .number(t)
                    .count(i)
                    .number(y[i])
                    .number(exact[i])
                    .number(y[i] - exact[i])
                    .text(names[i]));
  }
  return table;
}

record::CsvTable case_steps(const Case& c, const std::vector<CaseRun>& runs) {
  record::CsvTable table("case,library,solver,time,step", true);
  for (const CaseRun& run : runs) {
    double before = c.t0;
    for (const double t : run.outcome.step_ends) {
      table.add(row_of(c, run.entrant->info.library, run.entrant->info.method)
                    .number(t)
                    .number(t - before));
      before = t;
    }
  }
  return table;
}

record::CsvTable case_schemes(const Case& c, const std::vector<CaseRun>& runs) {
  std::string columns = "case,library,solver,time";
  for (const std::string& name : component_names(c)) columns += "," + name;
  record::CsvTable table(columns, true);
  std::vector<double> state(c.y0.size());
  for (const CaseRun& run : runs) {
    if (std::isnan(difference_to_scheme(c, run))) continue;
    const double h = run.step(c.t0);
    for (const double t : run.request.stops) {
      c.scheme(run.entrant->info.id(), h, std::round((t - c.t0) / h), state.data());
      record::CsvRow row = row_of(c, run.entrant->info.library, run.entrant->info.method).number(t);
      for (const double value : state) row.number(value);
      table.add(row);
    }
  }
  return table;
}

double difference_to_scheme(const Case& c, const CaseRun& run) {
  if (!c.scheme || run.request.mode != Mode::fixed) return nan;
  const std::size_t n = c.y0.size();
  std::vector<double> y(n);
  double largest = nan;
  for (std::size_t k = 0; k < run.reached(n); ++k) {
    const double steps = std::round((run.request.stops[k] - c.t0) / run.step(c.t0));
    if (!c.scheme(run.entrant->info.id(), run.step(c.t0), steps, y.data())) return nan;
    for (std::size_t i = 0; i < n; ++i)
      largest = std::fmax(largest, std::abs(run.outcome.states[k * n + i] - y[i]));
  }
  return largest;
}

}  // namespace odeum::trajectories
