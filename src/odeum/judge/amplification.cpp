// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/amplification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "odeum/judge/errors.hpp"
#include "odeum/judge/flow.hpp"
#include "odeum/judge/variations.hpp"

namespace odeum::judge {
namespace {

using States = std::vector<double>;

constexpr std::size_t most_columns = 64;  // the largest dimension whose Phi is measured whole
constexpr std::size_t checkpoints = 48;
constexpr std::size_t random_times = 4, random_directions = 4;
/// The perturbation is far above the errors of the runs and far below nonlinear effects. Of many
/// unknowns the runs would take long; at kinks of their forces a low order is as good.
constexpr double tolerance = 1e-10, perturbation = 1e-6;
constexpr double tolerance_of_many = 1e-7, perturbation_of_many = 1e-4;

/// threshold_i + |y_i|.
States units_of(const Tolerance& asked, const States& y) {
  States units(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) units[i] = asked.threshold(i) + std::abs(y[i]);
  return units;
}

/// The smaller ones, of the case and of what is asked: a perturbation that is small beside each
/// component, and runs that follow it.
Tolerance finest_of(const Case& c, const Tolerance& asked, double relative) {
  const Tolerance finest = c.tolerance.with_relative(relative);
  if (asked.thresholds.empty() && finest.thresholds.empty()) return finest;
  std::vector<double> thresholds(c.y0.size());
  for (std::size_t i = 0; i < thresholds.size(); ++i)
    thresholds[i] = std::min(asked.threshold(i), finest.threshold(i));
  return Tolerance::of_thresholds(relative, std::move(thresholds));
}

/// Times from t0 to the last stop, every stop among them, and the state at each.
struct Path {
  std::vector<double> times;
  std::vector<States> states;

  std::size_t index_of(double time) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(times, time) - times.begin());
  }
};

Path path_of(const Case& c, Flow& flow, const std::vector<double>& stops, std::size_t count) {
  Path path{flow.checkpoints(stops, count), {c.y0}};
  const States rest = flow.solve(c.t0, c.y0, {path.times.begin() + 1, path.times.end()});
  for (std::size_t k = 1; k < path.times.size(); ++k) {
    const auto begin = rest.begin() + static_cast<std::ptrdiff_t>((k - 1) * c.y0.size());
    path.states.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(c.y0.size()));
  }
  return path;
}

/// The reference runs must follow the truth: 1e-3 of the solution is enough for a factor that need
/// only be known to about two.
void require_truth(const Case& c, const std::vector<double>& stops, const Path& path) {
  const Judge judge(c, stops);
  Outcome outcome;
  for (std::size_t k = 1; k < path.times.size(); ++k)
    if (std::ranges::binary_search(stops, path.times[k]))
      outcome.record(path.times[k], path.states[k].data(), c.y0.size());
  for (const StopError& error : judge.errors(outcome))
    if (error.error_rms > 1e-3 * judge.scale())
      throw std::runtime_error(fmt::format("a run for it ends {:.2g} from the truth at t = {}",
                                           error.error_rms, error.time));
}

/// The units of errors that steps make, at each time of a path: none in a state that changes at
/// events alone, whose rate is zero along the path.
std::vector<States> units_along(const Case& c, const Tolerance& asked, const Path& path) {
  std::vector<States> units;
  for (const States& y : path.states) units.push_back(units_of(asked, y));
  if (!c.problem.events) return units;
  States rates(c.y0.size()), most(c.y0.size());
  for (std::size_t k = 0; k < path.times.size(); ++k) {
    c.problem.view.rhs(c.problem.view.problem, path.times[k], path.states[k].data(), rates.data());
    for (std::size_t i = 0; i < rates.size(); ++i) most[i] = std::max(most[i], std::abs(rates[i]));
  }
  for (States& at : units)
    for (std::size_t i = 0; i < at.size(); ++i)
      if (most[i] == 0) at[i] = 0;
  return units;
}

