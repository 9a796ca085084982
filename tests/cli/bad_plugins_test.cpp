// SPDX-License-Identifier: BSD-3-Clause
// Plug-ins that do more than they are asked for, when they are loaded, called or ended: it costs
// nothing but their own rows.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::bad_plugins_test {
namespace {

using tests::Result;
using tests::shell;

/// Euler's method and x' = -x, with more code: FIELDS of the problem, STEP and RHS in the functions
/// of these names, and whatever stands outside of them.
constexpr const char* plugin = R"c(
#include <fenv.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
static const odeum_system* the_system;
static void* create(const odeum_system* system, double t0, const double* y0) {
  the_system = system;
  return malloc(64);
}
static int step(void* self, double t, double h, double* y) {
  double k[64];
  if (the_system->rhs(the_system->data, t, y, k)) return 1;
  for (size_t i = 0; i < the_system->dimension; ++i) y[i] += h * k[i];
  STEP
  return 0;
}
static int rhs(void* data, double t, const double* y, double* dydt) {
  dydt[0] = -y[0] / 3;
  RHS
  return 0;
}
static const double start[] = {1}, stops[] = {1, 2};
static const odeum_solver solver = {.name = "euler", .order = 1, .create = create, .step = step};
static const odeum_problem problem = {.name = "decay", .dimension = 1, .y0 = start,
    .stops = stops, .stop_count = 2, .rhs = rhs FIELDS};
static const odeum_plugin plugin = {ODEUM_PLUGIN_VERSION, "bad", 1, &solver, 1, &problem};
const odeum_plugin* odeum_plugin_entry(void) { return &plugin; }
)c";

struct Code {
  std::string outside = "", fields = "", step = "", rhs = "", flags = "-O1";
};

class BadPlugins : public testing::Test {
 protected:
  /// Compiles it; the words that load it.
  std::string built(const Code& code, const std::string& name = "bad") const {
    const auto base = folder_.path() / name;
    std::ofstream(base.string() + ".c") << "#define FIELDS " << code.fields << "\n#define STEP "
                                        << code.step << "\n#define RHS " << code.rhs << "\n"
                                        << plugin << code.outside << "\n";
    const Result compiled = shell("cc -shared -fPIC -w " + code.flags + " -include '" +
                                  ODEUM_SOURCE_DIR "/src/odeum/api/plugin.h' -o '" + base.string() +
                                  ".so' '" + base.string() + ".c' -lm");
    EXPECT_EQ(compiled.code, 0) << compiled.output;
    return " --plugin '" + base.string() + ".so' ";
  }
  Result odeum(const std::string& words) const {
    return shell("cd '" + folder_.path().string() + "' && timeout -k 1 100 '" ODEUM_BINARY "' " +
                 words);
  }
  std::string output(const std::string& words) const {
    const Result result = odeum(words + " 2>/dev/null");
    EXPECT_EQ(result.code, 0) << words << "\n" << result.output;
    return result.output;
  }
  tests::TemporaryFolder folder_;
};

// What -Ofast links sets the flush to zero when it is loaded.
TEST_F(BadPlugins, TheArithmeticOfAllOtherSolversStaysAsItIs) {
  const std::string sets =
      "__attribute__((constructor)) static void on_load(void) { fesetround(FE_DOWNWARD); }";
  const std::string bad =
      built({.outside = sets, .rhs = "fesetround(FE_UPWARD);", .flags = "-Ofast"});
  const std::string good = built({.flags = "-Ofast"}, "good");
  const std::string ours = "run lotka_volterra --solver rk4 --step 0.01 --no-truth --format json";
  const std::string alone = output(ours);
  EXPECT_EQ(output(ours + bad), alone);
  const std::string theirs =
      "run bad_decay --solver odeum/rk4 --step 0.01 --no-truth --format json";
  EXPECT_EQ(output(theirs + bad), output(theirs + good));
}

TEST_F(BadPlugins, NothingThatTheyRegisterRunsInTheLaboratory) {
  const Code ends{.outside =
                      "__attribute__((destructor)) static void on_end(void) { abort(); }\n"
                      "static void hang(void) { for (;;) pause(); }\n"
                      "__attribute__((constructor)) static void on_load(void) {\n"
                      "  if (!getenv(\"NO_HANG\")) atexit(hang);\n}"};
  const std::string bad = built(ends);
  EXPECT_EQ(odeum("list solvers" + bad).code, 0);
  EXPECT_EQ(odeum("run lotka_volterra --solver rk4 --step 0.1 --no-truth" + bad).code, 0);
  EXPECT_EQ(odeum("run lotka_volterra --solver bad/euler --step 0.1 --no-truth" + bad).code, 0);
}

