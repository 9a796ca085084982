// SPDX-License-Identifier: BSD-3-Clause
// Questions about published equations, each with the end that SciPy computed by two methods at
// relative tolerances of 1e-12 and 1e-11, which agree to 1e-9: what the printed command ends at.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "advise/answers.hpp"

namespace odeum::questions_test {
namespace {

using tests::Result, tests::shell;

struct Question {
  const char *name, *text, *words;
  double error;
  std::vector<double> end;
};

// With scales of the states, so that the error asked for is in known units.
const Question questions[] = {
    {"predator and prey",
     "states: {x: 10, y: 10}\nequations: {x: 1.1*x - 0.4*x*y, y: 0.1*x*y - 0.4*y}\n"
     "time: {end: 40}\nscale: {x: 1, y: 1}\n",
     "--error 1e-3",
     1e-3,
     {4.170179102, 0.2319151715}},
    {"FitzHugh and Nagumo's neuron",
     "states: {v: -1, w: 1}\nequations: {v: v - v^3/3 - w + 0.5, w: (v + 0.7 - 0.8*w)/12.5}\n"
     "time: {end: 100}\nscale: {v: 1, w: 1}\n",
     "--error 1e-4",
     1e-4,
     {-0.4996639386, -0.2110703761}},
    {"an oscillator on a belt",
     "states: {x: 0, v: 0}\nequations: {x: v, v: -x - 0.1*v - 0.5*tanh((v - 0.3)/0.01)}\n"
     "time: {end: 30}\nscale: {x: 1, v: 1}\n",
     "--error 1e-4",
     1e-4,
     {0.5224950215, -0.06591408759}},
    {"a projectile at the frames of a game",
     "states: {x: 0, y: 0, u: 30, w: 40}\ndefinitions: {s: 0.02*sqrt(u^2 + w^2)}\n"
     "equations: {x: u, y: w, u: -s*u, w: -9.81 - s*w}\ntime: {end: 4}\n"
     "scale: {x: 1, y: 1, u: 1, w: 1}\n",
     "--error 1e-3 --frame 1/60",
     1e-3,
     {53.05745069, 16.49849402, 7.009493552, -14.33201415}},
};

class Questions : public testing::TestWithParam<Question> {};

TEST_P(Questions, AreAnsweredByACommandThatKeepsTheError) {
  const Question& question = GetParam();
  const advise_tests::File file(question.text);
  // Some of each kind, so that the race is short.
  const Result result =
      shell("odeum advise " + file.word() + question.words +
            " --format json --solver rk4 'dorm*' 'cash*' 'rodas*' 'adams_bashforth*' 'gsl/rk*'");
  ASSERT_EQ(result.code, 0) << result.output;
  const std::string command = nlohmann::json::parse(result.output)["command"];
  const Result run = shell(command);
  const std::size_t at = run.output.find("\nstate ");
  ASSERT_NE(at, std::string::npos) << command << "\n" << run.output;
  std::istringstream numbers(run.output.substr(at + 7));
  for (const double exact : question.end) {
    double value = 0;
    numbers >> value;
    // The ends have ten digits.
    EXPECT_NEAR(value, exact, question.error + 1e-8) << command;
  }
}

INSTANTIATE_TEST_SUITE_P(Published, Questions, testing::ValuesIn(questions),
                         [](const auto& info) { return std::to_string(info.index); });

}  // namespace
}  // namespace odeum::questions_test
