// SPDX-License-Identifier: BSD-3-Clause
// Under a constant acceleration every scheme has a closed form after k steps of h:
//   x_k = x0 + k h v0 + h^2 g (k^2 / 2 + c k),   v_k = v0 + k h g,
// with c = -1/2 where a step uses the velocity at its start, +1/2 where it uses the one at its end,
// and 0 for every method of order 2 and more, which is exact.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "support/catalogue.hpp"

namespace odeum::tests::free_fall_test {
namespace {

constexpr double g = -9.81, x0 = 10, v0 = 3;

std::optional<double> coefficient_of(const SolverInfo& info) {
  static const std::map<std::string, double> first_order{
      {"explicit_euler", -0.5},
      {"cash_karp54_order1", -0.5},
      {"symplectic_euler", 0.5},
      {"symplectic_euler_position_first", -0.5},
      {"implicit_euler", 0.5},
      {"implicit_euler_fixed_point", 0.5},
      {"implicit_euler_linearised", 0.5},
  };
  if (info.order >= 2) return 0;
  const auto found = first_order.find(info.method);
  if (found == first_order.end()) return std::nullopt;
  return found->second;
}

struct Exact {
  double x, v;
};

Exact after(double k, double h, double c) {
  return {x0 + k * h * v0 + h * h * g * (k * k / 2 + c * k), v0 + k * h * g};
}

/// Bound on the rounding of k steps. Sizes are |x|, |v| h <= 30 here, weights of a tableau sum to
/// less than 10 in modulus, so a step rounds by less than 100 epsilon. Stormer-Verlet adds h^2 a to
/// numbers of the size of x: its rounding grows with k^2 in x, and in v is divided by h.
Exact rounding(const std::string& method, double k, double h) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  if (method == "stormer_verlet") return {30 * epsilon * (1 + k * k), 30 * epsilon * (1 + k) / h};
  // The weights of the extrapolation to column 5 sum up to some hundred in modulus.
  if (method == "seulex") return {1e4 * epsilon * k, 1e4 * epsilon * k};
  return {100 * epsilon * k, 100 * epsilon * k};
}

TEST(FreeFall, EveryOwnSchemeMatchesItsClosedFormToRounding) {
  const Case& c = find_case("free_fall");
  int checked = 0;
  for (const Entrant& entrant : c.entrants) {
    if (entrant.info.library != "odeum") continue;
    // The problem offers no Taylor series, no constant matrix, no damping and no parts.
    if (entrant.info.family == "taylor" || entrant.info.family == "exponential" ||
        entrant.info.family == "splitting" || entrant.info.family == "imex_rk")
      continue;
    if (!entrant.info.fixed || entrant.info.needs.starts_with("residuals")) continue;
    ASSERT_TRUE(entrant.solve) << entrant.info.id() << " does not fit free fall";
    std::optional<double> coefficient = coefficient_of(entrant.info);
    if (!coefficient) {  // a new method of order 1: its first step determines the coefficient
      const double h = 0.25;
      const Outcome one = entrant.solve(fixed_request(1, {h}));
      ASSERT_EQ(one.status, Status::ok) << entrant.info.id();
      coefficient = (one.states[0] - x0 - h * v0) / (h * h * g) - 0.5;
    }
    for (const std::uint64_t steps : {8U, 20U, 640U}) {
      SCOPED_TRACE(entrant.info.id() + " in " + std::to_string(steps) + " steps");
      const Outcome outcome = entrant.solve(fixed_request(steps, c.stops));
      ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
      const double h = c.stops.back() / static_cast<double>(steps);
      for (std::size_t stop = 0; stop < c.stops.size(); ++stop) {
        const double k = std::round(c.stops[stop] / h);
        const Exact exact = after(k, h, *coefficient);
        const Exact tolerance = rounding(entrant.info.method, k, h);
        const auto y = state_at(outcome, stop, 2);
        EXPECT_NEAR(y[0], exact.x, tolerance.x) << "x at t = " << c.stops[stop];
        EXPECT_NEAR(y[1], exact.v, tolerance.v) << "v at t = " << c.stops[stop];
      }
    }
    ++checked;
  }
  EXPECT_GE(checked, 12);  // the methods that this test names or knows to be exact
}

// The forms above differ by h^2 g k: the test could not pass with the wrong one.
TEST(FreeFall, TheClosedFormsAreFarApart) {
  const double h = 2.0 / 640;
  EXPECT_GT(std::abs(after(640, h, 0.5).x - after(640, h, 0).x), 1e9 * rounding("", 640, h).x);
}

}  // namespace
}  // namespace odeum::tests::free_fall_test