// exit() in foreign code runs its handlers, and none of the laboratory's.
TEST_F(BadPlugins, WhatTheyPrintAndHowTheyEndIsNotInTheData) {
  const Code banner{
      .outside = "__attribute__((constructor)) static void on_load(void) { puts(\"BANNER\"); }",
      .step = "puts(\"BANNER\");"};
  const std::string bad = built(banner);
  for (const std::string words :
       {"list solvers --format json", "run lotka_volterra --solver rk4 --step 0.1 --format json",
        "run bad_decay --solver bad/euler --step 0.1 --format json"}) {
    const std::string text = output(words + bad);
    EXPECT_TRUE(nlohmann::json::accept(text)) << words << "\n" << text;
    EXPECT_EQ(text.find("BANNER"), std::string::npos);
  }
  const Result left =
      odeum("run bad_decay --solver bad/euler --step 0.1" + built({.step = "exit(0);"}, "exits"));
  EXPECT_EQ(left.code, 3) << left.output;
  EXPECT_NE(left.output.find("ended its process with exit code 0"), std::string::npos);
}

TEST_F(BadPlugins, ATextThatIsNotThereIsRefused) {
  const Result result = odeum("list cases" + built({.fields = ", .title = (const char*)1"}));
  EXPECT_EQ(result.code, 2) << result.output;
  EXPECT_NE(result.output.find("crashed"), std::string::npos) << result.output;
}

TEST_F(BadPlugins, NoProcessThatTheyStartedIsLeft) {
  const auto pids = folder_.path() / "pids";
  const std::string leaves =
      "static void leave(void) {\n"
      "  if (fork() == 0) {\n"
      "    setsid();\n"
      "    if (fork() == 0) {\n"
      "      setsid();\n"
      "      FILE* file = fopen(\"" +
      pids.string() +
      "\", \"a\");\n"
      "      fprintf(file, \"%d\\n\", getpid()); fclose(file);\n"
      "      sleep(60);\n    }\n    _exit(0);\n  }\n  usleep(100000);\n}\n";
  Code code{.outside = leaves, .step = "{ void leave(void); if (t < 1e-9) leave(); }"};
  code.outside = "void leave(void);\n" + code.outside;
  code.outside.replace(code.outside.find("static void leave"), 17, "void leave");
  const Result result = odeum("run bad_decay --solver bad/euler --step 0.1" + built(code));
  EXPECT_EQ(result.code, 0) << result.output;
  std::ifstream in(pids);
  int count = 0;
  for (pid_t process = 0; in >> process; ++count) {
    EXPECT_EQ(::kill(process, 0), -1) << "process " << process << " goes on";
    EXPECT_EQ(errno, ESRCH);
  }
  EXPECT_GE(count, 1) << "the test's plug-in starts processes";
}

TEST_F(BadPlugins, TheirMemoryHasALimit) {
  const std::string eats =
      built({.outside = "__attribute__((constructor)) static void on_load(void) {\n"
                        "  for (int k = 0; k < 100; ++k) if (!malloc(10000000)) abort();\n}"});
  EXPECT_EQ(odeum("list solvers" + eats).code, 0) << "1 GB is less than 4";
  const Result result = shell("ODEUM_FOREIGN_GIGABYTES=0.3 odeum list solvers" + eats);
  EXPECT_EQ(result.code, 2) << result.output;
  EXPECT_NE(result.output.find("crashed: Aborted"), std::string::npos) << result.output;
}

// Each process loads the file anew.
TEST_F(BadPlugins, AFileThatIsReplacedDuringARunIsNotTaken) {
  const std::string replaces = "if (t < 1e-9) { FILE* f = fopen(\"" +
                               (folder_.path() / "bad.so").string() +
                               "\", \"a\"); fputc(0, f); fclose(f); }";
  const Result result = odeum("run bad_decay --solver bad/euler --solver odeum/rk4 --step 0.1" +
                              built({.step = replaces}));
  EXPECT_NE(result.output.find("file has changed during the run"), std::string::npos)
      << result.output;
}

}  // namespace
}  // namespace odeum::bad_plugins_test