/// Phi(next, t) by the variational equations; empty where there are none, or where they deny what
/// a run from beside the path shows, as they do where f jumps.
States exact_matrix(const Case& c, const Tolerance& finest, Flow& flow, const Path& path,
                    std::size_t k) {
  constexpr std::size_t most_unknowns = 16;  // differences cost less where n^3 is dear
  constexpr double agreed = 0.1;
  const States& from = path.states[k];
  const std::size_t n = from.size();
  if (n > most_unknowns || !flow.is_explicit() || c.problem.events) return {};
  const States units = units_of(finest, from);
  const States all = with_variations(c, path.times[k], from, path.times[k + 1], finest, units);
  if (all.empty()) return {};
  const States matrix(all.begin() + static_cast<std::ptrdiff_t>(n), all.end());
  States moved = from;
  for (std::size_t j = 0; j < n; ++j) moved[j] += perturbation * units[j];
  const States there = flow.solve(path.times[k], moved, {path.times[k + 1]});
  double size = 0, apart = 0;
  const States end = units_of(finest, there);
  for (std::size_t i = 0; i < n; ++i) {
    double told = 0;
    for (std::size_t j = 0; j < n; ++j) told += matrix[i * n + j] * (moved[j] - from[j]);
    size = std::max(size, std::abs(told) / end[i]);
    apart = std::max(apart, std::abs(there[i] - all[i] - told) / end[i]);
  }
  return apart <= agreed * std::max(size, perturbation) ? matrix : States();
}

/// Phi(next, t) for two neighbouring times of a path, row-major.
States step_matrix(const Case& c, const Tolerance& finest, Flow& flow, const Path& path,
                   std::size_t k) {
  if (States matrix = exact_matrix(c, finest, flow, path, k); !matrix.empty()) return matrix;
  const States& from = path.states[k];
  const std::size_t n = from.size();
  const std::vector<double> to{path.times[k + 1]};
  const States base = flow.solve(path.times[k], from, to), units = units_of(finest, from);
  States matrix(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    States moved = from;
    moved[j] += perturbation * units[j];
    const double by = moved[j] - from[j];
    const States there = flow.solve(path.times[k], moved, to);
    for (std::size_t i = 0; i < n; ++i) matrix[i * n + j] = (there[i] - base[i]) / by;
  }
  return matrix;
}

/// `row` becomes row * matrix.
void multiply(States& row, const States& matrix) {
  const std::size_t n = row.size();
  States product(n, 0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) product[j] += row[i] * matrix[i * n + j];
  row = std::move(product);
}

double effect(const States& row, const States& units) {
  double squares = 0;
  for (std::size_t i = 0; i < row.size(); ++i) squares += std::pow(row[i] * units[i], 2);
  return std::sqrt(static_cast<double>(row.size()) * squares);
}

void by_all_columns(const Case& c, Flow& flow, const std::vector<double>& stops,
                    const Tolerance& asked, Amplification& result) {
  const Path path = path_of(c, flow, stops, checkpoints);
  require_truth(c, stops, path);
  std::vector<States> matrices;
  const std::vector<States> units = units_along(c, asked, path);
  for (std::size_t k = 0; k + 1 < path.times.size(); ++k)
    matrices.push_back(step_matrix(c, finest_of(c, asked, tolerance), flow, path, k));
  for (std::size_t stop = 0; stop < stops.size(); ++stop) {
    const std::size_t at = path.index_of(stops[stop]);
    for (const std::size_t component : measured_components(c)) {
      States row(c.y0.size(), 0);  // of Phi(stop, t), back from the stop
      row[component] = 1 / c.units.of(component, path.states[at][component]);
      double& largest = result.at_stops[stop];
      largest = std::max(largest, effect(row, units[at]));
      for (std::size_t k = at; k-- > 0;) {
        multiply(row, matrices[k]);
        largest = std::max(largest, effect(row, units[k]));
      }
    }
  }
}

