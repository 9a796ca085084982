// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/hard_cases/section.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "odeum/report/old_page.hpp"
#include "support/report_fixture.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::report {
namespace {

using judge::Verdict;
using study::DriftRow;
using study::HorizonRow;
using study::LargestStep;
using study::ReductionRow;
using tests::text_of;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
    ++found;
  return found;
}

ReportData small_data() {
  ReportData data = test::fabricate_small_report();
  data.convergence = {};  // its plots are another test's, and would take seconds
  data.stability = {};
  data.hard_cases.measured = true;
  return data;
}

std::string index_of(const ReportData& data) {
  const tests::TemporaryFolder root;
  const record::OutputFolder folder(root.path() / "out");
  write_page(data, folder);
  return text_of(folder.path() / "index.html");
}

ReductionRow reduction(double lambda, double order, double error, judge::Verdict verdict) {
  ReductionRow row;
  row.library = "odeum";
  row.solver = "explicit_method_1";
  row.lambda = lambda;
  row.claimed_order = 4;
  row.fit.order = order;
  row.fit.verdict = verdict;
  row.fit.reason = "of this test";
  row.error_finest = error;
  return row;
}

LargestStep largest(const ReportData& data, double measured, double predicted) {
  LargestStep row;
  row.case_id = data.cases[0].id;
  row.library = "odeum";
  row.solver = "explicit_method_1";
  row.status = "ok";
  row.largest_stable_step = measured;
  row.predicted_step = predicted;
  row.eigenvalue = {-100, 0};
  row.window = 10;
  return row;
}

std::vector<DriftRow> drift(const std::string& case_id, const char* quantity, double power) {
  std::vector<DriftRow> rows;
  for (const double time : {1.0, 3.0, 10.0, 30.0, 100.0}) {
    DriftRow row;
    row.case_id = case_id;
    row.library = "odeum";
    row.solver = "explicit_method_1";
    row.status = "ok";
    row.step = 0.1;
    row.time = time;
    row.invariant = quantity;
    row.relative_error = 1e-5 * std::pow(time, power);
    row.value = 1 + row.relative_error;
    rows.push_back(row);
  }
  return rows;
}

double power_of(const std::vector<DriftRow>& rows) {
  std::vector<const DriftRow*> series;
  for (const DriftRow& row : rows) series.push_back(&row);
  return growth_power(series);
}

TEST(PageHardCases, SaysWhereNothingWasMeasured) {
  ReportData data = small_data();
  data.hard_cases = {};
  data.hard_cases.problem = "the drift.csv that was there is <cut> off";
  const std::string html = index_of(data);
  EXPECT_TRUE(has(html, "Not measured in this run: a full <code>odeum report</code> runs a"));
  EXPECT_TRUE(has(html, "is &lt;cut&gt; off"));
  EXPECT_FALSE(has(html, "Order reduction"));
}

TEST(PageHardCases, SaysThatResultsAreOfAnEarlierRun) {
  ReportData data = small_data();
  data.hard_cases.reduction = {reduction(-1e6, 2, 1e-9, judge::Verdict::lower)};
  EXPECT_TRUE(has(index_of(data), "To keep a report short")) << "the rule of the selection";
  data.hard_cases.measured = false;
  const std::string html = index_of(data);
  EXPECT_TRUE(has(html, "these are results of an earlier one"));
  EXPECT_FALSE(has(html, "To keep a report short: Odeum's own solvers"));
}

