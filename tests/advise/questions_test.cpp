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
  std::vector<double> units = {};  ///< by state; empty: 1
};

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
    // States whose units Odeum proposes. Scales by start and stops alone made errors of v 16.8 of
    // its size, trace species to rounding, and hid bacteria that come back.
    {"whole periods",
     "states: {x: 1, v: 0}\nequations: {x: v, v: -4*pi^2*x}\ntime: {end: 4}\n",
     "--error 1e-6",
     1e-6,
     {1, 0}},
    {"trace species beside bulk",
     "parameters: {k1: 1e-3, k2: 5}\nstates: {A: 55000, X: 0, Y: 0}\n"
     "equations: {A: -k1*1e-14*A, X: k1*1e-14*A - k2*X*(1 + sin(3*t)), Y: k2*X*(1 + sin(3*t))}\n"
     "time: {end: 20}\n",
     "--error 1e-3",
     1e-3,
     {55000, 9.9576006e-14, 1.0900423994e-11},
     {6e4, 4e-13, 1e-11}},
    {"an electron over a micrometre",
     "parameters: {q: 1.602176634e-19, m: 9.1093837e-31, E0: 1e9}\nstates: {x: 0, v: 0}\n"
     "equations: {x: v, v: q*E0/m}\ntime: {end: 1.61e-13}\n",
     "--error 1e-3",
     1e-3,
     {2.279518675e-6, 28317002.18},
     {2e-6, 3e7}},
    {"bacteria under a drug",
     "parameters: {ke: 0.2, kg: 1.4, kd: 0.2, emax: 3, ec50: 10}\n"
     "states: {B1: 100000, C: 100}\ndefinitions: {eff: emax*C/(ec50 + C)}\n"
     "equations: {B1: B1*kg - (kd + eff)*B1, C: -ke*C}\ntime: {end: 24}\n",
     "--error 1e-4",
     1e-4,
     {252.3425299, 0.8229747049},
     {252.34253, 100}},
    {"an enzyme in moles a litre",
     "parameters: {k1: 1e8, km: 200, kc: 50}\nstates: {E: 2e-8, S: 5e-6, X: 0, P: 0}\n"
     "equations: {E: -k1*E*S + (km + kc)*X, S: -k1*E*S + km*X, X: k1*E*S - (km + kc)*X, P: kc*X}\n"
     "time: {end: 10}\n",
     "--error 1e-4",
     1e-4,
     {1.641688778e-08, 5.450587745e-07, 3.583112221e-09, 4.451358113e-06},
     {2e-8, 5e-6, 1e-8, 4e-6}},
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
  for (std::size_t i = 0; i < question.end.size(); ++i) {
    double value = 0;
    numbers >> value;
    // The ends have eight digits at least.
    const double unit = question.units.empty() ? 1 : question.units[i];
    EXPECT_NEAR(value / unit, question.end[i] / unit, question.error + 1e-8) << command;
  }
}

INSTANTIATE_TEST_SUITE_P(Published, Questions, testing::ValuesIn(questions),
                         [](const auto& info) { return std::to_string(info.index); });

}  // namespace
}  // namespace odeum::questions_test
