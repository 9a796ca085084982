// SPDX-License-Identifier: BSD-3-Clause
// odeum run: several solvers, output, parameters.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "support/page_data.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::run_test {
namespace {

class RunCommand : public testing::Test {
 protected:
  Result run(const std::string& arguments) { return shell("odeum run " + arguments); }
  std::string out() const { return " --out " + folder_.path().string(); }
  std::string file(const std::string& name) const { return text_of(folder_.path() / name); }
  nlohmann::json page(const std::string& in = "") const {
    return json_of(folder_.path() / in / "page.json")["runs"];
  }
  std::vector<nlohmann::json> column(const std::string& table, const std::string& name) const {
    return column_in(folder_.path(), table, name);
  }
  TemporaryFolder folder_;
};

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++found;
  return found;
}

// The field of that name in the last row of a CSV that begins with `start`.
double field(const std::string& csv, const std::string& name, const std::string& start) {
  std::istringstream lines(csv);
  std::string header, line, found;
  std::getline(lines, header);
  while (std::getline(lines, line))
    if (line.starts_with(start)) found = line;
  std::istringstream names(header), values(found);
  std::string key, value;
  while (std::getline(names, key, ',') && std::getline(values, value, ','))
    if (key == name) return std::stod(value);
  throw std::out_of_range(name + " of " + start);
}

TEST_F(RunCommand, ComparesSolversOnOnePage) {
  const Result result =
      run("damped_oscillator_undamped --solver explicit_euler --solver symplectic_euler --solver "
          "midpoint --step 0.01 --every 0.1" +
          out());
  ASSERT_EQ(result.code, 0) << result.output;
  const auto about = page();
  EXPECT_EQ(about["kind"], "case");
  EXPECT_EQ(about["components"], nlohmann::json::array({"y", "u"}));
  EXPECT_EQ(about["measured"], nlohmann::json::array({0, 1}));
  for (const char* drawn : {"second_order", "energy", "exact_everywhere"})
    EXPECT_EQ(about[drawn], true) << drawn;
  EXPECT_EQ(column("runs", "solver"),
            (std::vector<nlohmann::json>{"explicit_euler", "symplectic_euler", "midpoint"}));
  EXPECT_EQ(column("runs", "steps"), std::vector<nlohmann::json>(3, 1000));
  EXPECT_EQ(column("trajectory", "error").size(), 4 * 101U);
  const std::string csv = file("trajectory.csv");
  EXPECT_TRUE(csv.starts_with("schema,case,library,solver,time,y,u,energy,error\n"));
  EXPECT_EQ(count(csv, "\n1,damped_oscillator_undamped,odeum,midpoint,"), 101U);
  EXPECT_EQ(count(csv, "\n1,damped_oscillator_undamped,truth,exact,"), 101U);
  // Explicit Euler multiplies the energy by 1 + h^2 k/m = 1.0005 a step, 1000 times.
  const double before = 62.5,
               after = field(csv, "energy", "1,damped_oscillator_undamped,odeum,explicit_euler");
  EXPECT_NEAR(after / before, std::pow(1.0005, 1000), 1e-9);
}

TEST_F(RunCommand, WritesOneFolderForEachSolverOfAScene) {
  const Result result =
      run("spring_explicit_euler --solver explicit_euler --solver midpoint --until 1" + out());
  ASSERT_EQ(result.code, 0) << result.output;
  for (const char* name : {"odeum_explicit_euler/replay.html", "odeum_midpoint/energy.csv",
                           "odeum_midpoint/trajectory.vtk.series"})
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / name)) << name;
  EXPECT_EQ(column("runs", "replay"),
            (std::vector<nlohmann::json>{"odeum_explicit_euler/replay.html",
                                         "odeum_midpoint/replay.html"}));
  for (const char* table : {"energies", "plotted"})
    EXPECT_GE(table_in(folder_.path(), table)["rows"], 4) << table;
  EXPECT_EQ(page()["kind"], "scene");
}

