// SPDX-License-Identifier: BSD-3-Clause
// Trajectories of programs that share nothing with Odeum (data/ is written by make_data.py): every
// claim is judged rightly, and the mistake named where the numbers show it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "odeum/brought/judgement.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/text_case.hpp"
#include "odeum/truth/computed_truth.hpp"
#include "support/program.hpp"

namespace odeum::tests::judgement_test {
namespace {

Case case_of_text(const std::string& text) {
  return case_of(cases::text_statements("my.yaml", text, "oscillator", {}).front());
}

using brought::Claimed;
using judge::Verdict;

constexpr const char* oscillator =
    "parameters: {damping: 0.2}\nstates: {q: 1, v: 0}\n"
    "equations: {q: v, v: -q - damping*v}\ntime: {end: 4}\n";
constexpr const char* driven =
    "states: {q: 1, v: 0}\nequations: {q: v, v: -q + sin(2*t)}\ntime: {end: 4}\n";

struct Program {
  const char* folder;
  const char* claims;
  Claimed claim;
  Verdict verdict;
  const char* method;   ///< the likeliest
  const char* mistake;  ///< a part of what it says; empty: none
  const char* problem = oscillator;

  friend void PrintTo(const Program& program, std::ostream* out) { *out << program.folder; }
};

brought::SeriesRow judged(const Program& program) {
  Case c = case_of_text(program.problem);
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(ODEUM_SOURCE_DIR) / "tests/brought/data" / program.folder))
    files.push_back(entry.path().string());
  std::vector<brought::Trajectory> runs;
  for (const std::string& file : files) runs.push_back(brought::read_trajectory(c, file, {}, 0));
  brought::Claim claim;
  claim.method = program.claims;
  for (const Solver& solver : all_solvers())
    if (solver.info.id() == "odeum/" + claim.method) claim.order = solver.info.order;
  c.truth = truth::truth_at(c, brought::times_of(c, runs, claim));
  const brought::Judgement judgement = brought::judge_runs(c, runs, claim);
  EXPECT_EQ(judgement.series.size(), 1U);
  EXPECT_EQ(judgement.files.size(), 3U);
  return judgement.series.front();
}

class Programs : public testing::TestWithParam<Program> {};

TEST_P(Programs, AreJudgedRightly) {
  const Program& program = GetParam();
  const brought::SeriesRow row = judged(program);
  EXPECT_STREQ(to_string(row.claim), to_string(program.claim)) << row.reason;
  EXPECT_STREQ(to_string(row.verdict), to_string(program.verdict)) << row.reason;
  EXPECT_EQ(row.likeliest, program.method) << row.reason;
  const std::string mistake = program.mistake;
  if (mistake.empty())
    EXPECT_EQ(row.mistake, "") << row.reason;
  else
    EXPECT_NE(row.reason.find(mistake), std::string::npos) << row.reason;
}