/// The root mean square over random signs of the effect on a component is the norm of its row.
void by_random_directions(const Case& c, Flow& flow, const std::vector<double>& stops,
                          const Tolerance& asked, Amplification& result) {
  const std::size_t n = c.y0.size();
  const double root = std::sqrt(static_cast<double>(n));
  const Path path = path_of(c, flow, stops, random_times);
  require_truth(c, stops, path);
  const std::vector<std::size_t> measured = measured_components(c);
  const auto unit_at = [&](std::size_t stop, std::size_t i) {
    return c.units.of(i, path.states[path.index_of(stops[stop])][i]);
  };
  std::mt19937 random(1);
  result.directions = random_directions;
  for (std::size_t k = 0; k + 1 < path.times.size(); ++k) {
    // The start, and the times between the stops.
    if (k > 0 && std::ranges::binary_search(stops, path.times[k])) continue;
    const States& from = path.states[k];
    const auto first = std::ranges::upper_bound(stops, path.times[k]);
    const std::vector<double> later(first, stops.end());
    States squares(later.size() * n, 0);
    const States units = units_of(asked, from),
                 own = units_of(finest_of(c, asked, tolerance_of_many), from);
    double largest = 0;  // of the units against the case's own
    for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, units[i] / own[i]);
    const double by = perturbation_of_many / largest;
    for (std::size_t r = 0; r < random_directions; ++r) {
      States moved = from;
      for (std::size_t i = 0; i < n; ++i) moved[i] += (random() % 2 ? 1 : -1) * by * units[i];
      const States there = flow.solve(path.times[k], moved, later);
      for (std::size_t s = 0; s < later.size(); ++s) {
        const States& base = path.states[path.index_of(later[s])];
        for (std::size_t i = 0; i < n; ++i)
          squares[s * n + i] += std::pow((there[s * n + i] - base[i]) / by, 2) / random_directions;
      }
    }
    for (std::size_t s = 0; s < later.size(); ++s) {
      const auto stop = static_cast<std::size_t>(first - stops.begin()) + s;
      for (const std::size_t i : measured)
        result.at_stops[stop] = std::max(result.at_stops[stop],
                                         root * std::sqrt(squares[s * n + i]) / unit_at(stop, i));
    }
  }
  for (std::size_t stop = 0; stop < stops.size(); ++stop)
    for (const std::size_t i : measured)  // an error of the last step
      result.at_stops[stop] =
          std::max(result.at_stops[stop], root * asked.threshold(i) / unit_at(stop, i));
}

std::vector<Control> controls(const Case& c, const Flow& flow, const std::vector<double>& stops,
                              double finest) {
  const Judge judge(c, stops);
  std::vector<Control> all;
  for (double exponent = -2; std::pow(10, exponent) >= 0.99 * finest; --exponent) {
    Outcome outcome;
    const double to = std::pow(10, exponent);
    outcome.states = flow.states(stops, to);
    if (outcome.states.empty()) continue;
    Control control{to, {}};
    for (const StopError& error : judge.errors(outcome)) control.errors.push_back(error.error_max);
    all.push_back(std::move(control));
  }
  return all;
}

}  // namespace

Amplification measure_amplification(const Case& c, const std::vector<double>& stops,
                                    const Tolerance& asked) {
  Amplification result{.at_stops = States(stops.size(), 0), .controls = {}, .unknown = {}};
  try {
    const bool many = c.y0.size() > most_columns;
    Flow flow(c, stops.back(), many ? "dormand_prince54" : "dormand_prince853",
              finest_of(c, asked, many ? tolerance_of_many : tolerance));
    if (many)
      by_random_directions(c, flow, stops, asked, result);
    else
      by_all_columns(c, flow, stops, asked, result);
    result.controls = controls(c, flow, stops, many ? 1e-5 : 1e-8);
  } catch (const std::runtime_error& error) {
    result.unknown = std::string("the amplification of errors is not known: ") + error.what();
  }
  return result;
}

Amplification measure_amplification(const Case& c, const std::vector<double>& stops) {
  return measure_amplification(c, stops, c.tolerance.with_relative(1));
}

}  // namespace odeum::judge
