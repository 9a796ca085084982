// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

/// Two unit masses, a soft spring to the wall and a stiff one between them.
struct StiffChain {
  static constexpr std::size_t dimension = 4;
  static constexpr bool velocity_dependent = false;
  static constexpr double k1 = 1, k2 = 1e4;

  void acceleration(double, const double* q, const double*, double* a) const {
    const double pull = k2 * (q[1] - q[0]);
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

}  // namespace

/// A fast vibration of small amplitude superposed on a slow one.
std::vector<Case> stiff_chain() {
  Case c;
  c.id = "stiff_chain2_k1e4";
  c.title = "Two masses and a stiff spring";
  c.equation = "x1'' = -x1 + 1e4 (x2 - x1), x2'' = -1e4 (x2 - x1), x(0) = (1, 1.001) at rest";
  c.source = "two-mass chain, any mechanics text";
  c.tags = {"linear",     "autonomous",  "second_order", "separable",
            "mechanical", "oscillatory", "stiff"};
  c.y0 = {1, 1.001, 0, 0};
  c.stops = {0.1, 1};
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 200;
  c.settings.finest_steps = 12800;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth("stiff_chain2_k1e4", 1.1e-14);
  set_stage(c, StiffChain{});
  return {c};
}

}  // namespace odeum::cases
