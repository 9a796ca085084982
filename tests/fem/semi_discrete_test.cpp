// SPDX-License-Identifier: BSD-3-Clause
// Heat and waves by finite elements: the cases, and what theory says of the solvers on them.
#include "odeum/fem/semi_discrete.hpp"
#include "odeum/cases/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "odeum/fem/shapes.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::semi_discrete_test {
namespace {

using std::numbers::pi;
constexpr std::size_t n = 8;

fem::SemiDiscrete system_of(fem::Mass mass, std::size_t divisions = n) {
  return fem::semi_discrete(fem::unit_square(divisions), {.load = [](fem::Point) { return 0.; }},
                            mass);
}

const Case& case_of(const std::string& id) {
  for (const Case& c : all_cases())
    if (c.id == id) return c;
  throw std::out_of_range(id);
}

/// The state at `end` after equal steps.
std::vector<double> after(const Case& c, const std::string& method, double end,
                          std::uint64_t steps) {
  for (const Entrant& entrant : c.entrants)
    if (entrant.info.id() == "odeum/" + method) {
      Request request;
      request.steps = steps, request.stops = {end};
      const Outcome outcome = entrant.solve(request);
      return outcome.status == Status::ok ? outcome.states : std::vector<double>();
    }
  throw std::out_of_range(method);
}

/// The coordinate phi^T M u of one mode.
double coordinate(const fem::SemiDiscrete& system, std::size_t mode, const double* u) {
  std::vector<double> product(system.size());
  system.mass.multiply(u, product.data());
  long double sum = 0;
  for (std::size_t i = 0; i < product.size(); ++i)
    sum += system.modes->vectors[mode][i] * product[i];
  return static_cast<double>(sum);
}

// The five-point star: 4 / h^2 (sin^2(j pi h / 2) + sin^2(k pi h / 2)).
TEST(SemiDiscrete, LumpedModesAreThoseOfTheFivePointStar) {
  std::vector<double> exact;
  for (std::size_t j = 1; j < n; ++j)
    for (std::size_t k = 1; k < n; ++k)
      exact.push_back(4. * n * n *
                      (std::pow(std::sin(pi * static_cast<double>(j) / (2 * n)), 2) +
                       std::pow(std::sin(pi * static_cast<double>(k) / (2 * n)), 2)));
  std::sort(exact.begin(), exact.end());
  const fem::SemiDiscrete system = system_of(fem::Mass::lumped);
  ASSERT_EQ(system.modes->values.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i)
    EXPECT_NEAR(static_cast<double>(system.modes->values[i]), exact[i], 1e-13 * exact.back());
}

// Strang and Fix, An Analysis of the Finite Element Method, chapter 6: consistent from above,
// order 2.
TEST(SemiDiscrete, ConsistentMassIsAboveTheEigenvalueAndLumpedMassBelow) {
  double before[2] = {};
  for (const std::size_t divisions : {4, 8, 16}) {
    const double lumped = static_cast<double>(
        system_of(fem::Mass::lumped, divisions).modes->values[0] / (2 * pi * pi) - 1);
    const double consistent = static_cast<double>(
        system_of(fem::Mass::consistent, divisions).modes->values[0] / (2 * pi * pi) - 1);
    EXPECT_LT(lumped, 0);
    EXPECT_GT(consistent, 0);
    // The next term is (pi h)^2 / 10 or less of the first.
    if (before[0] != 0) {
      EXPECT_NEAR(before[0] / lumped, 4, 0.15);
      EXPECT_NEAR(before[1] / consistent, 4, 0.6);
    }
    before[0] = lumped, before[1] = consistent;
  }
}

// Peers are handed the sparse Jacobian where the mass is lumped; its inverse else is dense.
TEST(SemiDiscrete, JacobiansAreSparseWhereTheMassIsLumped) {
  for (const char* id : {"fem_heat", "fem_wave", "fem_heat_rough", "fem_wave_consistent"}) {
    const OdeView& view = case_of(id).problem.view;
    const bool lumped = std::string(id) == "fem_heat" || std::string(id) == "fem_wave";
    ASSERT_EQ(view.sparsity != nullptr, lumped) << id;
    if (!lumped) continue;
    std::vector<double> values(view.sparsity->entries()), y(view.dimension),
        dense(y.size() * y.size()), filled(dense.size());
    EXPECT_LT(values.size(), 7 * view.dimension) << id;
    view.jacobian_entries(view.problem, 0, y.data(), values.data());
    fill_dense(*view.sparsity, values.data(), filled.data());
    view.jacobian(view.problem, 0, y.data(), dense.data());
    EXPECT_EQ(filled, dense) << id;
  }
}

// h <= 2 / lambda_max.
TEST(FemHeat, ExplicitEulerIsStableToItsLimit) {
  for (const auto& [id, mass] :
       {std::pair{"fem_heat", fem::Mass::lumped}, {"fem_heat_rough", fem::Mass::consistent}}) {
    const double limit = 2 / static_cast<double>(system_of(mass).modes->values.back());
    const auto largest = [&, id = id](double h) {
      double size = 0;
      for (const double each : after(case_of(id), "explicit_euler", 1000 * h, 1000))
        size = std::fmax(size, std::abs(each));
      return size;
    };
    EXPECT_LT(largest(0.98 * limit), 2) << id;
    // |R| = 1.04, to the power of 1000.
    EXPECT_GT(largest(1.02 * limit), 1e6) << id;
  }
}

// What A-stability without L-stability leaves of a mode: R(z)^steps of it, with |R| near 1.
TEST(FemHeat, RoughModesStayWhereAMethodIsNotLStable) {
  const fem::SemiDiscrete system = system_of(fem::Mass::consistent);
  const std::size_t top = system.size() - 1;
  const Case& c = case_of("fem_heat_rough");
  constexpr std::uint64_t steps = 8;
  const double lambda = static_cast<double>(system.modes->values[top]), h = 50 / lambda, z = -50;
  const auto left = [&](const char* method) {
    return coordinate(system, top, after(c, method, steps * h, steps).data()) /
           coordinate(system, top, c.y0.data());
  };
  ASSERT_GT(std::abs(coordinate(system, top, c.y0.data())), 1e-3) << "the jump has the mode";
  const double crank_nicolson = (1 + z / 2) / (1 - z / 2);
  // Rounding of states of size 1, against a coordinate of 1e-3 or more.
  EXPECT_NEAR(left("trapezoidal"), std::pow(crank_nicolson, steps), 1e-11);
  EXPECT_GT(std::abs(left("trapezoidal")), 0.5);
  EXPECT_NEAR(left("implicit_euler"), std::pow(1 / (1 - z), steps), 1e-11);
  EXPECT_LT(std::abs(left("tr_bdf2")), 1e-4);
  EXPECT_LT(std::abs(left("radau_iia5")), 1e-4);
}

// A mode of frequency w turns by another angle a step: leapfrog with sin(a / 2) = w h / 2,
// Newmark's average acceleration with tan(a / 2) = w h / 2 (Hughes, The Finite Element Method,
// chapter 9).
TEST(FemWave, HasTheNumericalDispersionOfItsScheme) {
  for (const auto& [id, mass] :
       {std::pair{"fem_wave", fem::Mass::lumped}, {"fem_wave_consistent", fem::Mass::consistent}}) {
    const fem::SemiDiscrete system = system_of(mass);
    const Case& c = case_of(id);
    const double highest = std::sqrt(static_cast<double>(system.modes->values.back()));
    const double h = 1.8 / highest;
    constexpr std::uint64_t steps = 40;
    const std::vector<double> leapfrog = after(c, "velocity_verlet", steps * h, steps),
                              newmark = after(c, "trapezoidal", steps * h, steps);
    std::size_t seen = 0;
    for (std::size_t mode = 0; mode < system.size(); ++mode) {
      const double start = coordinate(system, mode, c.y0.data());
      if (std::abs(start) < 1e-4) continue;
      ++seen;
      const double half = std::sqrt(static_cast<double>(system.modes->values[mode])) * h / 2;
      // Rounding of 40 steps, against a coordinate of 1e-4 or more.
      EXPECT_NEAR(coordinate(system, mode, leapfrog.data()) / start,
                  std::cos(2 * steps * std::asin(half)), 1e-9)
          << id << mode;
      EXPECT_NEAR(coordinate(system, mode, newmark.data()) / start,
                  std::cos(2 * steps * std::atan(half)), 1e-9)
          << id << mode;
    }
    EXPECT_GT(seen, 4U);
    // Beyond w h = 2 leapfrog grows.
    const double beyond = 2.05 / highest;
    const std::vector<double> grown = after(c, "velocity_verlet", 400 * beyond, 400);
    EXPECT_TRUE(grown.empty() || std::abs(grown[0]) > 1e3) << id;
  }
}

// Every solver of another library that fits and chooses its steps.
TEST(FemCases, PeersFindTheSolutions) {
  for (const char* id : {"fem_heat", "fem_heat_rough", "fem_wave", "fem_wave_consistent"}) {
    const Case& c = case_of(id);
    std::vector<double> truth(c.y0.size());
    ASSERT_TRUE(c.truth.at(c.stops.back(), truth.data()));
    std::size_t solved = 0;
    for (const Entrant& entrant : c.entrants) {
      if (entrant.info.library == "odeum" || !entrant.unfit.empty() || !entrant.info.adaptive)
        continue;
      Request request;
      request.stops = {c.stops.back()};
      request.mode = Mode::adaptive, request.tolerance = 1e-5;
      const Outcome outcome = entrant.solve(request);
      ASSERT_EQ(outcome.status, Status::ok)
          << id << ' ' << entrant.info.id() << ' ' << outcome.detail;
      double error = 0, size = 0;
      for (std::size_t i = 0; i < truth.size(); ++i) {
        error = std::max(error, std::abs(outcome.states[i] - truth[i]));
        size = std::max({size, std::abs(truth[i]), std::abs(c.y0[i])});
      }
      // Explicit pairs at their limit of stability leave up to 200 times the tolerance; a run that
      // went wrong leaves the size of the solution.
      EXPECT_LT(error, 0.02 * size) << id << ' ' << entrant.info.id();
      ++solved;
    }
    EXPECT_GE(solved, c.entrants.size() > 200 ? 60U : 0U) << "with all libraries";
  }
}

}  // namespace
}  // namespace odeum::semi_discrete_test
