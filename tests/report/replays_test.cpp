// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/trajectories/report_parts.hpp"
#include "support/catalogue.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::trajectories::replays_test {
namespace {

/// The cloth of the replays with these of its solvers alone.
Case cloth_with(const std::vector<std::string>& solvers) {
  Case c = tests::find_case(replayed_case);
  Entrants chosen;
  for (const std::string& id : solvers) chosen.add(tests::find_entrant(c, id));
  c.entrants = chosen;
  return c;
}

// A report may leave out the solver that gives the exact motion, or a build may not have the rest.
TEST(Replays, NoOtherRunStandsForTheExactOne) {
  const tests::TemporaryFolder root;
  const record::OutputFolder folder(root.path() / "out");
  EXPECT_TRUE(write_replays(cloth_with({}), folder, 1).empty());
  const auto rows = write_replays(cloth_with({"odeum/symplectic_euler"}), folder, 1);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].status, "ok") << rows[0].detail;
  EXPECT_TRUE(std::isnan(rows[0].error)) << rows[0].error;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / rows[0].replay));
}

}  // namespace
}  // namespace odeum::trajectories::replays_test