TEST(PageHardCases, ColoursTheOrdersThatAreLost) {
  ReportData data = small_data();
  data.hard_cases.reduction = {reduction(-1e6, 1.9, 1e-9, judge::Verdict::lower),
                               reduction(-1, 4.02, 1e-12, judge::Verdict::confirmed),
                               reduction(-1e8, NAN, 1e-9, judge::Verdict::undetermined)};
  const std::string html = index_of(data);
  const std::size_t mild = html.find("<td class=\"confirmed\" title=\"confirmed: measured 4.02"),
                    stiff = html.find("<td class=\"t2\" title=\"lower: measured 1.90"),
                    unknown = html.find("title=\"undetermined: of this test; error");
  EXPECT_NE(unknown, std::string::npos);
  ASSERT_NE(mild, std::string::npos);
  ASSERT_NE(stiff, std::string::npos);
  EXPECT_LT(mild, stiff) << "from mild to stiff, whatever the order of the rows";
  EXPECT_TRUE(has(html, "0 solvers keep the claimed order to within 0.5"));
  EXPECT_TRUE(has(html, "1 lose more"));
}

TEST(PageHardCases, LeavesOutWhoGivesNoErrorWhereItIsStiff) {
  ReportData data = small_data();
  data.hard_cases.reduction = {reduction(-1, 4, 1e-12, judge::Verdict::confirmed),
                               reduction(-1e6, NAN, NAN, judge::Verdict::undetermined)};
  const std::string html = index_of(data);
  EXPECT_TRUE(has(html, "1 give no usable error"));
  EXPECT_FALSE(has(html, "measured 4.00"));
}

TEST(PageHardCases, TellsHowMeasuredAndPredictedStepsLie) {
  const auto cell_of = [](double measured, double predicted) {
    ReportData data = small_data();
    data.hard_cases.largest_steps = {largest(data, measured, predicted)};
    const std::string html = index_of(data);
    const std::size_t at = html.find("title=\"measured ");
    return html.substr(html.rfind("<td", at), html.find("</td>", at) - html.rfind("<td", at));
  };
  EXPECT_TRUE(has(cell_of(0.0202, 0.02), "class=\"confirmed\""));
  EXPECT_TRUE(has(cell_of(0.03, 0.02), "class=\"higher\""));
  EXPECT_TRUE(has(cell_of(0.03, 0), "class=\"higher\"")) << "no step is stable in theory";
  EXPECT_TRUE(has(cell_of(0.01, 0.02), "class=\"lower\""));
  EXPECT_TRUE(has(cell_of(0.01, infinity), "class=\"lower\""));
  EXPECT_TRUE(has(cell_of(0.01, NAN), "class=\"\"")) << "no theory, no judgement";
  EXPECT_TRUE(has(cell_of(2.5, infinity), "class=\"confirmed\""));
  EXPECT_TRUE(has(cell_of(2.5, infinity), ">any"));
  EXPECT_TRUE(has(cell_of(2.5, 0.02), "class=\"higher\""));
}

TEST(PageHardCases, DrawsStepsThatHaveAFinitePrediction) {
  ReportData data = small_data();
  data.hard_cases.largest_steps = {largest(data, 0.03, 0.02), largest(data, 0.01, infinity)};
  data.hard_cases.largest_steps[1].solver = "explicit_method_2";
  const std::string html = index_of(data);
  EXPECT_EQ(count(html, "class=\"best\"><title>odeum/"), 1U);
}

TEST(PageHardCases, ACaseOnWhichNobodyWasRunHasNoColumn) {
  ReportData data = small_data();
  data.hard_cases.largest_steps = {largest(data, NAN, NAN)};
  data.hard_cases.largest_steps[0].status = "not_applicable";
  EXPECT_FALSE(has(index_of(data), "Largest stable step"));
}

TEST(PageHardCases, ShowsHowAnErrorGrows) {
  // The last tenth of the times against the tenth before: the power itself, for a pure power.
  EXPECT_NEAR(power_of(drift("c", "energy", 1)), 1, 1e-12);
  EXPECT_NEAR(power_of(drift("c", "energy", 2)), 2, 1e-12);
  EXPECT_NEAR(power_of(drift("c", "energy", 0)), 0, 1e-12);
  std::vector<DriftRow> exact = drift("c", "energy", 0);
  for (DriftRow& row : exact) row.relative_error = 0;
  EXPECT_EQ(power_of(exact), 0);
  EXPECT_TRUE(std::isnan(power_of({drift("c", "energy", 1)[4]}))) << "one row has no slope";
}

