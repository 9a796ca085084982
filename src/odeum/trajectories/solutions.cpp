// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/solutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "odeum/core/numbers.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/report/columns.hpp"
#include "odeum/report/text.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::trajectories {
namespace {

using Json = nlohmann::ordered_json;

constexpr int fine = 1000;     // levels over the range of a component
constexpr int unknown = 9999;  // of a logarithm
/// How far a computed curve may lie from the truth at the stops, over the largest component there.
constexpr double most_apart = 1e-6;

int logarithm(double error) {
  if (std::isnan(error)) return unknown;
  if (!(error > 1e-20)) return -2000;
  if (!(error < 1e30)) return 3000;
  return static_cast<int>(std::lround(100 * std::log10(error)));
}

/// The exponent of a tolerance as rows have it, in millionths of a decade: runs to tolerances of
/// one decade are told apart. The page computes the same.
std::uint64_t exponent_of(double tolerance) {
  const double shown = std::stod(report::json_number(tolerance));
  return static_cast<std::uint64_t>(std::llround(-1e6 * std::log10(shown)));
}

/// The largest value of the measured components at the stops.
double largest_of(const Case& c) {
  double largest = 0;
  std::vector<double> y(c.y0.size());
  for (const double stop : c.stops)
    if (c.truth.at(stop, y.data()))
      for (const std::size_t i : judge::measured_components(c))
        largest = std::fmax(largest, std::abs(y[i]) / c.units.of(i, y[i]));
  return largest;
}

// A run through the times by the extrapolation method of the computed references.
ExactStates computed_curve(const Case& c, const std::vector<double>& times) {
  std::set<double> with_stops(times.begin(), times.end());
  for (const double stop : c.stops)
    if (stop <= times.back()) with_stops.insert(stop);
  const std::vector<double> all(with_stops.begin(), with_stops.end());
  const std::size_t n = c.y0.size();
  truth::System system;
  system.states = n;
  system.t0 = c.t0;
  system.work = 10 * static_cast<double>(n);
  system.y0.assign(c.y0.begin(), c.y0.end());
  std::vector<double> y(n), f(n);
  system.rhs = [&](truth::Real t, const truth::Real* state, truth::Real* slope) {
    std::copy_n(state, n, y.begin());
    c.problem.view.rhs(c.problem.view.problem, static_cast<double>(t), y.data(), f.data());
    std::copy_n(f.begin(), n, slope);
  };
  // The right-hand side is rounded to double; more digits than those of the truth are not seen.
  const double scale = largest_of(c),
               tolerance = std::clamp(0.01 * c.truth.floor / scale, 1e-13, 1e-10);
  const truth::Run run = truth::extrapolation_run(system, {all.begin(), all.end()},
                                                  {.tolerance = tolerance, .budget = 1e9});
  ExactStates curve{.source = "extrapolation in extended precision"};
  double apart = 0;
  bool checked = false;
  for (std::size_t k = 0; k < run.states.size(); ++k) {
    const std::vector<double> state(run.states[k].begin(), run.states[k].end());
    if (std::ranges::binary_search(c.stops, all[k]) && c.truth.at(all[k], y.data())) {
      checked = true;
      apart = std::fmax(apart, judge::error_of(c, state.data(), y.data()));
    }
    curve.states.emplace(all[k], state);
  }
  curve.floor = apart + c.truth.floor;
  curve.everywhere = checked && run.end.empty() && apart <= most_apart * scale;
  return curve;
}

}  // namespace

Request drawn_request(const Case& c, Mode mode, double setting, double end, const Budget& budget,
                      std::uint64_t outputs) {
  Request request;
  request.mode = mode;
  if (mode == Mode::fixed)
    request.steps = static_cast<std::uint64_t>(std::llround((end - c.t0) / setting));
  else
    set_tolerance(request, c, setting);
  request.over_stops = true;
  request.budget = budget;
  const std::uint64_t parts = mode == Mode::fixed ? request.steps : outputs;
  const std::uint64_t apart = (parts + outputs - 1) / outputs;
  for (std::uint64_t i = apart; i < parts; i += apart)
    request.stops.push_back(c.t0 +
                            static_cast<double>(i) * ((end - c.t0) / static_cast<double>(parts)));
  request.stops.push_back(end);
  return request;
}

