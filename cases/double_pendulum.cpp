// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// Two equal masses on two equal massless rods, angles a and b from the downward vertical:
///
///     2 a'' + b'' cos(a - b) = -b'^2 sin(a - b) - 2 g sin a,
///     a'' cos(a - b) + b'' = a'^2 sin(a - b) - g sin b.
struct DoublePendulum {
  static constexpr std::size_t dimension = 4;
  static constexpr bool velocity_dependent = true;
  double g = 9.81;

  template <class R>
  void acceleration(R, const R* q, const R* v, R* a) const {
    const R c = std::cos(q[0] - q[1]), s = std::sin(q[0] - q[1]);
    const R first = -v[1] * v[1] * s - 2 * g * std::sin(q[0]);
    const R second = v[0] * v[0] * s - g * std::sin(q[1]);
    solve(c, first, second, a[0], a[1]);
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 2, t, y, dydt);
  }
  /// By differentiating M(q) a = r(q, v): M da = dr - dM a.
  void jacobian(double t, const double* y, double* j) const {
    for (int i = 0; i < 16; ++i) j[i] = 0;
    j[2] = j[7] = 1;
    double a[2];
    acceleration(t, y, y + 2, a);
    const double c = std::cos(y[0] - y[1]), s = std::sin(y[0] - y[1]);
    // cos(a - b) is in M: its derivative by the first angle is -s, by the second s.
    const double by_difference[2] = {-y[3] * y[3] * c + s * a[1], y[2] * y[2] * c + s * a[0]};
    const double right[4][2] = {{by_difference[0] - 2 * g * std::cos(y[0]), by_difference[1]},
                                {-by_difference[0], -by_difference[1] - g * std::cos(y[1])},
                                {0, 2 * y[2] * s},
                                {-2 * y[3] * s, 0}};
    for (int k = 0; k < 4; ++k) solve(c, right[k][0], right[k][1], j[8 + k], j[12 + k]);
  }
  double energy(const double* y) const {
    return y[2] * y[2] + y[3] * y[3] / 2 + y[2] * y[3] * std::cos(y[0] - y[1]) -
           2 * g * std::cos(y[0]) - g * std::cos(y[1]);
  }

 private:
  template <class R>
  static void solve(R c, R first, R second, R& x, R& y) {
    const R determinant = 2 - c * c;
    x = (first - c * second) / determinant;
    y = (2 * second - c * first) / determinant;
  }
};

Case make_case(const Values& values) {
  Case c;
  c.id = "double_pendulum_mild";
  c.title = "Double pendulum";
  c.equation =
      "2 a'' + b'' cos(a-b) + b'^2 sin(a-b) + 2 g sin a = 0, b'' + a'' cos(a-b) - a'^2 sin(a-b) + "
      "g sin b = 0";
  c.source = "Lagrange's equations, any mechanics text";
  c.tags = {"nonlinear", "autonomous", "second_order", "mechanical"};
  c.y0 = {values[1], values[2], values[3], values[4]};
  c.components = {"a", "b", "a_rate", "b_rate"};
  c.stops = {1, 2, 5};
  c.settings.steps_multiple = 5;
  c.settings.coarsest_steps = 80;
  c.settings.finest_steps = 5120;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth("double_pendulum_mild", 2e-15);
  set_stage(c, DoublePendulum{values[0]});
  return c;
}

}  // namespace

/// A double pendulum at small amplitudes, where its motion is regular.
std::vector<Case> double_pendulum() {
  return {with_tabled_parameters({{"g", 9.81, "gravity over length, 1/s^2"},
                                  {"a0", 0.5, "upper angle at the start, rad"},
                                  {"b0", -0.25, "lower angle at the start, rad"},
                                  {"a_rate0", 0, "its rate, rad/s"},
                                  {"b_rate0", 0, "its rate, rad/s"}},
                                 make_case)};
}

}  // namespace odeum::cases
