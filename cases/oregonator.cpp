// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

/// The Belousov-Zhabotinsky reaction in three unknowns.
struct Oregonator {
  static constexpr std::size_t dimension = 3;
  static constexpr double s = 77.27, q = 8.375e-6, w = 0.161;

  void rhs(double, const double* y, double* f) const {
    f[0] = s * (y[1] + y[0] * (1 - q * y[0] - y[1]));
    f[1] = (y[2] - (1 + y[0]) * y[1]) / s;
    f[2] = w * (y[0] - y[2]);
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = s * (1 - 2 * q * y[0] - y[1]);
    j[1] = s * (1 - y[0]);
    j[2] = 0;
    j[3] = -y[1] / s;
    j[4] = -(1 + y[0]) / s;
    j[5] = 1 / s;
    j[6] = w;
    j[7] = 0;
    j[8] = -w;
  }
};

}  // namespace

/// An oscillating chemical reaction whose components change by five decades.
std::vector<Case> oregonator() {
  Case c;
  c.id = "oregonator";
  c.title = "Oregonator";
  c.equation =
      "y1' = 77.27 (y2 + y1 (1 - 8.375e-6 y1 - y2)), y2' = (y3 - (1 + y1) y2) / 77.27, y3' = 0.161 "
      "(y1 - y3), y(0) = (1, 2, 3)";
  c.source =
      "Field, Noyes, J. Chem. Phys. 60 (1974) 1877; Hairer, Wanner, Solving ODEs II, (IV.10.15)";
  c.tags = {"nonlinear", "autonomous", "stiff", "oscillatory", "chemistry"};
  c.y0 = {1, 2, 3};
  c.stops = {120, 240, 360};
  c.settings.no_fixed_steps = "a fixed step would have to resolve jumps of five decades throughout";
  c.settings.evaluation_budget = 60'000;
  c.truth = reference_truth("oregonator", 6e-13);
  set_stage(c, Oregonator{});
  return {c};
}

}  // namespace odeum::cases
