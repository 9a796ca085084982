// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/case_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "odeum/core/numbers.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/record/csv.hpp"

namespace odeum::trajectories {
namespace {

std::vector<double> exact_at(const Case& c, double t) {
  std::vector<double> y(c.y0.size(), nan);
  if (t == c.t0) return c.y0;
  if (!c.truth.at(t, y.data())) y.assign(y.size(), nan);
  return y;
}

/// The outputs that a run lacks, in which steps that end on outputs have failed, by runs of their
/// own from the start, as far as these take no more than a hundred times the work of one to the
/// end; NaN beyond, and where they fail, too.
void complete_outputs(const Entrant& entrant, Request request, const Outcome& alone,
                      const std::vector<double>& stops, Outcome& outcome) {
  const std::size_t n = alone.states.size();
  const std::size_t reached = outcome.states.size() / n;
  std::uint64_t spent = 0;
  for (std::size_t k = reached; k < stops.size(); ++k) {
    request.stops = {stops[k]};
    Outcome one;
    one.status = Status::over_budget;
    if (k + 1 < stops.size() && spent <= 100 * alone.counters.work) one = entrant.solve(request);
    spent += one.counters.work;
    if (one.status != Status::ok) one.states.assign(n, nan);
    outcome.states.insert(outcome.states.end(), one.states.begin(), one.states.end());
  }
  outcome.detail = fmt::format(
      "from t = {:.6g} on each output is that of a run of its own, nan where that fails too, since "
      "steps that end on all of them fail there: {}",
      stops[reached], outcome.detail);
}

/// The states of the scheme's own closed form at the outputs of a run; none where none is known.
std::vector<double> scheme_states(const Case& c, const CaseRun& run) {
  if (!c.scheme || run.request.mode != Mode::fixed || run.outcome.states.empty()) return {};
  const double h = step_of(run.request, c.t0);
  std::vector<double> states(run.request.stops.size() * c.y0.size());
  double* y = states.data();
  for (const double t : run.request.stops) {
    if (!c.scheme(run.entrant->info.id(), h, std::round((t - c.t0) / h), y)) return {};
    y += c.y0.size();
  }
  return states;
}

}  // namespace

Outcome solve_with_outputs(const Entrant& entrant, const Request& request) {
  Outcome outcome = entrant.solve(request);
  if (request.mode == Mode::fixed || !request.over_stops || request.stops.size() == 1)
    return outcome;
  Request without = request;
  without.stops = {request.stops.back()};
  without.over_stops = false;
  Outcome alone = entrant.solve(without);
  if (alone.status == Status::ok && outcome.status != Status::ok)
    complete_outputs(entrant, without, alone, request.stops, outcome);
  else if (!alone.detail.empty())
    outcome.detail = alone.detail;
  if (alone.status == Status::ok)
    std::ranges::copy(alone.states,
                      outcome.states.end() - static_cast<std::ptrdiff_t>(alone.states.size()));
  outcome.status = alone.status;
  outcome.t = alone.t;
  outcome.counters = alone.counters;
  outcome.step_ends = std::move(alone.step_ends);
  outcome.events = std::move(alone.events);
  return outcome;
}

ExactStates true_states(const Case& c, const std::vector<double>& times) {
  ExactStates exact{.floor = c.truth.floor, .source = c.truth.source};
  for (const double t : times) {
    std::vector<double> y = exact_at(c, t);
    if (std::isnan(y.front()))
      exact.everywhere = false;
    else
      exact.states.emplace(t, std::move(y));
  }
  return exact;
}

ExactStates exact_states(const Case& c, const std::vector<CaseRun>& runs) {
  std::set<double> times{c.t0};
  for (const CaseRun& run : runs) times.insert(run.request.stops.begin(), run.request.stops.end());
  ExactStates exact = true_states(c, {times.begin(), times.end()});
  for (const double t : c.stops)
    if (t <= *times.rbegin()) exact.states.merge(true_states(c, {t}).states);
  return exact;
}

record::Records case_trajectory(const Case& c, const std::vector<CaseRun>& runs,
                                const ExactStates& exact) {
  record::Records table{{"case", "library", "solver", "time"}};
  for (const std::string& name : component_names(c)) table.columns.push_back(name);
  for (const std::string& name : c.outputs.names)
    table.columns.push_back(name + (std::ranges::count(table.columns, name) > 0 ? "_" : ""));
  table.columns.insert(table.columns.end(), {"energy", "error"});
  const std::size_t n = c.y0.size();
  const auto add = [&](const std::string& library, const std::string& solver, double t,
                       const double* y, double error) {
    auto& row = table.rows.emplace_back();
    row = {c.id, library, solver, t};
    row.insert(row.end(), y, y + n);
    std::vector<double> outputs(c.outputs.names.size());
    if (c.outputs.at) c.outputs.at(t, y, outputs.data());
    row.insert(row.end(), outputs.begin(), outputs.end());
    row.insert(row.end(), {c.energy ? c.energy(y) : nan, error});
  };
  for (const CaseRun& run : runs) {
    const SolverInfo& info = run.entrant->info;
    add(info.library, info.method, c.t0, c.y0.data(), 0);
    auto event = run.outcome.events.begin();
    for (std::size_t k = 0; k < run.reached(n); ++k) {
      const double t = run.request.stops[k], *const y = run.outcome.states.data() + k * n;
      for (; event != run.outcome.events.end() && event->t <= t; ++event) {
        add(info.library, info.method, event->t, event->before.data(), nan);
        if (event->t < t) add(info.library, info.method, event->t, event->after.data(), nan);
      }
      add(info.library, info.method, t, y, judge::error_of(c, y, exact_at(c, t).data()));
    }
  }
  for (const auto& [t, y] : exact.states) add("truth", "exact", t, y.data(), 0);
  return table;
}

record::Records case_solution(const Case& c, const std::vector<CaseRun>& runs) {
  record::Records table{{"case", "library", "solver", "status", "time", "component", "value",
                         "exact", "difference", "unit", "name"}};
  const std::vector<std::string> names = component_names(c);
  const std::size_t n = c.y0.size();
  for (const CaseRun& run : runs) {
    if (run.outcome.status != Status::ok) continue;
    const SolverInfo& info = run.entrant->info;
    const double t = run.request.stops.back();
    const std::vector<double> exact = exact_at(c, t);
    const double* const y = run.outcome.states.data() + (run.reached(n) - 1) * n;
    for (std::size_t i = 0; i < n; ++i)
      table.rows.push_back({c.id, info.library, info.method, to_string(run.outcome.status), t, i,
                            y[i], exact[i], y[i] - exact[i], c.units.of(i, exact[i]), names[i]});
  }
  return table;
}

record::Records case_steps(const Case& c, const std::vector<CaseRun>& runs) {
  record::Records table{{"case", "library", "solver", "time", "step"}};
  for (const CaseRun& run : runs) {
    const SolverInfo& info = run.entrant->info;
    std::vector<double> ends{c.t0};
    ends.insert(ends.end(), run.outcome.step_ends.begin(), run.outcome.step_ends.end());
    if (ends.size() == 1) continue;
    const std::size_t in_group = 1 + (ends.size() - 2) / most_groups_of_steps;
    for (std::size_t first = 1; first < ends.size(); first += in_group) {
      std::size_t shortest = first, longest = first;
      for (std::size_t k = first; k < std::min(first + in_group, ends.size()); ++k) {
        if (ends[k] - ends[k - 1] < ends[shortest] - ends[shortest - 1]) shortest = k;
        if (ends[k] - ends[k - 1] > ends[longest] - ends[longest - 1]) longest = k;
      }
      for (const std::size_t k : std::set{shortest, longest})
        table.rows.push_back({c.id, info.library, info.method, ends[k], ends[k] - ends[k - 1]});
    }
  }
  return table;
}

namespace {

/// At most so many ends of steps of a run, evenly in steps, as far as it came.
std::vector<double> chosen_ends(const Case& c, const CaseRun& run) {
  constexpr std::uint64_t most = 2000;
  std::vector<double> ends;
  if (run.request.mode == Mode::fixed) {
    const FixedGrid grid(c.t0, run.request);
    const std::uint64_t apart = 1 + grid.steps() / most;
    for (std::uint64_t i = apart; i < grid.steps(); i += apart) ends.push_back(grid.t(i));
  } else {
    const std::vector<double>& all = run.outcome.step_ends;
    for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / most) ends.push_back(all[i]);
  }
  while (!ends.empty() && ends.back() >= run.outcome.t) ends.pop_back();
  return ends;
}

}  // namespace