TEST(PageHardCases, ShowsDriftAsAPowerOfTenAndASign) {
  ReportData data = small_data();
  data.hard_cases.drift.rows = drift(data.cases[0].id, "energy", 1);
  EXPECT_TRUE(has(index_of(data), ">-3↗</td>"));
  data.hard_cases.drift.rows = drift(data.cases[0].id, "energy", 0);
  EXPECT_TRUE(has(index_of(data), ">-5</td>"));
  data.hard_cases.drift.rows.back().status = "newton_failed";
  EXPECT_TRUE(has(index_of(data), ">✗</td>"));
}

TEST(PageHardCases, DrawsALineASolver) {
  ReportData data = small_data();
  data.cases[0].id = "kepler_e06";
  data.hard_cases.drift.rows = drift("kepler_e06", "energy", 1);
  const std::string html = index_of(data);
  EXPECT_EQ(count(html, "<title>odeum/explicit_method_1</title></path>"), 1U);
  EXPECT_TRUE(has(html, "<path class=\"run own\""));
  EXPECT_FALSE(has(html, "<path class=\"run kept\""));
}

TEST(PageHardCases, TakesTheOscillatorApart) {
  ReportData data = small_data();
  data.cases[0].id = "osc_undamped";
  for (const char* quantity : {"energy", "amplitude", "phase"})
    for (DriftRow& row : drift("osc_undamped", quantity, 1))
      data.hard_cases.drift.rows.push_back(row);
  for (DriftRow& row : data.hard_cases.drift.rows)
    if (row.invariant == "amplitude") row.value = 1 - row.relative_error;
  const std::string html = index_of(data);
  EXPECT_TRUE(has(html, ">-1.0e-03</td>")) << "the amplitude dies away";
  EXPECT_TRUE(has(html, ">+1.0e+00</td>")) << "the lag in radians";
}

TEST(PageHardCases, ShowsHorizonsBySetting) {
  ReportData data = small_data();
  for (const double tolerance : {1e-9, 1e-6}) {
    HorizonRow row;
    row.case_id = study::horizon_case;
    row.library = "odeum";
    row.solver = "explicit_method_1";
    row.status = "ok";
    row.mode = Mode::adaptive;
    row.setting = tolerance;
    row.horizon = tolerance == 1e-9 ? 24.5 : 12.25;
    data.hard_cases.drift.horizons.push_back(row);
  }
  const std::string html = index_of(data);
  EXPECT_TRUE(has(html, "<th>tol 1e-06</th><th>tol 1e-09</th>")) << "from coarse to fine";
  EXPECT_LT(html.find(">12.2</td>"), html.find(">24.5</td>"));
  EXPECT_TRUE(has(html, ">24.5</td>"));
}

TEST(PageHardCases, HostileNamesStayText) {
  ReportData data = small_data();
  const std::string hostile = "<img src=x>\"'\x1b";
  data.solvers[0].method = hostile;
  data.hard_cases.reduction = {reduction(-1e6, 2, 1e-9, judge::Verdict::lower)};
  data.hard_cases.largest_steps = {largest(data, 0.03, 0.02)};
  data.hard_cases.drift.rows = drift(data.cases[0].id, "energy", 1);
  data.hard_cases.reduction[0].solver = data.hard_cases.largest_steps[0].solver = hostile;
  data.hard_cases.largest_steps[0].detail = hostile;
  for (DriftRow& row : data.hard_cases.drift.rows) row.solver = row.detail = hostile;
  const std::string html = index_of(data);
  EXPECT_TRUE(has(html, "<th title=\"explicit_rk\">&lt;img src=x&gt;"));
  EXPECT_FALSE(has(html, "<img src=x"));
  EXPECT_FALSE(has(html, "\x1b"));
}

}  // namespace
}  // namespace odeum::report
