// SPDX-License-Identifier: BSD-3-Clause
// What the report hands to its scripts.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/spectrum.hpp"
#include "odeum/report/columns.hpp"
#include "odeum/studies/precision/precision.hpp"
#include "odeum/studies/questions.hpp"
#include "odeum/studies/reduction/reduction.hpp"
#include "odeum/studies/stability/outline.hpp"
#include "support/report_fixture.hpp"

namespace odeum::study::page_data_test {
namespace {

TEST(PageData, ColumnsKeepNumbersAndTexts) {
  ToleranceRow row{"c", "odeum", "a", 1e-3, 0.1234567891234};
  ToleranceRow other{"c", "gsl", "<\x01\">", std::nan(""), std::numeric_limits<double>::infinity()};
  const auto json = nlohmann::json::parse(
      report::columns_json(record::fields_of(std::vector{row, other, row}),
                           {"library", "solver", "requested", "achieved", "absent"}));
  EXPECT_EQ(json["library"]["words"], (std::vector<std::string>{"odeum", "gsl"}));
  EXPECT_EQ(json["library"]["of"], (std::vector<int>{0, 1, 0}));
  EXPECT_EQ(json["solver"]["words"][1], "<\xEF\xBF\xBD\">");
  EXPECT_TRUE(json["requested"][1].is_null());
  EXPECT_EQ(json["achieved"][1], "inf");
  EXPECT_NEAR(json["achieved"][0].get<double>() / row.achieved, 1, 1e-7);
  EXPECT_FALSE(json.contains("absent"));
  EXPECT_EQ(report::columns_json({}, {"library"}), "{}");
}

TEST(PageData, ScriptsHoldTheRowsOfTheFiles) {
  const test::MadeUp data = test::fabricate_small_report();
  test::Report report(data);
  report.write({.command_line = "odeum report", .quick = true});
  const auto facts = tests::unpacked(report.text("data/facts.js"));
  EXPECT_EQ(facts, report.json("page.json"));
  ASSERT_EQ(facts["cases"].size(), data.facts.cases.size());
  EXPECT_EQ(facts["solvers"].size(), data.facts.solvers.size());
  EXPECT_EQ(facts["run"]["quick"], true);
  const auto errors = report.column("convergence", "error_max"),
             ids = report.column("convergence", "case");
  ASSERT_EQ(errors.size(), data.convergence.rows.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    EXPECT_EQ(ids[i], data.convergence.rows[i].case_id);
    if (const double error = data.convergence.rows[i].error; std::isnan(error))
      EXPECT_TRUE(errors[i].is_null());
    else
      EXPECT_NEAR(errors[i].get<double>() / error, 1, 1e-7);
  }
}

StabilityRegion disk(double radius) {
  StabilityRegion region{"odeum", "disk", "lambda", "ok", "", 61, 41, -3, 3, -2, 2, {}};
  for (int j = 0; j < region.rows; ++j)
    for (int i = 0; i < region.columns; ++i)
      region.growth.push_back(static_cast<float>(std::hypot(-3 + 0.1 * i, -2 + 0.1 * j) / radius));
  return region;
}

TEST(PageData, RegionsAreHandedOverWithWhyOneIsMissing) {
  std::vector<StabilityRegion> regions{disk(1.5), disk(1), disk(1)};
  std::fill(regions[1].growth.begin(), regions[1].growth.end(),
            std::numeric_limits<float>::quiet_NaN());
  regions[2].growth.clear();
  regions[2].detail = "every <solve> failed\x1b";
  const auto json = nlohmann::json::parse(outlines_json(regions));
  ASSERT_EQ(json.size(), 3U);
  EXPECT_EQ(json[0]["solver"], "odeum/disk");
  EXPECT_EQ(json[0]["loops"].size(), 1U);
  EXPECT_EQ(json[0]["missing"], "");
  EXPECT_EQ(json[0]["box"], nlohmann::json::array({-3, 3, -2, 2}));
  EXPECT_EQ(json[1]["loops"].size(), 0U);
  EXPECT_EQ(json[2]["loops"].size(), 0U);
  EXPECT_EQ(json[2]["missing"], "every <solve> failed\xEF\xBF\xBD");
}

ReductionResult two_rows(const Options&, const Runner&) {
  return {{ReductionRow(), ReductionRow()}};
}

TEST(PageData, WritesNoMorePartsAtATimeThanItIsTold) {
  const tests::TemporaryFolder root;
  const record::OutputFolder folder(root.path() / "out");
  report::Report made(report::Facts(), folder, 1);
  std::atomic<int> now = 0, most = 0;
  const auto slow = [&] {
    most = std::max<int>(most, ++now);
    // So long that a second thread would begin its part in between.
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    --now;
    return std::vector<record::Fields>{{{"x", 1.0}}};
  };
  made.table("a", "a.csv", {{"x", {}}}, std::vector<report::TablePart>(4, {"", 1, slow}));
  EXPECT_EQ(most.load(), 1);
}

TEST(PageData, AStudyTellsWhatOfItWasMeasured) {
  const auto study =
      make_study<ReductionResult>({.name = "reduce", .help = "of this test", .folder = "reduction"},
                                  {.measure = two_rows, .table = nullptr});
  EXPECT_FALSE(study->facts().measured);
  study->measure({.solvers = {"odeum/*"}}, Runner());
  EXPECT_TRUE(study->facts().measured);
  EXPECT_EQ(study->facts().selection, "solvers odeum/* on every case");
  study->measure({.cases = {"a", "b*"}}, Runner());
  EXPECT_EQ(study->facts().selection, "solvers odeum/* on every case; every solver on a, b*");
  EXPECT_EQ(study->facts().command, "reduce");
  EXPECT_EQ(study->facts().name, "reduction") << "the folder of its texts";
  test::Report report{report::Facts()};
  study->show(report.report());
  EXPECT_EQ(report.write().table("order_reduction")["rows"], 4);
  EXPECT_EQ(report.table("order_reduction")["study"], "reduction");
}

TEST(PageData, AStudyTellsWhyAnEarlierFileCannotBeUsed) {
  const tests::TemporaryFolder folder;
  const auto study =
      make_study<ReductionResult>({.name = "reduction", .help = "", .folder = "reduction"},
                                  {.measure = two_rows, .table = nullptr});
  tests::write_text(folder.path() / ReductionRow::file, "schema,x\n1,2\n");
  study->add_earlier(folder.path());
  EXPECT_NE(study->facts().problem.find(ReductionRow::file), std::string::npos);
}

PrecisionRow timed(const char* library, const char* solver, double setting, double error,
                   double ns) {
  PrecisionRow row;
  row.case_id = "c";
  row.library = library;
  row.solver = solver;
  row.status = "ok";
  row.setting = setting;
  row.error = row.near_error = error;
  row.wall_ns_min = ns;
  row.wall_ns_median = 1.1 * ns;
  row.repetitions = 3;
  return row;
}

TEST(PageData, TheFastestOfEachLibraryNamesARunThatReachesTheError) {
  const std::vector<FastestRow> rows =
      fastest({timed("odeum", "a", 1e-3, 1e-3, 100), timed("odeum", "a", 1e-5, 1e-5, 1000),
               timed("odeum", "b", 1e-4, 1e-4, 5000), timed("gsl", "g", 1e-2, 1e-3, 50)},
              1e-16);
  for (const FastestRow& row : rows) {
    if (std::abs(row.compared / 1e-4 - 1) > 1e-9) continue;
    EXPECT_EQ(row.library, "odeum") << "gsl has no run of that error, and is not extrapolated";
    EXPECT_EQ(row.solver, "a");
    EXPECT_EQ(row.wall_ns_min, 1000);
    EXPECT_EQ(row.setting, 1e-5);
  }
  EXPECT_EQ(
      std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.library == "gsl"; }),
      2);
}

