// SPDX-License-Identifier: BSD-3-Clause
// A run has one status, one answer, one error and one set of remarks: in the terminal, as JSON, as
// CSV and in the folder. tests/viewer/runs.mjs compares the page with the folder.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::one_verdict_test {
namespace {

struct Asked {
  const char* name;
  const char* command;
  int code;
  const char* said;  ///< in the terminal's text
};

void PrintTo(const Asked& asked, std::ostream* out) { *out << asked.command; }

/// The terminal's text after the line of the solver, up to that of the next.
std::string part_of(const std::string& text, const std::string& solver) {
  const std::size_t begin = text.find(solver + "\n");
  return begin == std::string::npos ? "" : text.substr(begin);
}

class OneVerdict : public testing::TestWithParam<Asked> {
 protected:
  Result run(const std::string& folder, const std::string& more) const {
    return shell(fmt::format("cd '{}' && odeum {} --out {} {} 2>remarks", folder_.path().string(),
                             GetParam().command, folder, more));
  }
  std::string file(const char* name) const { return tests::text_of(folder_.path() / name); }

  TemporaryFolder folder_;
};

TEST_P(OneVerdict, InTerminalJsonCsvAndFolder) {
  const Result text = run("text", ""), json = run("json", "--format json"),
               csv = run("csv", "--format csv");
  for (const Result* each : {&text, &json, &csv})
    EXPECT_EQ(each->code, GetParam().code) << each->output << file("remarks");
  EXPECT_NE(text.output.find(GetParam().said), std::string::npos) << text.output;
  EXPECT_EQ(file("text/runs.csv"), file("json/runs.csv"));
  EXPECT_EQ(file("csv/runs.csv"), csv.output);
  EXPECT_EQ(file("csv/runs.csv"), file("text/runs.csv"));
  for (const auto& row : nlohmann::json::parse(json.output)["runs"]) {
    const std::string solver =
        row["library"].get<std::string>() + "/" + row["solver"].get<std::string>();
    const std::string part = part_of(text.output, solver);
    EXPECT_NE(part.find(row["status"].get<std::string>()), std::string::npos) << part;
    const std::string error =
        row["error_max"].is_null() ? "" : fmt::format("{:.3g}", row["error_max"].get<double>());
    EXPECT_NE(part.find(error.substr(0, 4)), std::string::npos) << error << "\n" << part;
    for (const char* said : {"answer_reason", "remarks", "detail"}) {
      const std::string whole = row[said].get<std::string>();
      EXPECT_NE(part.find(whole.substr(0, whole.find("; "))), std::string::npos) << whole << "\n"
                                                                                 << part;
    }
    if (row["answer"] == "wrong" || row["answer"] == "explained") {
      EXPECT_NE(part.find(row["answer"].get<std::string>() + ": "), std::string::npos) << part;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    , OneVerdict,
    testing::Values(
        Asked{"Scene",
              "run spring_explicit_euler --solver explicit_euler --solver implicit_euler --solver "
              "symplectic_euler --step 0.05",
              0, "wrong: it has blown up"},
        Asked{"BlownUp", "run spring_explicit_euler --solver explicit_euler --step 0.2", 3,
              "wrong: it has blown up"},
        Asked{"FailedScene", "run stiff_rope --solver rk4 --step 0.01 --until 1", 3, "non_finite"},
        Asked{"Remarks", "run robertson_40 --solver rodas4 --rtol 1e-3 --atol 1e-3", 0,
              "controls it"},
        Asked{"Diverged", "run osc_under --solver explicit_euler --solver rk4 --step 1", 0,
              "has diverged"},
        Asked{"Explained", "run lotka_volterra --solver cvode/adams --solver rk4 --tol 1e-6", 0,
              "explained: "}),
    [](const auto& each) { return each.param.name; });

// The page and the files of a run that was cut short said ok, and its chart of steps left it out.
TEST(OneVerdictOfWhy, IsThatOfTheRun) {
  const TemporaryFolder folder;
  const Result json = shell("cd '" + folder.path().string() +
                            "' && odeum why vdp_mu1000 --solver cvode/adams --tol 1e-6 --seconds 1 "
                            "--format json --out out 2>remarks");
  const auto why = nlohmann::json::parse(json.output);
  EXPECT_EQ(why["status"], "over_budget");
  EXPECT_EQ(why["run"]["status"], "over_budget");
  EXPECT_EQ(why["run"]["answer"], "none");
  const std::string runs = tests::text_of(folder.path() / "out/runs.csv");
  EXPECT_NE(runs.find(",cvode,adams,adaptive,nan,1e-06,2000,over_budget,"), std::string::npos)
      << runs;
  EXPECT_EQ(tests::text_of(folder.path() / "out/solution.csv").find(",adams,"), std::string::npos);
  EXPECT_NE(tests::text_of(folder.path() / "out/steps.csv").find(",adams,"), std::string::npos);
}

// Springs at their rest lengths have 1e-27 J by rounding alone, which was called a blow-up.
TEST(OneVerdictOfScenes, EnergyOfRoundingIsNotABlowUp) {
  const TemporaryFolder folder;
  tests::write_text(
      folder.path() / "square.yaml",
      "duration: 1\ngravity: 0\nsolver: {type: implicit_euler_linearised, timestep: 0.004}\n"
      "cloth:\n  - {rows: 5, columns: 5, origin: [0, 0, 0], row_edge: [1, 0, 0], "
      "column_edge: [0, 1, 0], mass: 1000, structural: {stiffness: 1e5, damping: 0}, "
      "shear: {stiffness: 1e5, damping: 0}}\n");
  const Result result = shell("odeum run '" + (folder.path() / "square.yaml").string() +
                              "' --solver rk4 --step 0.001 --no-truth");
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_EQ(result.output.find("blown up"), std::string::npos) << result.output;
}

// A command that a remark gives does what the remark says.
TEST(Remarks, GiveACommandThatControlsTheError) {
  const std::string run = "odeum run robertson_40 --solver rodas4 ";
  const std::string text = shell(run + "--rtol 1e-3 --atol 1e-3").output;
  const std::size_t begin = text.find("; --rtol"), end = text.find(" controls it");
  ASSERT_LT(begin, end) << text;
  const Result again = shell(run + text.substr(begin + 2, end - begin - 2));
  EXPECT_EQ(again.code, 0) << again.output;
  EXPECT_EQ(again.output.find("never exceeds"), std::string::npos) << again.output;
}

}  // namespace
}  // namespace odeum::tests::one_verdict_test
