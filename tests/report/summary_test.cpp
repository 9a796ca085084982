// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <sstream>

#include "odeum/studies/convergence/convergence.hpp"
#include "support/report_fixture.hpp"

namespace odeum::study::summary_test {
namespace {

TEST(Summary, CountsAddUp) {
  const test::MadeUp data = test::fabricate_report();
  const std::vector<LibrarySummary> list = summarise(data.facts, data.convergence.orders);
  ASSERT_EQ(list.size(), 7U) << "six libraries, and all of them";
  LibrarySummary sum{.library = "sum"};
  for (std::size_t i = 0; i + 1 < list.size(); ++i) {
    sum.solvers += list[i].solvers;
    sum.pairs += list[i].pairs;
    std::size_t verdicts = 0;
    for (std::size_t v = 0; v < sum.verdicts.size(); ++v) {
      verdicts += list[i].verdicts[v];
      sum.verdicts[v] += list[i].verdicts[v];
    }
    EXPECT_EQ(verdicts, list[i].pairs) << list[i].library;
  }
  EXPECT_EQ(list.back().solvers, data.facts.solvers.size());
  EXPECT_EQ(list.back().pairs, data.convergence.orders.size());
  EXPECT_EQ(sum.solvers, list.back().solvers);
  EXPECT_EQ(sum.verdicts, list.back().verdicts);
}

TEST(Summary, TableIsCountedByHand) {
  SolverInfo solver;
  solver.library = "mine\x1b[1m";
  solver.method = "a";
  report::Facts facts;
  facts.solvers = {solver};
  std::vector<OrderRow> orders;
  for (const judge::Verdict verdict :
       {judge::Verdict::confirmed, judge::Verdict::confirmed, judge::Verdict::lower}) {
    OrderRow row;
    row.library = solver.library;
    row.solver = "a";
    row.fit.verdict = verdict;
    orders.push_back(row);
  }
  std::istringstream lines(summary_text(facts, orders));
  std::string line, library;
  std::getline(lines, line);
  for (const char* heading : {"library", "solvers", "confirmed", "not_applicable"})
    EXPECT_TRUE(test::has(line, heading)) << line;
  std::getline(lines, line);
  EXPECT_FALSE(test::has(line, "\x1b"));
  std::size_t solvers = 0, pairs = 0, confirmed = 0, higher = 9, lower = 0;
  std::istringstream(line) >> library >> solvers >> pairs >> confirmed >> higher >> lower;
  EXPECT_EQ(std::vector<std::size_t>({solvers, pairs, confirmed, higher, lower}),
            std::vector<std::size_t>({1, 3, 2, 0, 1}));
}

}  // namespace
}  // namespace odeum::study::summary_test
