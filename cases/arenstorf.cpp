// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// The restricted three-body problem Earth, Moon, satellite, in rotating axes.
struct Arenstorf {
  static constexpr std::size_t dimension = 4;
  static constexpr bool velocity_dependent = true;
  double moon = 0.012277471, earth = 1 - moon;

  template <class R>
  void acceleration(R, const R* q, const R* v, R* a) const {
    const R xe = q[0] + moon, xm = q[0] - earth, y = q[1];
    const R to_earth = earth / cubed_distance(xe, y), to_moon = moon / cubed_distance(xm, y);
    a[0] = q[0] + 2 * v[1] - to_earth * xe - to_moon * xm;
    a[1] = y - 2 * v[0] - (to_earth + to_moon) * y;
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 2, t, y, dydt);
  }
  void jacobian(double, const double* q, double* j) const {
    const double xe = q[0] + moon, xm = q[0] - earth, y = q[1];
    const double re2 = xe * xe + y * y, rm2 = xm * xm + y * y;
    const double e = earth / cubed_distance(xe, y), m = moon / cubed_distance(xm, y);
    const double xy = 3 * y * (e * xe / re2 + m * xm / rm2);
    const double rows[16] = {0,
                             0,
                             1,
                             0,
                             0,
                             0,
                             0,
                             1,
                             1 - e * (1 - 3 * xe * xe / re2) - m * (1 - 3 * xm * xm / rm2),
                             xy,
                             0,
                             2,
                             xy,
                             1 - e * (1 - 3 * y * y / re2) - m * (1 - 3 * y * y / rm2),
                             -2,
                             0};
    for (int i = 0; i < 16; ++i) j[i] = rows[i];
  }
  template <class R>
  static R cubed_distance(R x, R y) {
    const R r2 = x * x + y * y;
    return r2 * std::sqrt(r2);
  }
  /// Minus half of Jacobi's constant.
  double jacobi(const double* y) const {
    return (y[2] * y[2] + y[3] * y[3] - y[0] * y[0] - y[1] * y[1]) / 2 -
           earth / std::hypot(y[0] + moon, y[1]) - moon / std::hypot(y[0] - earth, y[1]);
  }
};

Case make_case(const Values& values) {
  const Arenstorf problem{.moon = values[0]};
  Case c;
  c.id = "arenstorf";
  c.title = "Arenstorf's orbit";
  c.equation =
      "x'' = x + 2 y' - mu' (x + mu)/D1 - mu (x - mu')/D2, y'' = y - 2 x' - mu' y/D1 - mu y/D2";
  c.source = "Arenstorf 1963; Hairer, Norsett, Wanner, Solving ODEs I, (II.0.1)-(II.0.2)";
  c.tags = {"nonlinear", "autonomous", "second_order", "celestial", "unstable"};
  c.components = {"x", "y", "vx", "vy"};
  c.y0 = {values[1], 0, 0, values[2]};
  c.stops = {17.0652165601579625588917206249};
  c.settings.no_fixed_steps =
      "close passes of the Moon need steps a thousand times shorter than the rest of the orbit";
  c.settings.evaluation_budget = 60'000;
  c.truth = reference_truth("arenstorf", 5.5e-11);
  c.invariants = {{"jacobi", [problem](const double* y) { return problem.jacobi(y); }}};
  set_stage(c, problem);
  return c;
}

}  // namespace

/// A periodic orbit of the restricted three-body problem with close passes of the Moon.
std::vector<Case> arenstorf() {
  return {with_tabled_parameters({{"mu", 0.012277471, "mass of the Moon over that of both"},
                                  {"x0", 0.994, "x at the start"},
                                  {"vy0", -2.00158510637908252240537862224, "y' at the start"}},
                                 make_case)};
}

}  // namespace odeum::cases
