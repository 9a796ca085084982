// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/set_problem.hpp"

namespace odeum::cases {
namespace {

/// Two unit masses, a soft spring to the wall and a stiff one between them.
struct StiffChain {
  static constexpr std::size_t dimension = 4;
  static constexpr bool velocity_dependent = false;
  double k1 = 1, k2 = 1e4;

  template <class R>
  void acceleration(R, const R* q, const R*, R* a) const {
    const R pull = k2 * (q[1] - q[0]);
    a[0] = pull - k1 * q[0];
    a[1] = -pull;
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 2, t, y, dydt);
  }
  void jacobian(double, const double*, double* j) const {
    for (int i = 0; i < 16; ++i) j[i] = 0;
    j[2] = j[7] = 1;
    j[8] = -k1 - k2;
    j[9] = j[12] = k2;
    j[13] = -k2;
  }
  void linear_matrix(double* a) const { jacobian(0, nullptr, a); }
  double energy(const double* y) const {
    return (y[2] * y[2] + y[3] * y[3] + k1 * y[0] * y[0] + k2 * (y[1] - y[0]) * (y[1] - y[0])) / 2;
  }
};

Case make_case(const Values& values) {
  Case c;
  c.nature.linear = c.nature.stiff = true;
  c.equation = "x1'' = -k1 x1 + k2 (x2 - x1), x2'' = -k2 (x2 - x1), x(0) = (x1, x2) at rest";
  c.source = "two-mass chain, any mechanics text";
  c.y0 = {values[2], values[3], 0, 0};
  c.components = {"x1", "x2", "v1", "v2"};
  c.stops = {0.1, 1};
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 200;
  c.settings.finest_steps = 12800;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth("stiff_chain2_k1e4", 1.1e-14);
  set_problem(c, StiffChain{values[0], values[1]});
  return c;
}

}  // namespace

/// A fast vibration of small amplitude superposed on a slow one.
std::vector<Statement> stiff_chain() {
  return {{.id = "stiff_chain2_k1e4",
           .title = "Two masses and a stiff spring",
           .tags = {"second_order", "separable", "mechanical", "oscillatory"},
           .make = [] {
             return with_tabled_parameters({{"k1", 1, "stiffness to the wall, 1/s^2"},
                                            {"k2", 1e4, "stiffness between the masses, 1/s^2"},
                                            {"x1", 1, "at the start"},
                                            {"x2", 1.001, "at the start"}},
                                           make_case);
           }}};
}

}  // namespace odeum::cases
