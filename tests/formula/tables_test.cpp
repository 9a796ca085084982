// SPDX-License-Identifier: BSD-3-Clause
// Tables and inputs of a text: values, kinks that runs know, and what is refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "odeum/formula/evaluator.hpp"
#include "odeum/formula/problem.hpp"
#include "odeum/formula/switch_times.hpp"

namespace odeum::tests::tables_test {
namespace {

formula::Problem with_tables(const std::string& sections, const std::string& rate,
                             const std::string& file = "t.yaml") {
  return formula::read_problem(file, fmt::format("states: {{x: 0}}\nequations: {{x: \"{}\"}}\n"
                                                 "time: {{end: 4}}\n{}\n",
                                                 rate, sections));
}
double rate_at(const formula::Problem& p, double t, double x = 0) {
  double value = 0;
  formula::Evaluator<double>(p.graph, p.equations)(t, &x, &value);
  return value;
}

TEST(Tables, LinesSplinesAndStepsHaveTheirValues) {
  const auto table = [](const char* between) {
    return with_tables(fmt::format("tables: {{w: {{points: [[0, 1], [1, 3], [2, 2], [4, 8]], "
                                   "between: {}}}}}",
                                   between),
                       "w(t)");
  };
  // The natural spline by SciPy 1.10, CubicSpline(x, y, bc_type="natural").
  const double times[] = {0, 0.25, 1, 1.5, 2, 3, 3.75, 4};
  const double lines[] = {1, 1.5, 3, 2.5, 2, 5, 7.25, 8};
  const double splines[] = {
      1, 1.7241847826086956, 3, 2.5489130434782608, 2, 3.760869565217392, 6.843410326086957, 8};
  const double steps[] = {1, 1, 3, 3, 2, 2, 2, 8};
  const std::pair<const char*, const double*> all[] = {
      {"linear", lines}, {"cubic", splines}, {"constant", steps}};
  for (const auto& [between, expected] : all) {
    const formula::Problem p = table(between);
    for (std::size_t k = 0; k < std::size(times); ++k)
      EXPECT_NEAR(rate_at(p, times[k]), expected[k], 1e-13) << between << " at " << times[k];
    EXPECT_EQ(formula::switch_times(p, 4).times, (std::vector<long double>{1, 2})) << between;
  }
}

TEST(Tables, OutsideOfTheirRangeTheyDoWhatTheFileSays) {
  const auto table = [](const char* outside) {
    return with_tables(
        fmt::format("tables: {{w: {{points: [[0, 1], [1, 3]], outside: {}}}}}", outside), "w(x)");
  };
  EXPECT_EQ(rate_at(table("hold"), 0, 5), 3);
  EXPECT_EQ(rate_at(table("hold"), 0, -5), 1);
  EXPECT_EQ(rate_at(table("extrapolate"), 0, 5), 11);
  EXPECT_EQ(rate_at(table("extrapolate"), 0, -1), -1);
  EXPECT_TRUE(std::isnan(rate_at(table("error"), 0, 1.5)));
  EXPECT_TRUE(std::isnan(rate_at(table("error"), 0, -0.5)));
  EXPECT_EQ(rate_at(table("error"), 0, 1), 3);
}

TEST(Tables, AreReadFromFilesBesideTheText) {
  const auto folder = std::filesystem::temp_directory_path() / "odeum_tables_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "wind.csv") << "# m/s\ntime, gust ,speed\n0,9,1\n2,9,\"3\"\n\n4,9,2\r\n";
  const formula::Problem p =
      with_tables("tables: {w: {file: wind.csv, columns: [time, speed]}}\ninputs: {u: 2*w(t)}", "u",
                  (folder / "t.yaml").string());
  EXPECT_EQ(rate_at(p, 1), 4);
  EXPECT_EQ(rate_at(p, 4), 4);
  std::filesystem::remove_all(folder);
}

TEST(Tables, ThoseThatAreNotSoundAreRefusedWithTheirPlace) {
  const auto folder = std::filesystem::temp_directory_path() / "odeum_bad_tables_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "nan.csv") << "t,v\n0,1\n1,nan\n";
  std::ofstream(folder / "back.csv") << "t,v\n0,1\n2,1\n1,3\n";
  std::ofstream(folder / "one.csv") << "t,v\n0,1\n";
  const std::string at = folder.string() + "/";
  const std::pair<std::string, std::string> bad[] = {
      {"tables: {w: {file: nan.csv}}", at + "nan.csv:3:1: got nan in column 2, expected a finite"},
      {"tables: {w: {file: back.csv}}", at + "back.csv:4:1: not sorted; got 1 after 2"},
      {"tables: {w: {file: one.csv}}", at + "t.yaml:4:20: tables: w: got 1 points, expected two"},
      {"tables: {w: {file: back.csv, columns: [time, v]}}", at + "back.csv:1:1: no such column"},
      {"tables: {w: {}}", at + "t.yaml:4:13: tables: w: got neither file nor points"},
      {"tables: {w: {points: [[0, 1], [3, 1]]}}",
       at + "t.yaml:2:17: equations: x: outside of the table w; got times from 0 to 3, expected"},
      {"tables: {w: {points: [[0, 1], [4, 1]], between: spline}}",
       at + "t.yaml:4:49: tables: w: between: got spline, expected one of linear"},
      {"tables: {w: {points: [[0, 1], [4, 1]]}}\ninputs: {u: 1}",
       at + "t.yaml:5:10: inputs: named nowhere; got u"}};
  for (const auto& [sections, message] : bad) try {
      with_tables(sections, "w(t)", at + "t.yaml");
      ADD_FAILURE() << sections;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(message)) << error.what();
    }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace odeum::tests::tables_test