TEST_F(RunCommand, SaysWhatACourseFileLeavesOut) {
  write_text(folder_.path() / "scene01.yml",
             "solver: {type: symplectic_euler, timestep: 0.001}\n"
             "plot: {particle_id: 1, dof: 2, y_range: [0.7, 1.2]}\n"
             "particles:\n- {pos: [0, 0, 2], fixed: true, mass: 0.1}\n"
             "- {pos: [0, 0, 1], mass: 0.2, color: red}\n"
             "springs:\n- {particle_ids: [0, 1], stiffness: 20.}\n");
  const Result result = run((folder_.path() / "scene01.yml").string() + " --out " +
                            (folder_.path() / "out").string());
  ASSERT_EQ(result.code, 0) << result.output;
  for (const char* sentence :
       {"scene      scene01\n", "duration   10 s: the scene gives none; --until sets another\n",
        "scene01.yml:5:31: particles[1].color: only a viewer needs it", "10000 steps to t = 10\n"})
    EXPECT_NE(result.output.find(sentence), std::string::npos) << sentence << result.output;
  const auto plot = page("out")["plot"];
  EXPECT_EQ(plot["particle"], 1);
  EXPECT_EQ(plot["coordinate"], "z");
  EXPECT_EQ(plot["range"], nlohmann::json::array({0.7, 1.2}));
  EXPECT_EQ(column_in(folder_.path() / "out", "plotted", "position").at(0), 1);
  EXPECT_NE(file("out/replay.html")
                .find("\"plot\":{\"particle\":1,\"coordinate\":2,\"range\":[0.7,1.2]}"),
            std::string::npos);
}

// The weight at rest on its spring hangs lower by m g / k: the truth has to follow.
TEST_F(RunCommand, ChangesACaseAndItsTruth) {
  const Result result =
      run("damped_oscillator_undamped --set k=20 --set d=0.1 --set y0=-3 --set m=2 --solver rk4 "
          "--step 0.001 --until 3");
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_NE(result.output.find("2 y'' + 0.1 y' + 20 (y - 0) = 0, y(0) = -3"), std::string::npos)
      << result.output;
  const std::size_t at = result.output.find("error   ");
  ASSERT_NE(at, std::string::npos) << result.output;
  EXPECT_LT(std::stod(result.output.substr(at + 8)), 1e-10);
  EXPECT_NE(shell("odeum list cases --parameters").output.find("stiffness, N/m"),
            std::string::npos);
}

// The number behind a word of the output, NaN where there is none.
double number_after(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + word.size()));
}

TEST_F(RunCommand, ComputesATruthForOtherParametersAndTimes) {
  const auto error_of = [&](const std::string& arguments) {
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 0) << result.output;
    return number_after(result.output, "error   ");
  };
  // Order 4: a step of half the length leaves a sixteenth, to a tenth.
  for (const char* changed :
       {"lotka_volterra --set a=1 --until 7", "lotka_volterra --until 13", "vdp_mu1 --set mu=0.5",
        "duffing_free --set beta=2", "pendulum_small --set theta0=2 --until 6"}) {
    const std::string arguments = std::string(changed) + " --solver rk4 --step ";
    EXPECT_NEAR(error_of(arguments + "0.02") / error_of(arguments + "0.01"), 16, 1.6) << changed;
  }
  EXPECT_LT(error_of("vdp_mu1000 --set mu=50 --until 60 --solver rodas4 --tol 1e-7"), 1e-4);
  // Chaos: two computations part before t = 60.
  const Result lost = run("lorenz_kehlet_logg --until 60 --solver rk4 --step 0.001");
  EXPECT_NE(lost.output.find("no truth at t = 60"), std::string::npos) << lost.output;
  EXPECT_NE(lost.output.find("chaos"), std::string::npos) << lost.output;
}

TEST_F(RunCommand, TellsThePageTheClosedFormOfAScheme) {
  ASSERT_EQ(run("dahlquist_real --solver explicit_euler --step 0.01 --every 0.1" + out()).code, 0);
  const auto time = column("schemes", "time"), y = column("schemes", "y");
  // y' = -y: (1 - h)^n.
  ASSERT_EQ(y.size(), 40U);
  for (std::size_t i = 0; i < y.size(); ++i)
    EXPECT_NEAR(y[i].get<double>(), std::pow(0.99, 100 * time[i].get<double>()), 1e-8);
}