// Verdicts are those of the methods' orders: k3 from k1 leaves 2, and so do equal weights; a k4
// half way, frozen times and components on their own leave 1. DOP853's errors are rounding at two
// of three steps, which give no order.
INSTANTIATE_TEST_SUITE_P(
    , Programs,
    testing::Values(
        Program{"scipy_RK23", "bogacki_shampine32", Claimed::held, Verdict::confirmed,
                "bogacki_shampine32", ""},
        Program{"scipy_RK45", "dormand_prince54", Claimed::held, Verdict::confirmed,
                "dormand_prince54", ""},
        Program{"scipy_DOP853", "dormand_prince853", Claimed::held, Verdict::undetermined,
                "dormand_prince853", ""},
        Program{"scipy_Radau", "radau_iia5", Claimed::held, Verdict::confirmed, "radau_iia5", ""},
        Program{"euler", "explicit_euler", Claimed::held, Verdict::confirmed, "explicit_euler", ""},
        Program{"symplectic_euler", "symplectic_euler", Claimed::held, Verdict::confirmed,
                "symplectic_euler", ""},
        Program{"heun", "heun", Claimed::held, Verdict::confirmed, "heun", ""},
        Program{"rk4", "rk4", Claimed::held, Verdict::confirmed, "rk4", ""},
        Program{"rk4_k3_from_k1", "rk4", Claimed::denied, Verdict::lower, "rk4",
                "k3 is computed from k1 in place of k2"},
        Program{"rk4_half_k4", "rk4", Claimed::denied, Verdict::lower, "rk4",
                "k4 is computed with 0.5 h k3 in place of 1 h k3"},
        Program{"rk4_equal_weights", "rk4", Claimed::denied, Verdict::lower, "rk4",
                "every slope has the weight 0.25"},
        Program{"rk4_frozen_time", "rk4", Claimed::denied, Verdict::lower, "rk4",
                "all slopes are taken at the time at which the step begins", driven},
        Program{"rk4_in_place", "rk4", Claimed::denied, Verdict::floors, "rk4",
                "each stage changes the state that the step begins with"},
        Program{"rk4_by_component", "rk4", Claimed::denied, Verdict::lower, "rk4",
                "each component on its own"},
        Program{"verlet_old_acceleration", "velocity_verlet", Claimed::denied, Verdict::lower,
                "velocity_verlet", "velocities use the old acceleration alone"},
        Program{"heun_half_step", "heun", Claimed::denied, Verdict::lower, "heun",
                "k2 is computed with 0.5 h k1"},
        Program{"old_velocity", "symplectic_euler", Claimed::denied, Verdict::confirmed,
                "explicit_euler", "positions use the old velocities"},
        Program{"one_time_too_few", "rk4", Claimed::denied, Verdict::lower, "rk4",
                "its steps are 0.95 times as long as the times in the file say"},
        Program{"adams_equal_weights", "adams_bashforth2", Claimed::denied, Verdict::lower,
                "adams_bashforth2", "both slopes have the weight 1/2"},
        Program{"other_damping", "rk4", Claimed::denied, Verdict::floors, "rk4",
                "damping is 0.25 in place of 0.2"}),
    [](const auto& info) { return std::string(info.param.folder); });

TEST(Judge, SaysTheSameOnTheCommandLine) {
  const std::string data = ODEUM_SOURCE_DIR "/tests/brought/data/";
  const std::string make =
      "cd $(mktemp -d) && printf '%s' 'states: {q: 1, v: 0}\nequations: {q: v, "
      "v: -q - 0.2*v}\ntime: {end: 4}\n' > my.yaml && odeum judge my.yaml ";
  EXPECT_EQ(shell(make + data + "rk4 --claims rk4").code, 0);
  EXPECT_EQ(shell(make + data + "rk4 --order 5").code, 1);
  EXPECT_EQ(shell(make + data + "rk4 --tube 1e-3").code, 0);
  EXPECT_EQ(shell(make + data + "euler --tube 1e-3").code, 1);
  // Euler's trajectory is ahead of time: a shift brings a share of it back into the tube.
  const std::string wide =
      shell(make + data + "euler/euler_h0.05.csv --tube 0.05 --format json").output;
  const std::string shifted =
      shell(make + data + "euler/euler_h0.05.csv --tube 0.05,0.1 --format json").output;
  EXPECT_NE(wide, shifted);
  const Result denied = shell(make + data + "rk4_k3_from_k1 --claims rk4 --format json");
  EXPECT_EQ(denied.code, 1);
  for (const char* key : {"\"verdict\": \"lower\"", "\"measured_order\": 1.9", "\"order_low\": 1.",
                          "\"order_high\": 2.", "\"reason\": \"converges with order 1.9"})
    EXPECT_NE(denied.output.find(key), std::string::npos) << key << '\n' << denied.output;
}

}  // namespace
}  // namespace odeum::tests::judgement_test
