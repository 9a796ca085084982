// SPDX-License-Identifier: BSD-3-Clause
// Truths of texts that switch in time, begin in a short transient, or have what steps can't
// resolve: what is claimed is right against closed forms, and what is not known is not claimed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <numbers>

#include "odeum/cases/text_truth.hpp"

namespace odeum::named_switches_test {
namespace {

using Real = long double;

struct Text {
  const char* name;
  const char* text;
  double time;                ///< of `exact`, at or before the end
  std::vector<double> exact;  ///< to the rounding of double
  double digits;              ///< a relative error that the floor is below
};

cases::TextTruth truth_of(const std::string& text) {
  return cases::truth_of(std::make_shared<const formula::TextOde>(
      formula::read_problem("f", text), formula::TextOde::Code::interpreted));
}

const double pi = std::numbers::pi;

// Problems from published questions and bug reports, and from closed forms.
const Text known[] = {
    {"impulse",
     "{states: {y: 0}, equations: {y: 'if(abs(t - 37.123456) < 5e-12, 1e11, 0) - 0.1*y'},"
     " time: {end: 40}}",
     40,
     {std::exp(-0.1 * (40 - 37.123456))},
     1e-3},
    {"narrow_lorentzian",
     "{states: {x: 1, y: 0}, equations: {x: '1', y: '1e-6/((x - 5.5)^2 + 1e-12)'},"
     " time: {end: 50}}",
     50,
     {51, 3.141592409389549},
     1e-10},
    {"rectifier",
     "{states: {v: 0}, equations: {v: '1e4*(max(sin(t), 0) - v)'}, time: {end: 20}}",
     20,
     {(1e8 * std::sin(20) - 1e4 * std::cos(20)) / (1e8 + 1)},
     1e-11},
    {"late_switch",
     "{parameters: {k: 1e6, at: 1e-3}, states: {y: 1}, time: {end: 10, stops: [0.00101, 10]},"
     " equations: {y: 'if(t < at, -y, -k*y)'}}",
     0.00101,
     {std::exp(-1e-3 - 1e6 * (0.00101 - 1e-3))},
     1e-9},
    {"niles",
     "{states: {x1: 0, x2: 0, x3: 0, x4: 0}, definitions: {on: 'if(t > 1, 1, 0)'}, time: {end: 2},"
     " equations: {x1: '1e9 + 5e4*x3 - 50*x1', x2: '40*x1 - 3.3e3*x2',"
     " x3: '2e3*x2 - 5e4*x3 + 3.5e7*on*x4', x4: '1e3*x2 - on*5e7*x4'}}",
     2,
     {57894747.95788498, 701754.5214030866, 37894.744158268149, 14.035090428062658},
     1e-3},
    {"c_over_c",
     "{parameters: {C: 1e50, c0: 1e6}, states: {c: c0}, equations: {c: C/c},"
     " time: {start: 1, end: 2}}",
     2,
     {std::sqrt(1e12 + 2e50)},
     1e-14},
    // No value at the switch itself, to whose side its rounded time may belong.
    {"essential_from_2",
     "{states: {y: 0}, equations: {y: 'if(t > 2, exp(-1/(t - 2))/(t - 2)^2, 0)'}, time: {end: 3}}",
     3,
     {std::exp(-1)},
     1e-12},
    {"root_to_the_third_part",
     "{states: {y: 0}, equations: {y: 'if(t < 1/3, (1/3 - t)^2.5, 0)'}, time: {end: 1}}",
     1,
     {std::pow(1.0 / 3, 3.5) / 3.5},
     1e-9},
    // At 1 the sign of u jumps with it, and abs(u) < 1 holds before and after that.
    {"jump_of_an_argument",
     "{states: {y: 0}, definitions: {u: '(t - if(t > 1, 2, 0))*1.6'}, time: {end: 2},"
     " equations: {y: 'if(abs(u) < 1, 1, 0)'}}",
     2,
     {2 / 1.6},
     1e-12},
    {"stiff_from_80",
     "{states: {y: 1}, equations: {y: '-if(t > 80, 1e5, 1)*(y - cos(t)) - sin(t)'},"
     " time: {end: 100}}",
     100,
     {std::cos(100)},
     1e-11},
    {"stiff_to_half",
     "{states: {y: 1}, equations: {y: 'if(t < 0.5, -1e6, -1)*(y - cos(t)) - sin(t)'},"
     " time: {end: 5}}",
     5,
     {std::cos(5)},
     1e-10},
    {"gauss_from_zero",
     "{states: {y: 0}, equations: {y: 'exp(-((t - 5)/1e-3)^2)'}, time: {end: 10}}",
     10,
     {1e-3 * std::sqrt(pi)},
     1e-13},
    {"infusion",
     "{states: {y: 0}, equations: {y: 'if(t < 2, 50, 0) - 0.3*y'}, time: {end: 10}}",
     10,
     {50 / 0.3 * -std::expm1(-0.6) * std::exp(-2.4)},
     1e-14},
    {"doses",
     "{states: {y: 0}, equations: {y: 'if(t - 6*floor(t/6) < 1, 1, 0) - y'}, time: {end: 24}}",
     24,
     {(std::exp(1) - 1) * (std::exp(-6) + std::exp(-12) + std::exp(-18) + std::exp(-24))},
     1e-13},
    // A step of 6e-12 that ends at the state's switch can't be looked into.
    {"stairs",
     "{states: {x: 0, y: 0}, equations: {x: '0.5', y: 'floor(x)'}, time: {end: 7}}",
     7,
     {3.5, 2 * 1 + 2 * 2 + 3 * 1},
     1e-11},
};

class Known : public testing::TestWithParam<Text> {};

TEST_P(Known, ToTheirFloors) {
  const std::clock_t begin = std::clock();
  const cases::TextTruth truth = truth_of(GetParam().text);
  // The goal is five seconds; a sanitizer takes ten times as long.
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 50);
  std::vector<double> y(GetParam().exact.size());
  ASSERT_TRUE(truth.truth.at(GetParam().time, y.data())) << truth.words;
  double largest = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double exact = GetParam().exact[i];
    largest = std::max(largest, std::abs(exact));
    // The closed form rounds, too.
    EXPECT_NEAR(y[i], exact, truth.truth.floor + 1e-14 * std::abs(exact)) << truth.words;
  }
  EXPECT_LE(truth.truth.floor, GetParam().digits * largest) << truth.words;
}

