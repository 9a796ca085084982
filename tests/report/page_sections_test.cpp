// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "odeum/studies/drift/section.hpp"
#include "odeum/studies/limits/limits.hpp"
#include "odeum/studies/reduction/reduction.hpp"
#include "support/report_fixture.hpp"

namespace odeum::study {
namespace {

using test::count;
using test::has;

constexpr double infinity = std::numeric_limits<double>::infinity();

report::Facts small_facts() { return test::fabricate_small_report().facts; }

template <class Result>
std::string index_of(const Result& result, const report::Facts& facts = small_facts(),
                     const Origin& origin = {}) {
  return test::Report(facts).add(result, origin).index();
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

LargestStep largest(double measured, double predicted) {
  LargestStep row;
  row.case_id = small_facts().cases[0].id;
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

TEST(PageSections, SayWhereNothingWasMeasured) {
  const std::string html =
      index_of(DriftResult(), small_facts(),
               {.command = "drift", .problem = "the drift.csv that was there is <cut> off"});
  EXPECT_TRUE(has(html, "Not measured in this run: <code>odeum drift</code> with this folder"));
  EXPECT_TRUE(has(html, "measures it, and the next report shows it.</p>"));
  EXPECT_TRUE(has(html, "is &lt;cut&gt; off"));
  EXPECT_FALSE(has(html, "Amplitude, phase"));
}

TEST(PageSections, SayWhatWasSelectedOrThatResultsAreOfAnEarlierRun) {
  const ReductionResult result{{reduction(-1e6, 2, 1e-9, judge::Verdict::lower)}};
  Origin origin{.command = "reduction", .selection = "solvers odeum/* on every case"};
  EXPECT_TRUE(has(index_of(result, small_facts(), origin), "selection: solvers odeum/* on every"));
  origin.measured = false;
  const std::string html = index_of(result, small_facts(), origin);
  EXPECT_TRUE(has(html, "these are results of an earlier one"));
  EXPECT_FALSE(has(html, "selection: "));
}

TEST(PageSections, ColoursTheOrdersThatAreLost) {
  const std::string html =
      index_of(ReductionResult{{reduction(-1e6, 1.9, 1e-9, judge::Verdict::lower),
                                reduction(-1, 4.02, 1e-12, judge::Verdict::confirmed),
                                reduction(-1e8, NAN, 1e-9, judge::Verdict::undetermined)}});
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

TEST(PageSections, LeavesOutWhoGivesNoErrorWhereItIsStiff) {
  const std::string html =
      index_of(ReductionResult{{reduction(-1, 4, 1e-12, judge::Verdict::confirmed),
                                reduction(-1e6, NAN, NAN, judge::Verdict::undetermined)}});
  EXPECT_TRUE(has(html, "1 give no usable error"));
  EXPECT_FALSE(has(html, "measured 4.00"));
}

TEST(PageSections, TellsHowMeasuredAndPredictedStepsLie) {
  const auto cell_of = [](double measured, double predicted) {
    const std::string html = index_of(LimitsResult{{largest(measured, predicted)}});
    const std::size_t at = html.find("title=\"measured ");
    return html.substr(html.rfind("<td", at), html.find("</td>", at) - html.rfind("<td", at));
  };
  EXPECT_TRUE(has(cell_of(0.0202, 0.02), "class=\"confirmed\""));
  EXPECT_TRUE(has(cell_of(0.03, 0.02), "class=\"higher\""));
  EXPECT_TRUE(has(cell_of(0.03, 0), "class=\"higher\"")) << "no step is stable in theory";
  EXPECT_TRUE(has(cell_of(0.01, 0.02), "class=\"lower\""));
  EXPECT_TRUE(has(cell_of(0.01, infinity), "class=\"lower\""));
  EXPECT_FALSE(has(cell_of(0.01, NAN), "class=")) << "no theory, no judgement";
  EXPECT_TRUE(has(cell_of(2.5, infinity), "class=\"confirmed\""));
  EXPECT_TRUE(has(cell_of(2.5, infinity), ">any"));
  EXPECT_TRUE(has(cell_of(2.5, 0.02), "class=\"higher\""));
}

TEST(PageSections, DrawsStepsThatHaveAFinitePrediction) {
  LimitsResult result{{largest(0.03, 0.02), largest(0.01, infinity)}};
  result.rows[1].solver = "explicit_method_2";
  EXPECT_EQ(count(index_of(result), "class=\"faint\"><title>odeum/"), 1U);
}

TEST(PageSections, ACaseOnWhichNobodyWasRunHasNoColumn) {
  LimitsResult result{{largest(NAN, NAN)}};
  result.rows[0].status = "not_applicable";
  EXPECT_FALSE(has(index_of(result), "as predicted"));
}

TEST(PageSections, ShowsHowAnErrorGrows) {
  // The last tenth of the times against the tenth before: the power itself, for a pure power.
  EXPECT_NEAR(power_of(drift("c", "energy", 1)), 1, 1e-12);
  EXPECT_NEAR(power_of(drift("c", "energy", 2)), 2, 1e-12);
  EXPECT_NEAR(power_of(drift("c", "energy", 0)), 0, 1e-12);
  std::vector<DriftRow> exact = drift("c", "energy", 0);
  for (DriftRow& row : exact) row.relative_error = 0;
  EXPECT_EQ(power_of(exact), 0);
  EXPECT_TRUE(std::isnan(power_of({drift("c", "energy", 1)[4]}))) << "one row has no slope";
}

TEST(PageSections, ShowsDriftAsAPowerOfTenAndASign) {
  const std::string id = small_facts().cases[0].id;
  DriftResult result{drift(id, "energy", 1), {}};
  EXPECT_TRUE(has(index_of(result), ">-3↗</td>"));
  result.rows = drift(id, "energy", 0);
  EXPECT_TRUE(has(index_of(result), ">-5</td>"));
  result.rows.back().status = "newton_failed";
  EXPECT_TRUE(has(index_of(result), ">✗</td>"));
}

TEST(PageSections, DrawsALineASolver) {
  report::Facts facts = small_facts();
  facts.cases[0].id = "kepler_e06";
  const std::string html = index_of(DriftResult{drift("kepler_e06", "energy", 1), {}}, facts);
  EXPECT_EQ(count(html, "<title>odeum/explicit_method_1</title></path>"), 1U);
  EXPECT_TRUE(has(html, "<path class=\"run own\""));
  EXPECT_FALSE(has(html, "<path class=\"run kept\""));
}

TEST(PageSections, TakesTheOscillatorApart) {
  DriftResult result;
  for (const char* quantity : {"energy", "amplitude", "phase"})
    for (DriftRow& row : drift("osc_undamped", quantity, 1)) result.rows.push_back(row);
  for (DriftRow& row : result.rows)
    if (row.invariant == "amplitude") row.value = 1 - row.relative_error;
  const std::string html = index_of(result);
  EXPECT_TRUE(has(html, ">-1.0e-03</td>")) << "the amplitude decays";
  EXPECT_TRUE(has(html, ">+1.0e+00</td>")) << "the lag in radians";
}

TEST(PageSections, ShowsHorizonsBySetting) {
  DriftResult result;
  for (const double tolerance : {1e-9, 1e-6}) {
    HorizonRow row;
    row.case_id = "lorenz_kehlet_logg";
    row.library = "odeum";
    row.solver = "explicit_method_1";
    row.status = "ok";
    row.mode = Mode::adaptive;
    row.setting = tolerance;
    row.horizon = tolerance == 1e-9 ? 24.5 : 12.25;
    result.horizons.push_back(row);
  }
  const std::string html = index_of(result);
  EXPECT_TRUE(has(html, "<th>tol 1e-06</th><th>tol 1e-09</th>")) << "from coarse to fine";
  EXPECT_LT(html.find(">12.2</td>"), html.find(">24.5</td>"));
  EXPECT_TRUE(has(html, ">24.5</td>"));
}

TEST(PageSections, HostileNamesStayText) {
  const std::string hostile = "<img src=x>\"'\x1b";
  report::Facts facts = small_facts();
  facts.solvers[0].method = hostile;
  ReductionResult reduced{{reduction(-1e6, 2, 1e-9, judge::Verdict::lower)}};
  LimitsResult limits{{largest(0.03, 0.02)}};
  DriftResult drifted{drift(facts.cases[0].id, "energy", 1), {}};
  reduced.rows[0].solver = limits.rows[0].solver = limits.rows[0].detail = hostile;
  for (DriftRow& row : drifted.rows) row.solver = row.detail = hostile;
  for (const std::string& html :
       {index_of(reduced, facts), index_of(limits, facts), index_of(drifted, facts)}) {
    EXPECT_TRUE(has(html, "<th title=\"explicit_rk\">&lt;img src=x&gt;"));
    EXPECT_FALSE(has(html, "<img src=x"));
    EXPECT_FALSE(has(html, "\x1b"));
  }
}

}  // namespace
}  // namespace odeum::study
