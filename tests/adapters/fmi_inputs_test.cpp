// SPDX-License-Identifier: BSD-3-Clause
// Inputs of FMUs over time, from files.
#include <cmath>

#include "fmi_hybrid_stage.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::fmi_tests::fmi_inputs_test {
namespace {

using Inputs = HybridFmus;

std::string fact(const Case& c, const std::string& name) {
  for (const auto& [key, text] : c.facts)
    if (key == name) return text;
  return {};
}

TEST_P(Inputs, ContinuousOnesArePiecewiseLinear) {
  const Case c = hybrid(follow(), {}, csv("time,u\n0,0\n1,1\n2,1\n"));
  EXPECT_FALSE(c.problem.events) << "kinks are ends of pieces";
  EXPECT_TRUE(fact(c, "inputs").starts_with("u piecewise linear from ")) << fact(c, "inputs");
  // u = t, then 1, which the last row holds.
  const double x1 = std::exp(-1.0), x3 = 1 + (x1 - 1) * std::exp(-2.0);
  for (const char* id : {"odeum/dormand_prince54", "odeum/rodas4", "odeum/radau_iia5"}) {
    const Outcome outcome = run(c, id, {0.5, 1, 3}, 1e-10);
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    // A tolerance of 1e-10 a step, over up to a hundred steps.
    EXPECT_NEAR(outcome.states[0], 0.5 - 1 + std::exp(-0.5), 1e-8) << id;
    EXPECT_NEAR(outcome.states[1], x1, 1e-8) << id;
    EXPECT_NEAR(outcome.states[2], x3, 1e-8) << id;
  }
}

TEST_P(Inputs, TwoRowsOfOneTimeAreAJump) {
  const Case c = hybrid(follow(), {}, csv("time, u\r\n0, 0\r\n1, 0\r\n1, 2\r\n3, 2\r\n"));
  ASSERT_TRUE(c.problem.events);
  const Outcome outcome = run(c, "odeum/dormand_prince54", {1, 2}, 1e-9);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
  ASSERT_EQ(outcome.events.size(), 1U);
  EXPECT_EQ(outcome.events[0].t, 1);
  EXPECT_EQ(outcome.states[0], 0);
  EXPECT_NEAR(outcome.states[1], 2 - 2 * std::exp(-1.0), 1e-7);
}

TEST_P(Inputs, ThoseThatAreNotInAFileAreHeldAndSaid) {
  const Case c = hybrid(follow(), {{"u", "3"}});
  EXPECT_EQ(fact(c, "inputs"), "held: u = 3");
  const Outcome outcome = run(c, "odeum/dormand_prince54", {1}, 1e-9);
  EXPECT_NEAR(outcome.states[0], 3 - 3 * std::exp(-1.0), 1e-7);
}

TEST_P(Inputs, AModelFeedsThemThrough) {
  Model model{"{feed}", 2, {}};
  const auto pair = [&](const std::string& type, const std::string& variability) {
    const auto k = static_cast<unsigned>(model.variables.size() / 2) + 1;
    const std::string name = type + "_" + variability;
    model.variables.push_back({name, k, type, "input", variability, "0"});
    model.variables.push_back({name + "_output", 16 + k, type, "output", variability});
  };
  pair("Real", "continuous");
  pair("Real", "discrete");
  pair("Integer", "discrete");
  pair("Boolean", "discrete");
  const Case c = hybrid(model, {},
                        csv("time,Real_continuous,Real_discrete,Integer_discrete,Boolean_discrete\n"
                            "0,0,1.5,-3,false\n1,2,2.5,4,true\n1,3,2.5,4,1\n2,4,2.5,5,0\n"));
  EXPECT_EQ(c.components.front(), "Real_continuous_output");
  EXPECT_EQ(c.y0, (std::vector<double>{0, 1.5, -3, 0}));
  for (const char* id : {"odeum/rk4", "odeum/dormand_prince54"}) {
    const bool fixed = std::string(id) == "odeum/rk4";
    const Outcome outcome = run(c, id, {0.5, 1, 1.5, 2}, 1e-6, fixed ? 8 : 0);
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    EXPECT_EQ(outcome.states, (std::vector<double>{1, 1.5, -3, 0, 3, 2.5, 4, 1,  //
                                                   3.5, 2.5, 4, 1, 4, 2.5, 5, 0}))
        << id;
  }
}

// Whole numbers of every width to their limits, in the inputs that come with the model of others.
TEST_P(Inputs, WholeNumbersOfEveryWidthComeThrough) {
  if (!three()) GTEST_SKIP() << "FMI 2 has one width";
  Model model{"{feed}", 2, {}};
  const char* const types[] = {"Int8",  "UInt8",  "Int16", "UInt16",
                               "Int32", "UInt32", "Int64", "UInt64"};
  unsigned k = 0;
  for (const std::string type : types) {
    ++k;
    model.variables.push_back({type + "_input", k, type, "input", "discrete", "0"});
    model.variables.push_back({type + "_output", 16 + k, type, "output", "discrete"});
  }
  const Case c =
      hybrid(model, {}, ODEUM_SOURCE_DIR "/tests/adapters/reference_fmus/Feedthrough_in.csv");
  const Outcome outcome = run(c, "odeum/rk4", {0.5, 2}, 0, 4);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
  EXPECT_EQ(outcome.states,
            (std::vector<double>{-128, 0, -32768, 0, -2147483648.0, 0, -9223372036854775808.0, 0,
                                 127, 255, 32767, 65535, 2147483647, 4294967295,
                                 // In double to the nearest.
                                 9223372036854775808.0, 18446744073709551616.0}));
  const Values too_large{{"Int8_input", "128"}};
  expect_refused(written(model), "--set Int8_input: got \"128\", expected -128 to 127", too_large);
}

TEST_P(Inputs, WrongFilesAreRefusedWithTheirPlace) {
  const std::string fmu = written(follow());
  const auto said = [&](const std::string& text, const Values& values = {}) -> std::string {
    try {
      open_fmu(fmu, values, csv(text));
    } catch (const InputError& error) {
      return error.what();
    } catch (const LoadError& error) {
      return error.what();
    }
    return "it was not refused";
  };
  const std::pair<const char*, const char*> wrong[] = {
      {"time,v\n0,1\n", "inputs.csv:1:6: inputs: the model has no such input; got v, expected u"},
      {"time,x\n0,1\n", "1:6: inputs: the model has no such input"},
      {"u,time\n0,1\n", "1:1: inputs: the first column; got u, expected time"},
      {"time,u,u\n0,1,1\n", "1:8: inputs: two columns are u"},
      {"time,u\n0,1\n2,1\n1,1\n", "4:1: time: got \"1\", expected a time from 2 on"},
      {"time,u\n0,1\n0,2\n0,3\n", "4:1: time: got \"0\", expected two rows of one time at most"},
      {"time,u\n0,1\n1,nan\n", "3:3: u: got \"nan\", expected a finite number"},
      {"time,u\n0,1\ninf,2\n", "3:1: time: got \"inf\", expected a finite number"},
      {"time,u\n0,one\n", "2:3: u: got \"one\", expected a number"},
      {"time,u\n0\n", "2:1: inputs: got 1 fields, expected 2"},
      {"time,u\n", "inputs: got no row"},
  };
  for (const auto& [text, why] : wrong)
    EXPECT_NE(said(text).find(why), std::string::npos) << said(text) << "\nexpected: " << why;
  EXPECT_NE(said("time,u\n0,1\n", {{"u", "1"}}).find("--set u: --inputs"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Versions, Inputs, testing::Values(2, 3));

}  // namespace
}  // namespace odeum::fmi_tests::fmi_inputs_test
