// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <nlohmann/json.hpp>

#include "odeum/report/report.hpp"
#include "odeum/studies/precision/precision.hpp"
#include "odeum/studies/questions.hpp"
#include "odeum/studies/stopwatch.hpp"

namespace odeum::study {
namespace {

/// One line a case and pair of solvers, with the smallest error at which they are the fastest.
std::string table(const PrecisionResult& result) {
  std::vector<PrecisionSummary> lines;
  // A time that is not known is as good as another.
  const auto equal = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  for (const PrecisionSummary& row : result.summary) {
    const bool same = !lines.empty() && lines.back().case_id == row.case_id &&
                      lines.back().own == row.own && lines.back().peer == row.peer &&
                      equal(lines.back().own_ns, row.own_ns) &&
                      equal(lines.back().peer_ns, row.peer_ns);
    if (same)
      lines.back() = row;
    else
      lines.push_back(row);
  }
  return record::table_of(lines,
                          "case error:.0e own own_ns:.0f peer peer_ns:.0f ratio:.2f ratio_low:.2f "
                          "ratio_high:.2f reason")
      .text();
}

/// The cases of the first page; in a full report another orbit, many bodies, and a stiff
/// oscillator. With short limits.
std::vector<Options> report_runs(bool quick) {
  std::vector<std::string> cases = quick_cases();
  if (!quick) cases.insert(cases.end(), {"kepler_e06", "pleiades", "vdp_mu1000"});
  return {
      {.cases = cases,
       .own = {{"seconds", quick ? "0.6" : "1.1"}, {"solve-seconds", "0.05"}, {"attempts", "1"}}}};
}

/// The questions of the first page.
void show_questions(report::Report& report, const PrecisionResult&) {
  nlohmann::ordered_json asked = nlohmann::ordered_json::array();
  for (const Question& question : questions)
    asked.push_back({{"title", question.title}, {"case", question.case_id}});
  report.fact("questions", asked);
}

}  // namespace

std::unique_ptr<Study> make_precision() {
  return make_study<PrecisionResult>(
      {.name = "precision",
       .help = "time against error, who is fastest where",
       .place = 10,
       .no_resume = "times of two runs of the program do not compare",
       .options = {timed_seconds, solve_seconds, most_attempts},
       .figures = {{"most_disturbance", most_disturbance}},
       .report = report_runs(false),
       .quick_report = report_runs(true)},
      {.measure = measure_precision, .table = table, .show_more = show_questions});
}

}  // namespace odeum::study