std::vector<std::size_t> drawn_components(const Case& c) {
  const std::size_t n = c.y0.size();
  if (n > 4 && c.problem.view.second_order()) {
    std::vector<double> y(n), moved(n / 2);
    for (const double stop : c.stops)
      if (c.truth.at(stop, y.data()))
        for (std::size_t i = 0; i < n / 2; ++i)
          moved[i] = std::fmax(moved[i], std::abs(y[i] - c.y0[i]));
    const auto most = static_cast<std::size_t>(std::ranges::max_element(moved) - moved.begin());
    return {most, n / 2 + most};
  }
  std::vector<std::size_t> all(std::min<std::size_t>(n, 4));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

ExactStates exact_curve(const Case& c, const std::vector<double>& times) {
  ExactStates known = true_states(c, times);
  if (known.everywhere || times.empty() || c.problem.events) return known;
  // A truth of fewer digits can't check the curve.
  if (c.y0.size() <= dense_dimension_limit && c.truth.floor <= most_apart * largest_of(c))
    if (ExactStates computed = computed_curve(c, times); computed.everywhere) return computed;
  return known;
}

Solutions::Solutions(const Case& c, double end, ExactStates exact)
    : case_(c),
      end_(end),
      exact_(std::move(exact)),
      components_(drawn_components(c)),
      low_(components_.size()),
      high_(components_.size()) {
  for (std::size_t k = 0; k < components_.size(); ++k) low_[k] = high_[k] = c.y0[components_[k]];
  if (c.energy) energy_scale_ = std::abs(c.energy(c.y0.data()));
  for (const auto& [t, y] : exact_.states) {
    for (std::size_t k = 0; k < components_.size(); ++k) {
      if (!std::isfinite(y[components_[k]])) continue;
      low_[k] = std::min(low_[k], y[components_[k]]);
      high_[k] = std::max(high_[k], y[components_[k]]);
    }
    if (c.energy) energy_scale_ = std::fmax(energy_scale_, std::abs(c.energy(y.data())));
  }
  for (std::size_t k = 0; k < components_.size(); ++k) {
    const double size = high_[k] - low_[k],
                 room = size > 0 ? 0.1 * size : std::fmax(std::abs(high_[k]), 1);
    low_[k] -= room;
    high_[k] += room;
  }
}

std::vector<int> Solutions::levels(const double* y) const {
  std::vector<int> values;
  for (std::size_t k = 0; k < components_.size(); ++k) {
    const double place = (y[components_[k]] - low_[k]) / (high_[k] - low_[k]);
    // The plot extends half the exact solution's range beyond it on each side.
    values.push_back(static_cast<int>(
        std::lround(fine * std::clamp(std::isnan(place) ? 9.0 : place, -0.5, 1.5))));
  }
  return values;
}

// The number of a list of curves; one that lies within a level of an earlier one is that one.
std::size_t Solutions::curve(std::vector<int> values) {
  for (std::size_t i = 0; i < curves_.size(); ++i)
    if (std::equal(values.begin(), values.end(), curves_[i].begin(), curves_[i].end(),
                   [](int a, int b) { return std::abs(a - b) <= 1; }))
      return i;
  curves_.push_back(std::move(values));
  return curves_.size() - 1;
}

void Solutions::add(const CaseRun& run) {
  const Request& request = run.request;
  const std::size_t n = case_.y0.size(), reached = run.reached(n);
  if (reached == 0) return;
  std::vector<int> values, errors, energies;
  bool some_error = false;
  for (std::size_t k = 0; k < reached; ++k) {
    const double* const y = run.outcome.states.data() + k * n;
    for (const int level : levels(y)) values.push_back(level);
    const auto exact = exact_.states.find(request.stops[k]);
    if (exact == exact_.states.end()) {
      errors.push_back(unknown);
      continue;
    }
    some_error = true;
    errors.push_back(logarithm(judge::error_of(case_, y, exact->second.data())));
    if (case_.energy)
      energies.push_back(logarithm(std::abs(case_.energy(y) - case_.energy(exact->second.data())) /
                                   energy_scale_));
  }
  const bool fixed = request.mode == Mode::fixed;
  const std::string key =
      fmt::format("{}:{}:{}", report::plain(run.entrant->info.id()), to_string(request.mode),
                  fixed ? request.steps : exponent_of(request.tolerance.relative));
  if (!some_error) errors.clear();
  if (energies.size() != reached) energies.clear();
  runs_[key] = {fixed ? request.steps : drawn_outputs, curve(std::move(values)), errors, energies};
}

Json Solutions::json() const {
  // Rounded as the numbers of tables.
  const auto number = [](double value) { return Json::parse(report::json_number(value)); };
  Json names = Json::array(), low = names, high = names, times = names;
  const auto all = component_names(case_);
  for (std::size_t k = 0; k < components_.size(); ++k) {
    names.push_back(report::plain(all[components_[k]]));
    low.push_back(number(low_[k]));
    high.push_back(number(high_[k]));
  }
  std::vector<int> exact;
  // Some 400 of the exact states: between them the eye sees no corner.
  const std::size_t known = exact_.states.size(), every = std::max<std::size_t>(1, known / 400);
  std::size_t j = 0;
  for (const auto& [t, y] : exact_.states) {
    if (j++ % every != 0 && j < known) continue;
    times.push_back(number(t));
    for (const int level : levels(y.data())) exact.push_back(level);
  }
  return {{"start", number(case_.t0)},
          {"end", number(end_)},
          {"outputs", drawn_outputs},
          {"fine", fine},
          {"names", names},
          {"low", low},
          {"high", high},
          {"exact",
           {{"everywhere", exact_.everywhere},
            {"floor", number(exact_.floor)},
            {"source", report::plain(exact_.source)},
            {"times", times},
            {"values", exact}}},
          {"first", levels(case_.y0.data())},
          {"curves", curves_},
          {"runs", runs_}};
}

}  // namespace odeum::trajectories