TEST(PageData, QuestionsAreCasesThatAQuickReportMeasures) {
  const std::vector<std::string> quick = quick_cases();
  EXPECT_EQ(quick.size(), 9U);
  for (const std::string& id : quick) EXPECT_NO_THROW(known_case(id)) << id;
}

TEST(Outline, OfADiskIsACircle) {
  const std::vector<Loop> loops = outline(disk(1.5), 1);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_GT(loops[0].size(), 40U);
  // Growth is linear along radii: interpolation along an edge is within h^2 / (8 r) of the circle.
  for (const auto& [x, y] : loops[0])
    EXPECT_NEAR(std::hypot(x, y), 1.5, 0.1 * 0.1 / 8 / 1.5 + 2e-4);
}

TEST(Outline, ClosesAlongTheEdgesOfThePlaneAndKeepsPartsApart) {
  const std::vector<Loop> cut = outline(disk(2.5), 1);
  ASSERT_EQ(cut.size(), 1U) << "cut off above and below";
  for (const auto& [x, y] : cut[0]) EXPECT_LE(std::abs(y), 2.0);
  StabilityRegion two = disk(1);
  for (int j = 0; j < two.rows; ++j)
    for (int i = 0; i < two.columns; ++i)
      two.growth[static_cast<std::size_t>(j * two.columns + i)] =
          std::abs(std::abs(-3 + 0.1 * i) - 1.5) < 0.75 ? 0.5F : 2.0F;
  EXPECT_EQ(outline(two, 1).size(), 2U);
  std::fill(two.growth.begin(), two.growth.end(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(outline(two, 1).empty());
  two.growth.pop_back();
  EXPECT_TRUE(outline(two, 1).empty());
}

TEST(Spectrum, OfASmallCaseIsThatOfItsMatrix) {
  // y'' + 0.5 y' + 5 y = 0: -0.25 +- sqrt(0.0625 - 5).
  const auto z = cases::spectrum_of(known_case("damped_oscillator_underdamped")).eigenvalues;
  ASSERT_EQ(z.size(), 1U);
  EXPECT_NEAR(z[0].real(), -0.25, 1e-12);
  EXPECT_NEAR(z[0].imag(), std::sqrt(5 - 0.0625), 1e-12);
}

TEST(Spectrum, IsThatOfTheEndWhereTheProblemBecomesStiffLater) {
  // Robertson's reactions begin with -0.04 and two zeros.
  const cases::Spectrum spectrum = cases::spectrum_of(known_case("robertson_40"));
  EXPECT_EQ(spectrum.time, 40);
  double fastest = 0;
  for (const auto& z : spectrum.eigenvalues) fastest = std::min(fastest, z.real());
  // 6e7 y2 + 1e4 y3 with y2 = 9.2e-6 and y3 = 0.28 there is some 3e3.
  EXPECT_LT(fastest, -1e3);
  EXPECT_GT(fastest, -1e4);
}

TEST(Spectrum, OfAClothHasItsFastestVibration) {
  // Springs a hundred times stiffer vibrate ten times faster at the start; the end, where the soft
  // cloth has stretched more, changes that by a tenth at most.
  double fastest = 0;
  for (const auto& z : cases::spectrum_of(known_case("cloth11_two_way")).eigenvalues)
    fastest = std::max(fastest, std::abs(z));
  double stiffer = 0;
  for (const auto& z : cases::spectrum_of(known_case("cloth11_two_way_k1e3")).eigenvalues)
    stiffer = std::max(stiffer, std::abs(z));
  EXPECT_NEAR(stiffer / fastest, 10, 1);
}

}  // namespace
}  // namespace odeum::study::page_data_test
