// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// A mass swinging on a stiff spring, in polar coordinates (r, theta):
///
///     r'' = r theta'^2 + g cos theta - k (r - 1),   theta'' = -(g sin theta + 2 r' theta') / r.
struct ElasticPendulum {
  static constexpr std::size_t dimension = 4;
  static constexpr bool velocity_dependent = true;
  double k;  ///< per unit mass, 1/s^2
  double g = 9.81, l0 = 1;

  template <class R>
  void acceleration(R, const R* q, const R* v, R* a) const {
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

Case make_case(const char* id, const char* title, std::vector<double> stops, const Values& values) {
  Case c;
  c.id = id;
  c.title = title;
  c.equation = "r'' = r th'^2 + g cos th - k (r - l0), th'' = -(g sin th + 2 r' th') / r";
  c.source = "elastic pendulum, any mechanics text";
  c.tags = {"nonlinear", "autonomous", "second_order", "mechanical", "oscillatory", "stiff"};
  c.y0 = {values[3], values[4], 0, 0};
  c.components = {"r", "th", "r_rate", "th_rate"};
  c.settings.steps_multiple = stops.size() > 1 ? 10 : 1;
  c.stops = std::move(stops);
  c.settings.coarsest_steps = 160;
  c.settings.finest_steps = 5120;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth(id, 3e-16);
  set_stage(c, ElasticPendulum{values[0], values[1], values[2]});
  return c;
}

Case make_variant(const char* id, const char* title, double k, const std::vector<double>& stops) {
  return with_tabled_parameters({{"k", k, "stiffness over mass, 1/s^2"},
                                 {"g", 9.81, "gravity, m/s^2"},
                                 {"l0", 1, "length at rest, m"},
                                 {"r0", 1, "length at the start, m"},
                                 {"th0", 1, "angle at the start, rad"}},
                                [=](const Values& values) {
                                  require_positive("r0", values[3]);
                                  return make_case(id, title, stops, values);
                                });
}

}  // namespace

/// A pendulum whose rod is a stiff spring: a fast radial vibration and a slow swing.
std::vector<Case> elastic_pendulum() {
  return {make_variant("elastic_pendulum_k1e4", "Elastic pendulum", 1e4, {0.1, 1}),
          make_variant("elastic_pendulum_k1e6", "Elastic pendulum, a hundred times stiffer", 1e6,
                       {0.1})};
}

}  // namespace odeum::cases
