// SPDX-License-Identifier: BSD-3-Clause
// The search for a setting, on errors and times that are known functions of it.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "odeum/measure/setting_search.hpp"

namespace odeum::setting_search_test {
namespace {

using measure::SettingSearch;
using measure::Tried;

using RunAt = std::function<Tried(double fineness)>;

/// A run with the error (16 / steps)^order, of a microsecond a step.
RunAt method_of(double order, double unstable_below = 0) {
  return [=](double steps) {
    Tried run{.fineness = steps, .error = std::pow(16 / steps, order), .ns = 1e3 * steps};
    if (steps < unstable_below) run.status = Status::non_finite, run.error = nan;
    return run;
  };
}

/// Searches to the end and returns the fineness of the coarsest that reaches the error; 0: none.
double found_by(SettingSearch& search, const RunAt& run, double start, double error) {
  search.tried = {run(start)};
  while (const double fineness = search.next(error)) {
    EXPECT_EQ(search.at(fineness), nullptr) << fineness << " was tried";
    search.tried.push_back(run(fineness));
    EXPECT_LT(search.tried.size(), 20U);
    if (search.tried.size() == 20) break;
  }
  const auto at = search.bracket(error).reaches;
  return at < 0 ? 0 : search.tried[static_cast<std::size_t>(at)].fineness;
}

SettingSearch fixed(double order, std::uint64_t multiple = 1) {
  return {.grid = {.mode = Mode::fixed, .multiple = multiple},
          .slope = order,
          .narrow = std::pow(10, 0.125 / order)};
}

TEST(SettingSearch, FindsTheFewestStepsFromBothSides) {
  for (const double order : {1.0, 2.0, 4.0, 8.0})
    for (const double start : {4.0, 30.0, 1e5}) {
      SettingSearch search = fixed(order);
      const double exact = 16 * std::pow(1e6, 1 / order),
                   found = found_by(search, method_of(order), start, 1e-6);
      EXPECT_GE(found, std::floor(exact)) << order;
      // The bracket is an eighth of a decade of error wide.
      EXPECT_LE(found, std::ceil(1.01 * search.narrow * exact)) << order << ' ' << start;
      EXPECT_LE(search.tried.size(), 9U) << order << ' ' << start;
    }
}

TEST(SettingSearch, StaysOnTheGrid) {
  SettingSearch search = fixed(2, 12);
  search.narrow = 1;
  const double found = found_by(search, method_of(2), 12, 1e-3);
  EXPECT_EQ(found, 516) << "the multiple of 12 above 16 sqrt(1000) = 506";
  for (const Tried& each : search.tried) EXPECT_EQ(std::fmod(each.fineness, 12), 0);
  const measure::SettingGrid tolerances{.two_digits = true};
  EXPECT_DOUBLE_EQ(tolerances.on_grid(1 / 1.234e-5), 1 / 1.2e-5);
  EXPECT_DOUBLE_EQ(tolerances.on_grid(1), 10) << "no tolerance is looser than 0.1";
  EXPECT_DOUBLE_EQ(tolerances.on_grid(1e30), 1e14);
}

TEST(SettingSearch, AnUnstableRunTellsNothingOfTheError) {
  SettingSearch search = fixed(4);
  search.size = 1;
  const double found = found_by(search, method_of(4, 700), 16, 1e-3);
  EXPECT_GE(found, 700);
  EXPECT_LE(found, 1.01 * search.narrow * 700);
}

TEST(SettingSearch, ARunThatWasStoppedIsAnUpperBound) {
  SettingSearch search = fixed(2);
  const RunAt run = [](double steps) {
    Tried made = method_of(2)(steps);
    if (steps > 400) made.status = Status::over_budget, made.error = nan;
    return made;
  };
  EXPECT_EQ(found_by(search, run, 16, 1e-8), 0) << "nobody reaches it within the budget";
  EXPECT_NEAR(found_by(search, run, 1e5, 3e-3), 16 / std::sqrt(3e-3), 0.2 * 16 / std::sqrt(3e-3));
}

TEST(SettingSearch, EndsWhereARunHasMostOfTheError) {
  SettingSearch search = fixed(3);
  search.close = 1 / 1.3, search.narrow = 1;
  const double found = found_by(search, method_of(3), 100, 1e-5);
  const double error = search.at(found)->error;
  EXPECT_LE(error, 1e-5);
  EXPECT_GE(error, 1e-5 / 1.3);
}

TEST(SettingSearch, FindsTheFinestWithinATime) {
  SettingSearch search = fixed(4, 10);
  search.tried = {method_of(4)(20)};
  for (int k = 0; k < 6; ++k)
    if (const double fineness = search.next_within(1.234e6, 0.97, 1))
      search.tried.push_back(method_of(4)(fineness));
  double finest = 0;
  for (const Tried& each : search.tried)
    if (each.ns <= 1.234e6) finest = std::max(finest, each.fineness);
  EXPECT_GE(finest, 1190);
  EXPECT_LE(search.tried.size(), 5U);
}

}  // namespace
}  // namespace odeum::setting_search_test
