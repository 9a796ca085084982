// SPDX-License-Identifier: BSD-3-Clause
// Sums over an index: sum(j, x[j] - x[i]).
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "odeum/formula/evaluator.hpp"
#include "support/problem_texts.hpp"

namespace odeum::sums_test {
namespace {

using tests::fault_of;

std::string with_sum(const std::string& equation) {
  return "states: {x[1..3]: i, u[1..2]: 0, z: 1}\nequations:\n  x[1..3]: " + equation +
         "\n  u[1..2]: 0\n  z: 0\ntime: {end: 1}\n";
}

std::vector<double> values_of(const std::string& equation) {
  const formula::Problem p = formula::read_problem("f", with_sum(equation));
  const double y[] = {1, 2, 4, 10, 20, 100};
  std::vector<double> f(6);
  formula::Evaluator<double>(p.graph, p.equations)(0, y, f.data());
  f.resize(3);
  return f;
}

TEST(Sums, AreThoseOfTheirTerms) {
  using Values = std::vector<double>;
  EXPECT_EQ(values_of("sum(j, x[j])"), (Values{7, 7, 7}));
  EXPECT_EQ(values_of("sum( k , x[k]*(x[k] - x[i]) ) / 2"), (Values{7, 3.5, -3.5}));
  EXPECT_EQ(values_of("sum(j, u[j]*sum(k, x[k] + j)) - z"),
            (Values{10 * 10 + 20 * 13 - 100, 260, 260}));
  // The term of an index that is left out divides by zero.
  EXPECT_EQ(values_of("sum(j, if(j != i, 1/(x[j] - x[i]), 0))"),
            (Values{1 + 1.0 / 3, -1 + 0.5, -1.0 / 3 - 0.5}));
  EXPECT_EQ(values_of("sum(j, if(j < 3, x[j+1] - x[j], 0))"), (Values{3, 3, 3}));
}

TEST(Sums, MistakesHaveTheirPlace) {
  const auto expect = [](const std::string& equation, const std::string& begin,
                         const std::string& part) {
    const std::string fault = fault_of(with_sum(equation));
    EXPECT_TRUE(fault.starts_with(begin) && fault.find(part) != std::string::npos) << fault;
  };
  expect("sum(j, z)", "3:18: ", "a sum over no array");
  expect("sum(x[j])", "3:16: ", "expected a new name: sum(j, x[j])");
  expect("sum(i, x[i])", "3:16: ", "expected a new name");
  expect("sum(z, x[z])", "3:16: ", "expected a new name");
  expect("sum(j, sum(j, x[j]))", "3:23: ", "expected a new name");
  expect("sum(, x[j])", "3:16: ", "got none");
  expect("sum(j x[j])", "3:18: ", "a sum has an index and a term, sum(j, x[j]); got");
  // What a comma leaves of an expression within { }.
  expect("sum(j", "3:17: ", "quote an expression with a comma");
  expect("sum(j, x[j]*u[j])", "3:24: ", "got 1 to 3 and 1 to 2");
  expect("sum(j, x[j+1] + x[j])", "3:19: ", "out of range");
  expect("sum(j, x[j]", "3:23: ", "an open parenthesis");
  expect("sum(j, if(j < 9, 1, 0)/(x[j] - x[j]))", "", "division by zero");
  expect("sums(j, x[j])", "3:12: ", "did you mean sum?");
  std::string nested = "x[a]";
  for (const char index : std::string("abcdfghklmnopq")) {
    std::string outer = "sum(?, x[?] + ";
    std::replace(outer.begin(), outer.end(), '?', index);
    nested = outer.append(nested).append(")");
  }
  expect(nested, "", "terms in all sums");
}

// 10^10 terms of 10^5 states, all of which are the same few operations, were read for hours.
TEST(Sums, TooManyTermsOfAllStatesAreRefused) {
  const std::string states = "states: {x[1..100000]: i}\ntime: {end: 1}\n";
  EXPECT_NE(fault_of(states + "equations:\n  x[1..100000]: sum(j, x[j])\n").find("the definitions"),
            std::string::npos);
  EXPECT_EQ(fault_of(states +
                     "definitions:\n  all: sum(j, x[j])\nequations:\n  x[1..100000]: all - x[i]\n"),
            "");
}

}  // namespace
}  // namespace odeum::sums_test