// The page draws the path of a body in a plane: four components of an equation of second order.
TEST_F(RunCommand, TellsThePageOfABodyInAPlane) {
  ASSERT_EQ(run("kepler_e06 --solver rk4 --step 0.01" + out()).code, 0);
  EXPECT_EQ(page()["components"].size(), 4U);
  EXPECT_EQ(page()["second_order"], true);
  ASSERT_EQ(run("lotka_volterra --solver rk4 --step 0.01" + out()).code, 0);
  EXPECT_EQ(page()["second_order"], false);
  EXPECT_EQ(page()["energy"], false);
}

// y falls to 0.25 at t = 7.5 and stays there, where its truth ends. The runs ended at t = 5,
// without a word.
TEST_F(RunCommand, GoesWhereItWasSentWhateverIsKnownThere) {
  const std::string text = folder_.path() / "slide.yaml";
  write_text(text,
             "states: {y: 1}\nequations: {y: 'if(y > 0.25, -0.1, 0.1)'}\n"
             "time: {end: 20, stops: [2, 5, 10, 20]}\n");
  const auto expect = [&](const std::string& setting, const std::string& known) {
    const Result result = run(text + " --solver " + setting);
    EXPECT_EQ(result.code, 0) << result.output;
    EXPECT_NE(result.output.find("to t = 20\n"), std::string::npos) << result.output;
    // A step of rk4 passes the switch by less than its rate times h, 0.01.
    EXPECT_NEAR(number_after(result.output, "state "), 0.25, 0.01) << result.output;
    EXPECT_NE(result.output.find(known + "; no truth is known from there to t = 20"),
              std::string::npos)
        << result.output;
    EXPECT_LT(number_after(result.output, "error "), 0.01) << result.output;
  };
  expect("rk4 --step 0.1", "at t = 5");
  expect("dormand_prince54 --tol 1e-3", "at t = 5");
  expect("rk4 --step 0.1 --every 0.5", "at t = 7.5");
  // No step ends on a time at which the truth is known.
  const Result none = run(text + " --solver rk4 --step 0.7");
  EXPECT_NE(none.output.find("error   unknown: no truth at t = 20"), std::string::npos)
      << none.output;
}

// At all outputs, so that the exact solution is a line and each output has its error.
TEST_F(RunCommand, KnowsTheTruthAtEveryOutput) {
  ASSERT_EQ(run("lotka_volterra --solver rk4 --step 0.01 --every 0.1" + out()).code, 0);
  const std::string csv = file("trajectory.csv");
  EXPECT_EQ(count(csv, "\n1,lotka_volterra,truth,exact,"), 101U);
  EXPECT_EQ(count(csv, "nan\n"), 0U);
}

// share/odeum, which has the page's code, does not stand beside this copy of the program. A scene
// has its replay in a page of its own and is refused.
TEST_F(RunCommand, NamesNoPageWhereNoneIsWritten) {
  const auto alone = folder_.path() / "alone";
  std::filesystem::create_directories(alone / "bin");
  std::filesystem::copy_file(ODEUM_BINARY, alone / "bin/odeum");
  for (const std::string arguments :
       {"run kepler_e06 --solver rk4 --step 0.1", "poisson square:4",
        "classify 'u_xx + y*u_yy = 0'", "report raindrop --solver odeum/rk4 --quick"}) {
    const Result result =
        shell((alone / "bin/odeum ").string() + arguments + " --out " + (alone / "out").string());
    EXPECT_EQ(result.code, 0) << result.output;
    EXPECT_EQ(count(result.output, "index.html"), 0U) << result.output;
    EXPECT_EQ(count(result.output, "there is no page"), 1U) << result.output;
  }
  EXPECT_FALSE(std::filesystem::exists(alone / "out/index.html"));
}

