// SPDX-License-Identifier: BSD-3-Clause
// Cases that are texts: what is printed of them, and the mistakes that stop a build.
#include <gtest/gtest.h>

#include "odeum/formula/text_ode.hpp"
#include "odeum/print/print_cases.hpp"
#include "support/catalogue.hpp"

namespace odeum {
namespace {

const std::string decay =
    "parameters: {k: 2}\nstates: {x: 3*k}\nequations: {x: -k*x}\ntime: {end: 1}\n";

void expect_fault(const std::string& cases, const std::string& place, const std::string& part,
                  const std::string& problem = decay) {
  try {
    print::print_cases("f.yaml", problem + cases);
    ADD_FAILURE() << "printed: " << cases;
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("f.yaml:" + place)) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(PrintedCases, MistakesHaveTheirPlace) {
  expect_fault("", "1:1: ", "cases: missing");
  expect_fault("cases: {a-b: {reference: r, floor: 1}}\n", "5:9: ", "not a name");
  expect_fault("cases: {d: {floor: 1}}\n", "5:9: ", "no truth");
  expect_fault("cases: {d: {reference: r}}\n", "5:9: ", "d: floor");
  expect_fault("cases: {d: {referense: r}}\n", "5:13: ", "did you mean reference?");
  expect_fault("case: {offer: jacobian}\ncases: {d: {reference: r, floor: 1}}\n",
               "5:8: ", "did you mean offers?");
  expect_fault("case: {offers: jacobi}\ncases: {d: {reference: r, floor: 1}}\n",
               "5:16: ", "got jacobi, expected jacobian");
  expect_fault("cases: {d: {reference: r, floor: 1, parameters: [z]}}\n",
               "1:1: ", "no parameter; got z");
  expect_fault("cases: {d: {reference: r, floor: t}}\n", "5:34: ", "not a constant");
  expect_fault("cases: {d: {reference: r, floor: 1}}\n", "1:1: ", "no mass matrix",
               "states: {x: 1, v: 0}\nequations: {x: v, v: -x}\nmass: {v: {v: 2}}\n"
               "time: {end: 1}\n");
  expect_fault("cases: {d: {reference: r, floor: 1}}\n", "2:", "not an index; got n",
               "parameters: {n: 3}\nstates: {\"u[1..n]\": 1}\nequations: {\"u[1..3]\": 1}\n"
               "time: {end: 1}\n");
}

TEST(PrintedCases, ParametersAreMembersAndWhatFollowsFromThemToo) {
  const print::Printed printed = print::print_cases(
      "decay.yaml", decay + "case: {meanings: {k: rate}}\ncases: {d: {reference: r, floor: 1}}\n");
  for (const char* line : {"struct Decay {", "double k = 0x1p+1;", "_ = -this->k;",
                           "void linear_matrix(double* a) const"})
    EXPECT_NE(printed.header.find(line), std::string::npos) << line << '\n' << printed.header;
  EXPECT_NE(printed.unit.find("problem{.k = values[0]};"), std::string::npos) << printed.unit;
}

// The constants that follow from parameters, and the initial values, are those of the values that a
// user gives.
TEST(PrintedCases, FollowTheirParameters) {
  const Case c = tests::find_case("rigid_body_hlw").with_values({3, 1.5, 0.8, 0.7});
  const formula::TextOde text(
      formula::read_problem_file(ODEUM_SOURCE_DIR "/cases/rigid_body.yaml",
                                 {{"I1", "3"}, {"I2", "1.5"}, {"I3", "0.8"}, {"angle", "0.7"}}));
  const double y[] = {0.3, 0.5, 0.7};
  double f[3], expected[3];
  c.problem.view.rhs(c.problem.view.problem, 0, y, f);
  text.view().rhs(&text, 0, y, expected);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(f[i], expected[i], 1e-15);
    EXPECT_NEAR(c.y0[i], static_cast<double>(text.problem().y0[i]), 1e-15);
  }
  EXPECT_THROW(tests::find_case("kepler_e06").with_values({1.5}), std::invalid_argument);
}

TEST(PrintedCases, AClosedFormHoldsForAllParameters) {
  const Case c = tests::find_case("prothero_robinson_1e3_smooth").with_values({2, 3});
  double y = 0;
  ASSERT_TRUE(c.truth.at(0.5, &y));
  EXPECT_NEAR(y, std::cos(0.5) + 2 * std::exp(-1.0), 1e-15);
  EXPECT_EQ(c.truth.source, "closed form");
  EXPECT_EQ(tests::find_case("prothero_robinson_1e3_smooth").truth.source,
            "cases/reference/prothero_robinson_1e3_smooth.csv");
}

}  // namespace
}  // namespace odeum
