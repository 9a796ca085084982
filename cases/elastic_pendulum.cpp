// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "support/reference.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

/// A mass swinging on a stiff spring, in polar coordinates (r, theta):
///
///     r'' = r theta'^2 + g cos theta - k (r - 1),   theta'' = -(g sin theta + 2 r' theta') / r.
struct ElasticPendulum {
  static constexpr std::size_t dimension = 4;
  static constexpr bool velocity_dependent = true;
  static constexpr double g = 9.81, l0 = 1;
  double k;  ///< per unit mass, 1/s^2

  void acceleration(double, const double* q, const double* v, double* a) const {
    a[0] = q[0] * v[1] * v[1] + g * std::cos(q[1]) - k * (q[0] - l0);
    a[1] = -(g * std::sin(q[1]) + 2 * v[0] * v[1]) / q[0];
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 2, t, y, dydt);
  }
  void jacobian(double, const double* y, double* j) const {
    for (int i = 0; i < 16; ++i) j[i] = 0;
    const double s = std::sin(y[1]), c = std::cos(y[1]);
    j[2] = j[7] = 1;
    j[8] = y[3] * y[3] - k;
    j[9] = -g * s;
    j[11] = 2 * y[0] * y[3];
    j[12] = (g * s + 2 * y[2] * y[3]) / (y[0] * y[0]);
    j[13] = -g * c / y[0];
    j[14] = -2 * y[3] / y[0];
    j[15] = -2 * y[2] / y[0];
  }
  /// Per unit mass.
  double energy(const double* y) const {
    return (y[2] * y[2] + y[0] * y[0] * y[3] * y[3] + k * (y[0] - l0) * (y[0] - l0)) / 2 -
           g * y[0] * std::cos(y[1]);
  }
};

Case make_variant(const char* id, const char* title, const char* equation, double k,
                  std::vector<double> stops) {
  Case c;
  c.id = id;
  c.title = title;
  c.equation = equation;
  c.source = "elastic pendulum, any mechanics text";
  c.tags = {"nonlinear", "autonomous", "second_order", "mechanical", "oscillatory", "stiff"};
  c.y0 = {1, 1, 0, 0};
  c.settings.steps_multiple = stops.size() > 1 ? 10 : 1;
  c.stops = std::move(stops);
  c.settings.coarsest_steps = 160;
  c.settings.finest_steps = 5120;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth(id, 3e-16);
  set_stage(c, ElasticPendulum{k});
  return c;
}

}  // namespace

/// A pendulum whose rod is a stiff spring: a fast radial vibration and a slow swing.
std::vector<Case> elastic_pendulum() {
  return {make_variant("elastic_pendulum_k1e4", "Elastic pendulum",
                       "r'' = r th'^2 + g cos th - 1e4 (r - 1), th'' = -(g sin th + 2 r' th') / r",
                       1e4, {0.1, 1}),
          make_variant("elastic_pendulum_k1e6", "Elastic pendulum, a hundred times stiffer",
                       "r'' = r th'^2 + g cos th - 1e6 (r - 1), th'' = -(g sin th + 2 r' th') / r",
                       1e6, {0.1})};
}

}  // namespace odeum::cases