// All options are checked before the first line of output.
TEST_F(RunCommand, PrintsNothingOfARunThatIsRefused) {
  for (const char* fault : {"--every -1", "--every 0", "--until -1", "--solver nothing"}) {
    const Result result = run(std::string("free_fall --set g=-1 --solver rk4 --step 0.1 ") + fault);
    EXPECT_EQ(result.code, 2) << result.output;
    EXPECT_EQ(result.output.find("case    "), std::string::npos) << result.output;
    EXPECT_EQ(result.output.find("set     "), std::string::npos) << result.output;
  }
}

// The truth of 1e300 seconds was computed first, for minutes.
TEST_F(RunCommand, RefusesTooManyStepsBeforeItComputesATruth) {
  write_text(folder_.path() / "long.yaml",
             "states: {x: 2, v: 0}\nequations: {x: v, v: (1-x^2)*v-x}\ntime: {end: 1e300}\n");
  const Result result = run((folder_.path() / "long.yaml").string() + " --solver rk4 --step 0.1");
  EXPECT_EQ(result.code, 2) << result.output;
  EXPECT_NE(result.output.find("more than 1e+09 steps to t = 1e+300"), std::string::npos)
      << result.output;
  EXPECT_EQ(count(result.output, "truth"), 0U) << result.output;
}

// 501 steps at 0.01 s of output and 43 at 0.5 s were those of a run that ended a step at each.
TEST_F(RunCommand, OutputDoesNotSteerTheStep) {
  const auto steps = [&](const std::string& every) {
    const std::string text =
        run("raindrop --solver cash_karp54 --tol 1e-8 --every " + every).output;
    const std::size_t at = text.find("tol        1e-08, ");
    return at == std::string::npos ? text : text.substr(at, text.find('\n', at) - at);
  };
  const std::string coarse = steps("0.5");
  EXPECT_EQ(steps("0.01"), coarse);
  EXPECT_NE(coarse.find("steps"), std::string::npos) << coarse;
}

struct Nonsense {
  const char* arguments;
  const char* sentence;
  friend std::ostream& operator<<(std::ostream& out, const Nonsense& x) {
    return out << x.arguments;
  }
};
class RunNonsense : public testing::TestWithParam<Nonsense> {};
TEST_P(RunNonsense, IsRefusedWithASentence) {
  const Result result = shell("odeum run " + std::string(GetParam().arguments));
  EXPECT_EQ(result.code, 2) << result.output;
  EXPECT_NE(result.output.find(GetParam().sentence), std::string::npos) << result.output;
}
INSTANTIATE_TEST_SUITE_P(
    RunCommand, RunNonsense,
    testing::Values(
        Nonsense{"free_fall --solver rk4 --step 0.1 --set g", "got g, expected NAME=NUMBER"},
        Nonsense{"free_fall --solver rk4 --step 0.1 --set =1", "--set: no assignment"},
        Nonsense{"free_fall --solver rk4 --step 0.1 --set g=nan", "--set: not finite"},
        Nonsense{"free_fall --solver rk4 --step 0.1 --set g=1x", "--set: not a number"},
        Nonsense{"free_fall --solver rk4 --step 0.1 --set g=1,5", "--set: not a number"},
        Nonsense{"free_fall --solver rk4 --step 0.1 --set g=1 --set g=2", "--set: given twice"},
        Nonsense{"free_fall --solver rk4 --step 0.1 --set vo=2", "did you mean v0?"},
        Nonsense{"damped_oscillator_critical --solver rk4 --step 0.1 --set k=0",
                 "k: got 0, expected a positive number"},
        Nonsense{"pleiades --solver rk4 --step 0.1 --set k=1", "pleiades has no parameters"},
        Nonsense{"raindrop --set k=1", "a scene has no parameters"},
        Nonsense{"raindrop --every 0", "--every: got 0"},
        Nonsense{"free_fall --solver rk4 --step 0.1 --every -1", "--every: got -1"},
        Nonsense{"free_fall --solver rk4 --tol 1e-3 --every 1e-12", "more than 2e+08 numbers"},
        Nonsense{"free_fall --solver rk4 --solver rk5 --step 0.1", "did you mean odeum/rk4?"},
        Nonsense{"raindrop --solver yoshida4 --solver leapfrog --step 0.1",
                 "does not fit this scene"}));

}  // namespace
}  // namespace odeum::tests::run_test
