// SPDX-License-Identifier: BSD-3-Clause
// Texts that say which of their terms are implicit.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/formula/case_section.hpp"
#include "odeum/formula/text_ode.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::implicit_part_test {
namespace {

using formula::Problem;
using formula::TextOde;

Problem read(const std::string& implicit) {
  return formula::read_problem("f.yaml",
                               "parameters: {A: 1, B: 3, k: 1}\n"
                               "definitions: {r: u^2*v, c: 2*B}\n"
                               "states: {u: 1.5, v: 3, w[1..3]: i}\n"
                               "equations: {u: A + r - (B + 1)*u, v: B*u - r + k*sin(t),"
                               " 'w[1..3]': '-c*(w[i] - u) + w[i]*r'}\n"
                               "implicit: " +
                                   implicit + "\ntime: {end: 1}\n");
}

/// The parts at a state; both codes have them, and their sum is the right-hand side.
std::vector<double> implicit_part(const std::string& implicit) {
  const double y[] = {0.3, -1.2, 0.7, 2, -3}, t = 0.4;
  std::vector<double> found;
  for (const TextOde::Code code : {TextOde::Code::compiled, TextOde::Code::interpreted}) {
    const TextOde ode(read(implicit), code);
    const OdeView view = ode.view();
    std::vector<double> e(5), i(5), f(5);
    view.explicit_part(view.problem, t, y, e.data());
    view.implicit_part(view.problem, t, y, i.data());
    view.rhs(view.problem, t, y, f.data());
    for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(e[k] + i[k], f[k], 1e-14) << k;
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(i[k], found[k], 1e-14) << k;
    found = i;
  }
  return found;
}

TEST(ImplicitPart, IsTheTermsThatAreNamed) {
  const double r = 0.3 * 0.3 * -1.2;
  const auto expect = [](const std::string& text, const std::vector<double>& values) {
    const std::vector<double> found = implicit_part(text);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(found[k], values[k], 1e-14) << text << ' ' << k;
  };
  // Parts given by terms: in another order, with the sign within a factor, of indexed states.
  expect("{u: -(B + 1)*u, v: k*sin(t) + B*u}", {-1.2, 0.9 + std::sin(0.4), 0, 0, 0});
  expect("{'w[1..2]': '-c*(w[i] - u)'}", {0, 0, -6 * 0.4, -6 * 1.7, 0});
  // Parts given by name: a whole equation, or all terms in which a definition is.
  expect("[u]", {1 + r - 1.2, 0, 0, 0, 0});
  expect("[w]", {0, 0, -2.4 + 0.7 * r, -10.2 + 2 * r, 19.8 - 3 * r});
  expect("[r]", {r, -r, 0.7 * r, 2 * r, -3 * r});
}

TEST(ImplicitPart, HasItsOwnJacobian) {
  const TextOde ode(read("{u: r, 'w[1..3]': '-c*(w[i] - u)'}"));
  const OdeView view = ode.view();
  const double y[] = {0.3, -1.2, 0.7, 2, -3};
  std::vector<double> j(25);
  view.implicit_jacobian(view.problem, 0.4, y, j.data());
  EXPECT_NEAR(j[0], 2 * 0.3 * -1.2, 1e-15);
  EXPECT_NEAR(j[1], 0.09, 1e-16);
  for (std::size_t k = 5; k < 10; ++k) EXPECT_EQ(j[k], 0) << k;
  for (std::size_t k = 2; k < 5; ++k) {
    EXPECT_EQ(j[5 * k], 6);
    EXPECT_EQ(j[5 * k + k], -6);
  }
  EXPECT_EQ(TextOde(read("[u]")).analysis().structure.with_implicit_part, 1u);
}

TEST(ImplicitPart, IsNotThereWhereNothingSaysIt) {
  const TextOde ode(
      formula::read_problem("f.yaml", "states: {x: 1}\nequations: {x: -x}\ntime: {end: 1}\n"));
  EXPECT_FALSE(ode.view().explicit_part || ode.view().implicit_part ||
               ode.view().implicit_jacobian);
}

// Built-in code is taken by a file with the same equations: not with other parts.
TEST(ImplicitPart, IsPartOfWhatAProblemIs) {
  const auto code = [](const std::string& implicit) {
    return formula::code_of_problem(
        "f.yaml", "states: {x: 1}\nequations: {x: -x - x^3}\ntime: {end: 1}\n" + implicit);
  };
  EXPECT_EQ(code("implicit: [x]"), code("implicit: [x]\nname: y"));
  EXPECT_NE(code("implicit: [x]"), code("implicit: {x: -x}"));
  EXPECT_NE(code("implicit: [x]"), code(""));
}

TEST(ImplicitPart, RefusesWhatIsNone) {
  struct Fault {
    const char *implicit, *place, *sentence;
  };
  const Fault faults[] = {
      {"{u: B*u}", "5:15", "implicit: u: term 1 of 1 is not in its equation"},
      {"{u: A + u}", "5:15", "term 2 of 2 is not in its equation"},
      {"{u: A + r + r}", "5:15", "term 3 of 3 is not in its equation"},
      {"{x: u}", "5:12", "implicit: no state; got x"},
      {"{w: u}", "5:12", "an index is missing"},
      {"{u: A + }", "5:", "implicit: u"},
      {"{u: q}", "5:15", "unknown name; got q"},
      {"[q]", "5:12", "got q, expected a state or a definition"},
      {"[A]", "5:12", "got A, expected a state or a definition"},
      {"[c]", "5:12", "a constant; got c"},
      {"[]", "5:11", "empty"},
      {"{}", "5:11", "empty"},
      {"u", "5:11", "expected terms by state"},
  };
  for (const Fault& fault : faults) {
    try {
      read(fault.implicit);
      ADD_FAILURE() << fault.implicit;
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find(fault.sentence), std::string::npos) << what;
      EXPECT_TRUE(what.starts_with(std::string("f.yaml:") + fault.place)) << what;
    }
  }
  EXPECT_THROW(formula::read_problem("f.yaml",
                                     "states: {x: 1}\nequations: {x: -x}\n"
                                     "implicit: [x]\ntime: {end: 1}\nmass: {x: {x: 2}}\n"),
               InputError);
}

}  // namespace
}  // namespace odeum::implicit_part_test
