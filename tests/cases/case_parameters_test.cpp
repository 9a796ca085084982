// SPDX-License-Identifier: BSD-3-Clause
// Cases with other parameters and other times: their truth, and the closed forms of schemes.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/truth/computed_truth.hpp"
#include "support/catalogue.hpp"

namespace odeum::tests::case_parameters_test {
namespace {

// Kepler's equation E - e sin E = t has the exact state: e = 0.3 is in no table.
TEST(ComputedTruth, IsExact) {
  const double e = 0.3;
  const Case c = find_case("kepler_e06").with_values({e}, {});
  const std::vector<double> times{0.5, 2, 7, 11};
  const Truth truth = truth::truth_at(c, times);
  EXPECT_LT(truth.floor, 1e-15);
  for (const double t : times) {
    double anomaly = t;
    for (int k = 0; k < 60; ++k)
      anomaly -= (anomaly - e * std::sin(anomaly) - t) / (1 - e * std::cos(anomaly));
    double y[4];
    ASSERT_TRUE(truth.at(t, y)) << t;
    // The initial velocity of the case is rounded: to t = 11 that moves the orbit by some 30
    // roundings.
    EXPECT_NEAR(y[0], std::cos(anomaly) - e, 1e-14) << t;
    EXPECT_NEAR(y[1], std::sqrt(1 - e * e) * std::sin(anomaly), 1e-14) << t;
  }
  double y[4];
  EXPECT_FALSE(truth.at(3, y)) << "a time that was not asked for";
}

// Every case that has parameters, with each of them a little changed, is a problem whose truth,
// where there is one, a fine run confirms.
TEST(CaseParameters, TheTruthFollows) {
  std::size_t with = 0, confirmed = 0;
  for (const Case& c : all_cases()) {
    for (std::size_t p = 0; p < c.parameters.size(); ++p) {
      ++with;
      std::vector<double> values;
      for (const Parameter& parameter : c.parameters) values.push_back(parameter.value);
      values[p] = values[p] == 0 ? 0.1 : values[p] * 1.1;
      const Case other = c.with_values(values, {});
      const double end = c.t0 + (c.stops.front() - c.t0) / (c.nature.stiff ? 1e3 : 2);
      const Outcome outcome =
          find_entrant(other, "odeum/verner98").solve(adaptive_request(1e-11, {end}));
      ASSERT_EQ(outcome.status, Status::ok) << c.id << " " << c.parameters[p].name;
      std::vector<double> exact(other.y0.size());
      Truth truth = other.truth;
      if (!truth.at(end, exact.data())) truth = truth::truth_at(other, {end});
      if (!truth.at(end, exact.data())) continue;
      ++confirmed;
      for (std::size_t i = 0; i < exact.size(); ++i)
        EXPECT_NEAR(outcome.states[i], exact[i], 1e-8 * (1 + std::abs(exact[i])))
            << c.id << " " << c.parameters[p].name;
    }
  }
  EXPECT_GE(with, 120U);
  EXPECT_EQ(confirmed, with);
}

TEST(CaseParameters, TheirUsualValuesMakeTheCaseItself) {
  for (const Case& c : all_cases()) {
    if (c.parameters.empty()) continue;
    std::vector<double> values;
    for (const Parameter& parameter : c.parameters) values.push_back(parameter.value);
    const Case same = c.with_values(values, {});
    EXPECT_EQ(same.equation, c.equation);
    EXPECT_EQ(same.y0, c.y0);
    EXPECT_EQ(same.truth.source, c.truth.source);
    EXPECT_EQ(component_names(c).size(), c.y0.size()) << c.id;
  }
}

// Each scheme whose closed form a case has, against a run: to the rounding of 100 steps.
TEST(CaseSchemes, AreWhatTheSolversDo) {
  std::size_t compared = 0;
  for (const Case& c : all_cases()) {
    if (!c.scheme) continue;
    for (const Entrant& entrant : c.entrants) {
      std::vector<double> y(c.y0.size());
      const double end = c.stops.front(), h = (end - c.t0) / 100;
      if (!entrant.unfit.empty() || !c.scheme(entrant.info.id(), h, 100, y.data())) continue;
      const Outcome outcome = entrant.solve(fixed_request(100, {end}));
      ASSERT_EQ(outcome.status, Status::ok);
      for (std::size_t i = 0; i < y.size(); ++i)
        EXPECT_NEAR(outcome.states[i], y[i], 1e-12 * (1 + std::abs(y[i])))
            << entrant.info.id() << " on " << c.id;
      ++compared;
    }
  }
  EXPECT_GE(compared, 25U);
}

}  // namespace
}  // namespace odeum::tests::case_parameters_test
