// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "odeum/cli/run.hpp"

namespace odeum::cli {
namespace {

constexpr double most_steps = 1e9;

void set_step(Request& request, const RunSettings& settings, double length,
              const SolverInfo& info) {
  if (!info.fixed) throw UsageError("{} runs to a tolerance only: use --tol", info.id());
  request.mode = Mode::fixed;
  if (settings.steps) return void(request.steps = *settings.steps);
  const double h = *settings.step;
  // Steps are equal and end at the horizon: take the next smaller divisor, unless the difference is
  // rounding.
  request.steps = static_cast<std::uint64_t>(std::ceil(length / h * (1 - 1e-12)));
  const double used = length / static_cast<double>(request.steps);
  if (std::abs(used - h) > 1e-9 * h)
    remark("the step is reduced from {} to {}, so that {} steps end at t = {}", h, used,
           request.steps, request.stops.back());
}

void set_tolerances(Request& request, const RunSettings& settings, std::size_t numbers,
                    const SolverInfo& info) {
  const double smallest = std::numeric_limits<double>::epsilon();
  const Tolerance tolerance = settings.tolerance.value_or(0);
  const std::vector<double>& absolutes = tolerance.absolutes();
  if (!std::isfinite(tolerance.relative) || !(tolerance.relative > smallest))
    throw UsageError("{}: got {}, expected a number above machine precision, {:.2g}",
                     settings.absolute_given ? "--rtol" : "--tol", tolerance.relative, smallest);
  for (const double each : absolutes)
    if (!std::isfinite(each) || !(each > 0))
      throw UsageError("--atol: got {}, expected positive numbers", each);
  if (absolutes.size() > 1 && absolutes.size() != numbers)
    throw UsageError("--atol: got {} numbers, expected one, or {}: one for each of the state's",
                     absolutes.size(), numbers);
  if (!info.adaptive) throw UsageError("{} runs at a fixed step only: use --step", info.id());
  request.mode = Mode::adaptive;
  request.tolerance = tolerance;
}

}  // namespace

double number_of(const char* option, const std::string& text,
                 const std::map<std::string, double>& units) {
  const char *at = text.data(), *const end = at + text.size();
  double value = 0;
  const auto read = [&](double& number) {
    const auto [stop, error] = std::from_chars(at, end, number);
    at = stop;
    return error == std::errc{} && number > 0 && std::isfinite(number);
  };
  double below = 1;
  bool sound = read(value);
  if (sound && at != end && *at == '/') {
    ++at;
    sound = read(below);
  }
  const auto unit = units.find(std::string(at, end));
  if (!sound || unit == units.end()) {
    std::vector<std::pair<double, std::string>> names;
    for (const auto& [name, size] : units)
      if (!name.empty()) names.emplace_back(size, name);
    std::sort(names.rbegin(), names.rend());
    std::string list;
    for (std::size_t k = 0; k < names.size(); ++k)
      list += (k == 0 ? ", in " : k + 1 < names.size() ? ", " : " or ") + names[k].second;
    throw UsageError("{}: got {}, expected a positive number or a fraction{}", option, shown(text),
                     list);
  }
  return value / below * unit->second;
}

void require_positive(const char* option, double value) {
  if (!std::isfinite(value) || !(value > 0))
    throw UsageError("{}: got {}, expected a positive number", option, value);
}

bool has_setting(const RunSettings& settings) {
  return settings.step || settings.steps || settings.tolerance;
}

RunSettings settings_for(const Case& c, RunSettings settings) {
  if (!has_setting(settings) && c.tolerance.relative > 0) settings.tolerance = c.tolerance;
  if (settings.tolerance && !settings.absolute_given)
    settings.tolerance = c.tolerance.requested(settings.tolerance->relative);
  if (settings.named_absolute.empty()) return settings;
  const std::vector<std::string> names = component_names(c);
  // The other components have the number that was given, else the case's own thresholds.
  const Tolerance others = settings.tolerance->absolutes().empty()
                               ? c.tolerance.requested(settings.tolerance->relative)
                               : *settings.tolerance;
  if (others.by_component() && others.absolutes().size() != names.size())
    throw UsageError("--atol: got {} numbers beside names, expected one at most",
                     others.absolutes().size());
  std::vector<double> all(names.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = others.absolute(i);
  for (const auto& [name, value] : settings.named_absolute) {
    const auto at = std::ranges::find(names, name);
    if (at == names.end())
      throw UsageError("--atol: {} has no component {}{}", c.id, shown(name),
                       did_you_mean(name, names));
    all[static_cast<std::size_t>(at - names.begin())] = value;
  }
  settings.tolerance = Tolerance(settings.tolerance->relative, all);
  return settings;
}

std::string text_of_tolerance(const Request& request) {
  const double relative = request.tolerance.relative;
  const std::vector<double>& absolutes = request.tolerance.absolutes();
  if (absolutes.empty()) return fmt::format("{}", relative);
  constexpr std::size_t most = 8;
  const auto shown = std::min(absolutes.size(), most);
  // A proposed scale times a tolerance is not a short number in binary.
  return fmt::format(
      "rtol {}, atol {:.6g}{}", relative,
      fmt::join(absolutes.begin(), absolutes.begin() + static_cast<std::ptrdiff_t>(shown), ","),
      shown < absolutes.size() ? ",..." : "");
}

void check_span(const RunSettings& settings, double t0, double horizon) {
  const double end = settings.until.value_or(horizon), length = end - t0;
  if (!std::isfinite(length) || !(length > 0))
    throw UsageError("--until: got {}, expected a finite time after {}", end, t0);
  if (settings.steps && !(static_cast<double>(*settings.steps) <= most_steps && *settings.steps))
    throw UsageError("--steps: got {}, expected 1 to {:g}", *settings.steps, most_steps);
  if (!settings.step) return;
  const double h = *settings.step;
  require_positive("--step", h);
  if (h > length) throw UsageError("--step: got {}, expected at most the horizon {}", h, length);
  if (length / h > most_steps)
    throw UsageError("--step: got {}, which takes more than {:g} steps to t = {}", h, most_steps,
                     end);
}

Case case_within(Session& session, const std::string& what, const ProblemOptions& options,
                 const RunSettings& settings) {
  Case c = case_before_truth(session, cases::Named(what), options);
  check_span(settings, c.t0, c.end());
  complete(c, session.truth_bounds);
  return c;
}

Request make_request(const RunSettings& settings, double t0, double horizon, std::size_t numbers,
                     const SolverInfo& info) {
  Request request;
  check_span(settings, t0, horizon);
  const double end = settings.until.value_or(horizon), length = end - t0;
  request.stops = {end};
  if (settings.step || settings.steps)
    set_step(request, settings, length, info);
  else
    set_tolerances(request, settings, numbers, info);
  // The user chose the setting; only the seconds are limited.
  request.budget.evaluations = 10'000'000'000;
  request.budget.seconds = 600;
  return request;
}

void ask_for_output(Request& request, const RunSettings& settings, double t0, std::size_t numbers) {
  constexpr double usual_outputs = 500, most_numbers = 2e8;  // of 8 bytes each
  const double end = request.stops.back(), length = end - t0;
  const double every = settings.every.value_or(length / usual_outputs);
  require_positive("--every", every);
  if (!(length / every * static_cast<double>(numbers) < most_numbers))
    throw UsageError("--every: got {}, which keeps more than {:g} numbers", every, most_numbers);
  request.over_stops = request.record_steps = true;
  request.stops.clear();
  if (request.mode == Mode::fixed) {
    const double h = length / static_cast<double>(request.steps);
    const auto apart =
        std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(every / h)));
    const double used = static_cast<double>(apart) * h;
    if (settings.every && std::abs(used - every) > 1e-9 * every)
      remark("output is {} apart instead of {}, a whole number of steps", used, every);
    for (std::uint64_t i = apart; i < request.steps; i += apart)
      request.stops.push_back(t0 + static_cast<double>(i) * h);
  } else {
    for (std::uint64_t k = 1; static_cast<double>(k) * every < length * (1 - 1e-9); ++k)
      request.stops.push_back(t0 + static_cast<double>(k) * every);
  }
  request.stops.push_back(end);
}

}  // namespace odeum::cli