record::Records case_curves(const Case& c, const std::vector<CaseRun>& runs) {
  record::Records table{{"library", "solver", "time"}};
  for (const std::string& name : component_names(c)) table.columns.push_back(name);
  table.columns.emplace_back("energy");
  const std::size_t n = c.y0.size();
  constexpr std::uint64_t most_work = 20'000'000;  // some seconds
  for (const CaseRun& run : runs) {
    if (!run.entrant->solve || run.outcome.counters.work > most_work) continue;
    Request request = run.request;
    request.stops = chosen_ends(c, run);
    if (request.stops.size() <= run.reached(n) / 2) continue;
    request.stops.push_back(run.outcome.t);
    request.record_steps = false;
    if (request.mode == Mode::fixed) request.stops.back() = run.request.stops.back();
    const Outcome outcome = run.entrant->solve(request);
    for (std::size_t k = 0; k * n < outcome.states.size(); ++k) {
      const double* const y = outcome.states.data() + k * n;
      auto& row = table.rows.emplace_back();
      row = {run.entrant->info.library, run.entrant->info.method, request.stops[k]};
      row.insert(row.end(), y, y + n);
      row.emplace_back(c.energy ? c.energy(y) : nan);
    }
  }
  return table;
}

record::Records case_schemes(const Case& c, const std::vector<CaseRun>& runs) {
  record::Records table{{"case", "library", "solver", "time"}};
  for (const std::string& name : component_names(c)) table.columns.push_back(name);
  const std::size_t n = c.y0.size();
  for (const CaseRun& run : runs) {
    const SolverInfo& info = run.entrant->info;
    const std::vector<double> states = scheme_states(c, run);
    for (std::size_t k = 0; k * n < states.size(); ++k) {
      auto& row = table.rows.emplace_back();
      row = {c.id, info.library, info.method, run.request.stops[k]};
      row.insert(row.end(), states.data() + k * n, states.data() + (k + 1) * n);
    }
  }
  return table;
}

double difference_to_scheme(const Case& c, const CaseRun& run) {
  const std::vector<double> states = scheme_states(c, run);
  double largest = nan;
  for (std::size_t i = 0; i < std::min(states.size(), run.outcome.states.size()); ++i)
    largest = std::fmax(largest, std::abs(run.outcome.states[i] - states[i]));
  return largest;
}

}  // namespace odeum::trajectories
