// SPDX-License-Identifier: BSD-3-Clause
// What the program says of itself: help, hints, completions, lists.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::words_test {
namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A dimension was the text "2", and there were no stops.
TEST(Words, ListsGiveNumbersAsNumbers) {
  const auto cases = nlohmann::json::parse(shell("odeum list cases --format json").output);
  for (const auto& each : cases) {
    EXPECT_TRUE(each["dimension"].is_number_unsigned() || each["dimension"].is_null()) << each;
    ASSERT_TRUE(each["stops"].is_array()) << each;
    if (each["id"] == "lotka_volterra") {
      EXPECT_EQ(each["stops"], nlohmann::json({1, 2, 5, 10}));
    }
    if (!each["stops"].empty())
      EXPECT_EQ(each["horizon"], each["stops"].back());
    else
      EXPECT_TRUE(each["horizon"].is_null());
  }
  const auto solvers = nlohmann::json::parse(shell("odeum list solvers --format json").output);
  for (const auto& each : solvers)
    EXPECT_TRUE(each["order"].is_number() || each["order"].is_null()) << each;
  const auto scenes = nlohmann::json::parse(shell("odeum list scenes --format json").output);
  EXPECT_TRUE(scenes.front()["particles"].is_number_unsigned());
  EXPECT_TRUE(shell("odeum list solvers --format csv").output.find(",varies,") !=
              std::string::npos);
}

/// What a command prints, without remarks.
nlohmann::json json_said(const std::string& command) {
  return nlohmann::json::parse(shell(command + " 2>/dev/null").output);
}

TEST(Words, RunsAndStudiesPrintTheirRowsAsJson) {
  const TemporaryFolder folder;
  const std::string out = " --format json --out " + folder.path().string();
  const auto runs =
      json_said("odeum run lotka_volterra --solver rk4 heun --step 0.1" + out).at("runs");
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[1]["solver"], "heun");
  EXPECT_EQ(runs[0]["steps"], 100);
  EXPECT_EQ(runs[0]["rhs_evaluations"], 400);
  EXPECT_TRUE(runs[0]["tolerance"].is_null());
  const std::string text =
      shell("odeum run lotka_volterra --solver rk4 --step 0.1 | grep error").output;
  EXPECT_NEAR(std::stod(text.substr(text.find("error") + 5)), runs[0]["error_max"], 1e-9) << text;
  const auto failed = json_said(
      "odeum run dahlquist_real --solver implicit_euler_fixed_point --step 2 --format json");
  EXPECT_EQ(failed["runs"][0]["status"], "newton_failed") << failed;
  EXPECT_TRUE(failed["runs"][0]["error_max"].is_null());

  const auto study =
      json_said("odeum converge --quick --case dahlquist_real --mode fixed --solver rk4" + out);
  ASSERT_EQ(study.at("orders.csv").size(), 1U);
  EXPECT_NEAR(study["orders.csv"][0]["measured_order"], 4, 0.2);
  EXPECT_GT(study.at("convergence.csv").size(), 3U);
  for (const char* name : {"precision", "stability", "limits", "drift", "reduction", "material",
                           "cloth", "cost", "mesh", "proof", "elements", "evolution"})
    EXPECT_TRUE(holds(shell("odeum " + std::string(name) + " --help").output, "--format")) << name;
  EXPECT_EQ(json_said("odeum run spinning_pair --no-truth --format json")["runs"][0]["solver"],
            "rk4");
}

TEST(Words, NamesTheNearestSubcommandAndOption) {
  for (const auto& [command, hint] :
       {std::pair("odeum convrge", "did you mean converge?"),
        std::pair("odeum lsit", "did you mean list?"),
        std::pair("odeum run lotka_volterra --sovler rk4", "--solver?"),
        std::pair("odeum converge --soler=rk4", "--solver?")}) {
    const Result result = shell(command);
    EXPECT_EQ(result.code, 2) << result.output;
    EXPECT_TRUE(holds(result.output, hint)) << result.output;
  }
}

TEST(Words, HelpKeepsToTheWidth) {
  std::istringstream lines(shell("COLUMNS=70 odeum run --help").output);
  std::size_t longest = 0;
  for (std::string line; std::getline(lines, line);)
    // A list of formats without spaces is as long as it is.
    if (line.find("CASE|SCENE.yaml") == std::string::npos) longest = std::max(longest, line.size());
  EXPECT_LE(longest, 70U);
  EXPECT_GT(longest, 50U);
}

TEST(Words, HelpIsACommandToo) {
  EXPECT_EQ(shell("odeum help run").output, shell("odeum run --help").output);
  const std::string all = shell("odeum help").output;
  EXPECT_EQ(all, shell("odeum --help").output);
  for (const char* group : {"\nQuestions:\n", "\nLaboratory:\n", "\nMany runs:\n", "\nTools:\n"})
    EXPECT_TRUE(holds(all, group)) << all;
}

TEST(Words, TheVersionNamesTheCommit) {
  const std::string text = shell("odeum --version").output;
  EXPECT_TRUE(text.starts_with("odeum 0.")) << text;
  // Sources without their history have none.
  EXPECT_EQ(holds(text, " ("), std::filesystem::exists(ODEUM_SOURCE_DIR "/.git")) << text;
}

/// What bash completes after these words.
std::string completed(const std::string& words) {
  return shell("source <(odeum completion bash); COMP_WORDS=(" + words +
               "); COMP_CWORD=$((${#COMP_WORDS[@]}-1)); _odeum; echo ${COMPREPLY[@]}")
      .output;
}

TEST(Words, BashCompletes) {
  EXPECT_EQ(completed("odeum conv"), "converge\n");
  EXPECT_EQ(completed("odeum list --form"), "--format\n");
  EXPECT_EQ(completed("odeum list --format j"), "json\n");
  EXPECT_EQ(completed("odeum list sce"), "scenes\n");
  EXPECT_EQ(completed("odeum run --solver odeum/rodas5"), "odeum/rodas5p\n");
  EXPECT_EQ(completed("odeum run --solver rodas5"), "rodas5p\n");
  EXPECT_EQ(completed("odeum run lotka_v"), "lotka_volterra\n");
  EXPECT_EQ(completed("odeum why spherical_p"), "spherical_pendulum\n");
}

// Every command and option stands in all of them.
TEST(Words, CompletionsAndTheManualNameEveryOption) {
  const std::string manual = shell("odeum completion man").output;
  EXPECT_TRUE(holds(manual, ".TH ODEUM 1"));
  EXPECT_TRUE(holds(manual, ".SS \"odeum converge\"")) << manual.substr(0, 2000);
  EXPECT_TRUE(holds(manual, "\\-\\-resume"));
  const std::string zsh = shell("odeum completion zsh").output;
  EXPECT_TRUE(zsh.starts_with("#compdef odeum\n"));
  EXPECT_TRUE(holds(zsh,
                    "'*--format[what is printed\\: table (for people), csv (rows), or json (all of "
                    "it)]: :(table csv json)'"))
      << zsh;
  const std::string fish = shell("odeum completion fish").output;
  EXPECT_TRUE(holds(fish, "__fish_seen_subcommand_from list' -l format -r -f -a"));
  EXPECT_EQ(shell("odeum completion csh").code, 2);
}

}  // namespace
}  // namespace odeum::tests::words_test
