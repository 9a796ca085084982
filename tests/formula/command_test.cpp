// SPDX-License-Identifier: BSD-3-Clause
// The built program on problem files: exit codes, messages, files.
#include <gtest/gtest.h>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::command_test {
namespace {

namespace fs = std::filesystem;

const std::string cases = ODEUM_SOURCE_DIR "/cases/", problems = cases + "problems/";

class ProblemCommands : public testing::Test {
 protected:
  /// Runs the program with arguments, and variables before it, in a folder of its own.
  tests::Result odeum(const std::string& arguments, const std::string& variables = "") const {
    const std::string folder = folder_.path().string();
    return tests::shell("cd '" + folder + "' && export XDG_CACHE_HOME='" + folder + "/cache' " +
                        variables + " && odeum " + arguments);
  }
  void expect(const std::string& arguments, int code, const std::string& part,
              const std::string& variables = "") const {
    const tests::Result result = odeum(arguments, variables);
    EXPECT_EQ(result.code, code) << arguments << '\n' << result.output;
    EXPECT_NE(result.output.find(part), std::string::npos) << arguments << '\n' << result.output;
  }
  void write(const std::string& name, const std::string& text) const {
    tests::write_text(folder_.path() / name, text);
  }
  /// Writes the problem of a built-in text without its cases, and with a parameter more, so that it
  /// has code of its own.
  void write_own(const std::string& name) const {
    std::string text = tests::text_of(cases + name);
    text.resize(text.find("\ncase:") + 1);
    const std::string parameters = "parameters: {";
    text.insert(text.find(parameters) + parameters.size(), "nothing: 0, ");
    write(name, text);
  }

