// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/measure/setting_search.hpp"

#include <algorithm>
#include <cmath>

#include "odeum/solvers/settings.hpp"

namespace odeum::measure {
namespace {

constexpr double finest_tolerance = 1e-14, loosest_tolerance = 1e-1, most_steps = 1e8;
constexpr double rounding = 1e-9;

}  // namespace

double SettingGrid::on_grid(double fineness) const {
  if (mode == Mode::adaptive) {
    const double within = std::clamp(fineness, 1 / loosest_tolerance, 1 / finest_tolerance);
    return two_digits ? 1 / of_two_digits(1 / within) : within;
  }
  const auto unit = static_cast<double>(multiple);
  return unit * std::ceil(std::clamp(fineness, 1.0, most_steps) / unit * (1 - 1e-12));
}

SettingSearch::Bracket SettingSearch::bracket(double error) const {
  Bracket found;
  const auto of = [&](std::ptrdiff_t k) { return tried[static_cast<std::size_t>(k)].fineness; };
  for (std::size_t k = 0; k < tried.size(); ++k)
    if (tried[k].reaches(error) && (found.reaches < 0 || tried[k].fineness < of(found.reaches)))
      found.reaches = static_cast<std::ptrdiff_t>(k);
  for (std::size_t k = 0; k < tried.size(); ++k)
    if (!tried[k].reaches(error) && tried[k].status != Status::over_budget &&
        (found.reaches < 0 || tried[k].fineness < of(found.reaches)) &&
        (found.misses < 0 || tried[k].fineness > of(found.misses)))
      found.misses = static_cast<std::ptrdiff_t>(k);
  return found;
}

const Tried* SettingSearch::at(double fineness) const {
  const auto found = std::ranges::find_if(tried, [&](const Tried& each) {
    return std::abs(each.fineness - fineness) <= rounding * fineness;
  });
  return found == tried.end() ? nullptr : &*found;
}

/// The setting; 0: it was tried.
double SettingSearch::new_one(double fineness) const { return at(fineness) ? 0 : fineness; }

/// Part of the way in logarithms, where the error falls as a power of the fineness.
double SettingSearch::between(const Tried& misses, const Tried& reaches, double error) const {
  constexpr double aimed_at = 1 / 1.15, least = 0.15, most = 0.85, half = 0.5;
  const double ratio = reaches.fineness / misses.fineness;
  if (ratio <= narrow) return 0;
  double part = half;
  if (misses.status == Status::ok && std::isfinite(misses.error) && reaches.error > 0)
    part = std::clamp(
        std::log(misses.error / (error * aimed_at)) / std::log(misses.error / reaches.error), least,
        most);
  for (const double way : {part, half})
    if (const double fineness = grid.on_grid(misses.fineness * std::pow(ratio, way));
        fineness > misses.fineness * (1 + rounding) && fineness < reaches.fineness * (1 - rounding))
      return fineness;
  return 0;
}

/// `expected` times as fine as a run that misses the error, or between it and one that was stopped.
double SettingSearch::finer_than(const Tried& misses, double expected) const {
  const bool tells = misses.status == Status::ok && misses.error <= size;
  const double factor = tells                         ? std::clamp(expected, 1.3, 1e3)
                        : grid.mode == Mode::adaptive ? 4
                                                      : 2;
  double finer = factor * misses.fineness;
  for (const Tried& each : tried)
    if (each.status == Status::over_budget && each.fineness > misses.fineness)
      finer = std::min(finer, std::sqrt(misses.fineness * each.fineness));
  return finer;
}

double SettingSearch::next(double error) const {
  const auto [coarse, fine] = bracket(error);
  const Tried* const misses = coarse < 0 ? nullptr : &tried[static_cast<std::size_t>(coarse)];
  const Tried* const reaches = fine < 0 ? nullptr : &tried[static_cast<std::size_t>(fine)];
  if (reaches && reaches->error >= close * error) return 0;
  if (misses && reaches) return between(*misses, *reaches, error);
  const auto by_error = [&](const Tried& each) {
    return std::pow(std::clamp(each.error / error, 1e-30, 1e30), 1 / slope);
  };
  if (reaches)
    return new_one(grid.on_grid(reaches->fineness *
                                std::clamp(by_error(*reaches), coarser_least, coarser_most)));
  if (misses) return new_one(grid.on_grid(finer_than(*misses, 1.2 * by_error(*misses))));
  // Over the budget at once: from a coarse setting on.
  return new_one(grid.on_grid(tried.back().fineness / 30));
}

double SettingSearch::next_within(double ns, double share, double power) const {
  const Tried& last = tried.back();
  // A run that was stopped tells that it takes longer.
  const double ratio =
      std::pow(last.status == Status::over_budget ? 0.1 : share * ns / last.ns, power);
  double fineness = grid.on_grid(last.fineness * std::clamp(ratio, 1e-6, 1e6));
  double above = infinity, below = 0;  // the nearest that take too long, and that do not
  for (const Tried& each : tried)
    if (each.ns > ns || each.status == Status::over_budget)
      above = std::min(above, each.fineness);
    else
      below = std::max(below, each.fineness);
  if (std::isfinite(above) && below > 0 && !(fineness > below && fineness < above))
    fineness = grid.on_grid(std::sqrt(above * below));
  return new_one(fineness);
}

}  // namespace odeum::measure
