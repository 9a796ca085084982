// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/summary.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "odeum/report/manifest.hpp"
#include "support/report_fixture.hpp"

namespace odeum::report {
namespace {

TEST(Manifest, SaysWithWhatAndWhatWasSkipped) {
  const ReportData data = test::fabricate_report();
  const auto m = nlohmann::json::parse(manifest_json(data, "drawn"));
  EXPECT_EQ(m["schema"], 1);
  EXPECT_EQ(m["plots"], "drawn");
  EXPECT_EQ(m["odeum"]["version"], "0.1.0");
  EXPECT_NE(m["build"]["compiler"], "");
  EXPECT_NE(m["cpu"], "");
  EXPECT_EQ(m["options"]["quick"], false);
  EXPECT_EQ(m["seconds"], 123.4);
  ASSERT_EQ(m["libraries"].size(), 4U);
  EXPECT_EQ(m["libraries"][0]["version"], "6.4.1");
  EXPECT_EQ(m["libraries"][3]["version"], nullptr);
  EXPECT_EQ(m["libraries"][3]["option"], "ODEUM_WITH_BULLET");
  const std::string date = m["date"];
  EXPECT_EQ(date.size(), std::string("2025-01-01T00:00:00Z").size());
  const auto unfit = std::count_if(data.convergence.rows.begin(), data.convergence.rows.end(),
                                   [](const auto& row) { return row.status == "not_applicable"; });
  ASSERT_EQ(m["skipped"]["not_applicable"].size(), 1U);
  EXPECT_EQ(m["skipped"]["not_applicable"][0]["pairs"], unfit);
}

TEST(Summary, CountsAddUp) {
  const ReportData data = test::fabricate_report();
  const std::vector<LibrarySummary> list = summarise(data);
  ASSERT_EQ(list.size(), 7U) << "six libraries and their total";
  LibrarySummary sum{.library = "sum"};
  for (std::size_t i = 0; i + 1 < list.size(); ++i) {
    sum.solvers += list[i].solvers;
    sum.pairs += list[i].pairs;
    std::size_t verdicts = 0;
    for (std::size_t v = 0; v < verdict_styles.size(); ++v) {
      verdicts += list[i].verdicts[v];
      sum.verdicts[v] += list[i].verdicts[v];
    }
    EXPECT_EQ(verdicts, list[i].pairs) << list[i].library;
  }
  EXPECT_EQ(list.back().solvers, data.solvers.size());
  EXPECT_EQ(list.back().pairs, data.convergence.orders.size());
  EXPECT_EQ(sum.solvers, list.back().solvers);
  EXPECT_EQ(sum.verdicts, list.back().verdicts);
}

TEST(Summary, TableIsCountedByHand) {
  ReportData data;
  SolverInfo solver;
  solver.library = "mine\x1b[1m";
  solver.method = "a";
  data.solvers = {solver};
  for (const judge::Verdict verdict :
       {judge::Verdict::confirmed, judge::Verdict::confirmed, judge::Verdict::lower}) {
    study::OrderRow row;
    row.library = solver.library;
    row.solver = "a";
    row.fit.verdict = verdict;
    data.convergence.orders.push_back(row);
  }
  std::string root = (std::filesystem::temp_directory_path() / "odeum_summary_XXXXXX").string();
  ASSERT_NE(::mkdtemp(root.data()), nullptr);
  const record::OutputFolder folder(root);
  std::istringstream lines(summary_table(data, folder));
  std::string line, library;
  std::getline(lines, line);
  EXPECT_NE(line.find("confirmed  higher  lower  floors  undetermined  failed  not_applicable"),
            std::string::npos);
  std::getline(lines, line);
  EXPECT_EQ(line.find('\x1b'), std::string::npos);
  std::size_t solvers = 0, pairs = 0, confirmed = 0, higher = 9, lower = 0;
  std::istringstream(line) >> library >> solvers >> pairs >> confirmed >> higher >> lower;
  EXPECT_EQ(std::vector<std::size_t>({solvers, pairs, confirmed, higher, lower}),
            std::vector<std::size_t>({1, 3, 2, 0, 1}));
  std::getline(lines, line);
  std::getline(lines, line);
  EXPECT_EQ(line, "report: " + root + "/index.html");
  std::filesystem::remove_all(root);
}

}  // namespace
}  // namespace odeum::report