  tests::TemporaryFolder folder_;
};

TEST_F(ProblemCommands, RunSaysWhatWasFoundAndHowGoodTheTruthIs) {
  write_own("kepler.yaml");
  expect("run kepler.yaml", 0, "second order, q'' = a(t, q): separable");
  const std::string run = "run kepler.yaml --solver rk4 --step 0.01";
  expect(run, 0, "known to ");
  expect(run, 0, "from the cache");
  expect(run + " --set eccentricity=0.3", 0, "eccentricity = 0.3");
  expect("run kepler.yaml --step 0.1", 2, "--solver is required");
  expect("run kepler.yaml --solver exponential_propagator --step 0.1", 2, "does not fit kepler: ");
}

// A file says of its cases what a built-in one says.
TEST_F(ProblemCommands, AFileOfSeveralCasesHasThemAll) {
  const std::string run = "run " + cases + "kepler.yaml --case kepler_e06 --solver rk4 --step 0.01";
  expect(run, 0, "against cases/reference/kepler_e06.csv");
  expect(run, 0, "as a built-in case");
  expect(run + " --set eccentricity=0.3", 0, "eccentricity = 0.3");
  expect(run + " --set eccentricity=1", 2, "1 - eccentricity: got 0, expected a positive number");
  expect("converge " + cases + "kepler.yaml --solver odeum/ralston2 --mode fixed --out out", 0,
         "kepler_e09_text");
}

TEST_F(ProblemCommands, OfSeveralCasesOneIsChosen) {
  const std::string of_two = cases + "kepler.yaml --solver rk4 --step 0.01";
  const std::string one = "expected --case with one of kepler_e06, kepler_e09";
  expect("run " + of_two, 2, one);
  expect("why " + of_two, 2, one);
  expect("sweep " + of_two + " --over eccentricity=0.1..0.2:2", 2, one);
  expect("run " + of_two + " --case kepler_e6", 2, "did you mean kepler_e06?");
  expect("run " + of_two + " --case kepler_e09", 0, "cases/reference/kepler_e09.csv");
  expect("why " + of_two + " --case kepler_e09 --seconds 2 --until 1", 0,
         "kepler.yaml --case kepler_e09 --solver odeum/");
  expect("run kepler_e06 --case kepler_e06 --solver rk4 --step 0.01", 2, "expected no --case");
}

// Keys that are spelt wrongly were taken for a scene's.
TEST_F(ProblemCommands, AMisspeltKeyIsOneOfAProblem) {
  write("near.yaml", "state: {x: 1}\nequation: {x: -x}\ntime: {end: 1}\n");
  expect("run near.yaml --solver rk4 --step 0.1", 2, "did you mean states?");
  write("bodies.yaml", "particles: [{id: 0, position: [0, 0, 0]}]\nsystem: SI\n");
  expect("run bodies.yaml --solver rk4 --step 0.1", 2, "expected one of name, up, gravity");
}

// The truth was computed when the problem was loaded, asked for or not.
TEST_F(ProblemCommands, WithoutATruthNoneIsComputed) {
  write_own("kepler.yaml");
  const std::string run = "run kepler.yaml --solver rk4 --step 0.01";
  const tests::Result without = odeum(run + " --no-truth");
  EXPECT_EQ(without.code, 0) << without.output;
  EXPECT_EQ(without.output.find("known to "), std::string::npos) << without.output;
  EXPECT_EQ(without.output.find("the truth is computed now"), std::string::npos) << without.output;
  EXPECT_NE(without.output.find("error   unknown"), std::string::npos) << without.output;
  const tests::Result with = odeum(run);
  EXPECT_NE(with.output.find("the truth is computed now"), std::string::npos) << with.output;
  expect("run kepler.yaml --solver rk4 --step 1e9 --no-truth", 2, "expected at most the horizon 3");
}

TEST_F(ProblemCommands, WithoutACompilerItIsInterpretedAndSaysSo) {
  write_own("van_der_pol.yaml");
  const std::string run = "run van_der_pol.yaml --solver rk4 --step 0.01";
  const auto error = [&](const std::string& variables) {
    const std::string output = odeum(run, variables).output;
    const std::size_t at = output.find("\nerror ");
    return at == std::string::npos ? -1 : std::stod(output.substr(at + 7));
  };
  expect(run, 0, "interpreted", "CC=/nonexistent");
  expect(run, 0, "interpreted", "CC=/bin/false");
  // The error of the method, 1e-8, is far above the rounding in which they differ.
  EXPECT_NEAR(error("CC=/nonexistent"), error(""), 1e-12);
  EXPECT_GT(error(""), 1e-10);
}

TEST_F(ProblemCommands, ConvergeGivesOrdersWithVerdicts) {
  expect("converge " + cases + "brusselator.yaml --solver odeum/rk4 --mode fixed --out out", 0,
         "confirmed");
  const std::string orders = tests::text_of(folder_.path() / "out/orders.csv");
  EXPECT_NE(orders.find(",brusselator2_text,odeum,rk4,"), std::string::npos) << orders;
  // The name of a compiled case is left to it.
  expect("converge --case " + cases + "hires.yaml --solver odeum/sdirk2 --mode adaptive --out out",
         0, "hires_text");
}

TEST_F(ProblemCommands, OtherStudiesTakeProblemsToo) {
  const std::string solver = " --solver odeum/rk4 --out out";
  expect("drift " + cases + "kepler.yaml" + solver, 0, "angular_momentum");
  expect("limits " + problems + "heat.yaml" + solver, 0, "heat");
  expect("precision " + cases + "lotka_volterra.yaml" + solver, 0, "lotka_volterra");
  expect("report --quick " + cases + "lotka_volterra.yaml --solver odeum/rk4 --out page", 0,
         "index.html");
  const std::string orders = tests::text_of(folder_.path() / "page/orders.csv");
  EXPECT_NE(orders.find(",odeum,rk4,"), std::string::npos) << orders;
  EXPECT_EQ(orders.find(",cvode,"), std::string::npos) << "--solver selects";
}

// The studies measure no times; the page takes what the commands before it have measured.
TEST_F(ProblemCommands, AReportTakesTheResultsOfEarlierCommands) {
  const std::string with = " " + cases + "lotka_volterra.yaml --solver odeum/heun --out page";
  expect("converge" + with, 0, "heun");
  expect("stability" + with, 0, "heun");
  expect("report" + with, 0, "index.html");
  const std::string manifest = tests::text_of(folder_.path() / "page/manifest.json");
  EXPECT_EQ(manifest.find("\"results_of_earlier_runs\": 0"), std::string::npos) << manifest;
  EXPECT_NE(manifest.find("\"results_of_earlier_runs\": "), std::string::npos) << manifest;
}

TEST_F(ProblemCommands, MistakesHaveTheirPlaceAndTheExitCode2) {
  write("bad.yaml", "states: {x: 1}\nequations:\n  x: y\ntime: {end: 1}\n");
  expect("run bad.yaml", 2, "bad.yaml:3:6: equations: x: unknown name; got y");
  expect("converge bad.yaml --out out", 2, "bad.yaml:3:6: ");
  write("broken.yaml", "states: {x: 1\nequations:\n  x: y\n");
  expect("run broken.yaml", 2, "problem: not YAML");
  expect("converge nowhere.yaml", 2, "nowhere.yaml:1:1: problem: cannot be read");
  expect("run " + cases + "kepler.yaml --case kepler_e06 --set e=2", 2, "none to set of that name");
  expect("run " + cases + "kepler.yaml --set eccentricity", 2, "NAME=VALUE");
  write_own("kepler.yaml");
  expect("run kepler.yaml --set eccentricity=1", 2, "division by zero");
  expect("run " + cases + "lorenz.yaml --set zz=1", 2, "expected one of ");
  write("plain.yaml", "states: {x: 1}\nequations: {x: -x}\ntime: {end: 1}\n");
  expect("run plain.yaml --set x=3", 2, "the file has no parameters");
  expect("run lotka_volterra --solver rk4 --step 0.1 --set zz=1", 2, "no parameter zz");
  expect("converge --case lotka_volterra --solver odeum/rk4 --set a=1", 2, "--set");
}

TEST_F(ProblemCommands, NothingWrittenReachesAShellOrACompiler) {
  const std::string mark = (folder_.path() / "mark").string();
  const std::string evil[] = {"$(touch " + mark + ")", "`touch " + mark + "`",
                              "x; system(\\\"touch " + mark + "\\\")", "\\\"/*",
                              "x */ #include <a>"};
  for (const std::string& text : evil) {
    write("evil.yaml", "states: {x: 1}\nequations:\n  x: \"" + text + "\"\ntime: {end: 1}\n");
    expect("run evil.yaml", 2, "evil.yaml:3:");
    write("evil.yaml", "states: {\"" + text + "\": 1}\nequations: {x: 1}\ntime: {end: 1}\n");
    expect("run evil.yaml", 2, "evil.yaml:1:");
  }
  write("name.yaml", "name: \"$(touch " + mark +
                         ") \\e[31m */ <script>\"\nstates: {x: 1}\n"
                         "equations: {x: -x}\ntime: {end: 1}\n");
  expect("run name.yaml --solver rk4 --step 0.1", 0, "status  ok");
  EXPECT_FALSE(fs::exists(mark));
}

// Commands on a page name what the reader gave, and not an id that is known to that run only.
TEST_F(ProblemCommands, APageNamesTheFileOfAUser) {
  write("my decay.yaml",
        "states: {x: 1e-6}\nparameters: {k: 1}\nequations: {x: -k*x}\ntime: {end: 1}\n");
  const tests::Result result =
      odeum("converge 'my decay.yaml' --set k=2 --solver odeum/rk4 --out rows");
  EXPECT_EQ(result.code, 0) << result.output;
  const std::string page = tests::text_of((folder_.path() / "rows/page.json").string());
  EXPECT_NE(page.find(R"("words":"'my decay.yaml' --set k=2")"), std::string::npos);
  // Its state is far below 1, so that errors have the unit 1e-6.
  EXPECT_NE(page.find(R"("scaled":true)"), std::string::npos);
}

TEST_F(ProblemCommands, WhatGoesWrongDuringARunIsAStatus) {
  write("blow_up.yaml", "states: {x: 1}\nequations: {x: x^2}\ntime: {end: 2, stops: [0.5, 2]}\n");
  expect("run blow_up.yaml", 0, "no verdict is given beyond");
  // No method reaches the stop at 2: each says when and where.
  for (const char* solver : {"dormand_prince54", "gsl/rkf45", "cvode/bdf", "odeint/rosenbrock4"}) {
    const std::string output =
        odeum("run blow_up.yaml --until 2 --tol 1e-6 --solver " + std::string(solver)).output;
    EXPECT_EQ(output.find("status  ok"), std::string::npos) << output;
    EXPECT_NE(output.find("at t = "), std::string::npos) << output;
  }
  expect("run blow_up.yaml --solver dormand_prince54 --tol 1e-6 --until 2", 3, "status  ");
  expect("run blow_up.yaml --solver rk4 --step 0.1 --until 2", 3, "component 0");
  // Past the pole at t = 1 a fixed step goes on, to a state that is not a solution.
  const char* const past = " --step 0.05 --until 1.05";
  for (const char* solver : {"rk4", "heun", "rodas4", "implicit_euler_linearised"})
    expect("run blow_up.yaml --solver " + std::string(solver) + past, 3, "answer  wrong: ");
  write("root.yaml", "states: {y: 1, s: 0}\nequations: {y: -sqrt(1 - s), s: 1}\ntime: {end: 2}\n");
  expect("run root.yaml --solver rk4 --step 0.1 --until 2", 3, "component 0");
}

}  // namespace
}  // namespace odeum::command_test