INSTANTIATE_TEST_SUITE_P(Texts, Known, testing::ValuesIn(known),
                         [](const auto& instance) { return instance.param.name; });

// A slope without bound at a time that the equations name, or at a state that they pass, does not
// end the solution: y = 2 sqrt(t - 1.5) + ... goes on.
TEST(Unknown, AFiniteSolutionIsNotCalledInfinite) {
  struct Steep {
    const char* equations;
    double at_end;  ///< not a number: another solution may go on
  };
  for (const auto& [equations, at_end] :
       {Steep{"{y: 1/sqrt(abs(t - 1.5))}", 4 * std::sqrt(1.5)},
        Steep{"{y: 'abs(t - 1.5)^(-0.25)'}", 2 * std::pow(1.5, 0.75) / 0.75},
        Steep{"{y: -1/sqrt(abs(y + 1))}", std::nan("")}}) {
    const cases::TextTruth truth =
        truth_of(fmt::format("{{states: {{y: 0}}, equations: {}, time: {{end: 3}}}}", equations));
    double y = 0;
    EXPECT_FALSE(truth.truth.at(2.9, &y)) << equations << ' ' << truth.words;
    if (truth.truth.at(3, &y))
      EXPECT_LT(std::abs(y - at_end), truth.truth.floor) << equations;
    else
      EXPECT_LT(truth.known_until, 1.5) << equations;
  }
}

TEST(Unknown, SlidingIsTheReason) {
  for (const char* text :
       {"{states: {v: 10}, equations: {v: -sign(v)*2.94}, time: {end: 10}}",
        "{states: {x: 1, y: 0}, equations: {x: x*(y + 1), y: 'if(y > 0.5, -0.01, 1)'}, time: {end: "
        "0.52}}",
        "{states: {x: 1, v: 0}, equations: {x: v, v: '-100*x - 10*sign(v)'}, time: {end: 10}}"}) {
    const cases::TextTruth truth = truth_of(text);
    EXPECT_NE(truth.words.find("sliding"), std::string::npos) << truth.words;
  }
}

// A pulse that is narrower than the rounding of the time, or than steps can be.
TEST(Unknown, WhatIsTooNarrowIsNotClaimed) {
  for (const char* equation :
       {"if(abs(t - 3.3) < 1e-16, 5e15, 0)", "exp(-((t - 3.3)/1e-16)^2)/1e-16"}) {
    const cases::TextTruth truth = truth_of(
        fmt::format("{{states: {{y: 0}}, equations: {{y: '{}'}}, time: {{end: 5}}}}", equation));
    double y = 0;
    EXPECT_FALSE(truth.truth.at(5, &y)) << equation << ' ' << truth.words;
    EXPECT_GE(truth.known_until, 2.5) << equation;
  }
}

}  // namespace
}  // namespace odeum::named_switches_test
