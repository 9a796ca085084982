// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// The Belousov-Zhabotinsky reaction in three unknowns.
struct Oregonator {
  static constexpr std::size_t dimension = 3;
  double s = 77.27, q = 8.375e-6, w = 0.161;

  template <class R>
  void rhs(R, const R* y, R* f) const {
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

Case make_case(const Values& values) {
  Case c;
  c.id = "oregonator";
  c.title = "Oregonator";
  c.equation =
      "y1' = s (y2 + y1 (1 - q y1 - y2)), y2' = (y3 - (1 + y1) y2) / s, y3' = w (y1 - y3), y(0) = "
      "(1, 2, 3)";
  c.source =
      "Field, Noyes, J. Chem. Phys. 60 (1974) 1877; Hairer, Wanner, Solving ODEs II, (IV.10.15)";
  c.tags = {"nonlinear", "autonomous", "stiff", "oscillatory", "chemistry"};
  c.y0 = {1, 2, 3};
  c.stops = {120, 240, 360};
  c.settings.no_fixed_steps = "a fixed step would have to resolve jumps of five decades throughout";
  c.settings.evaluation_budget = 60'000;
  c.truth = reference_truth("oregonator", 6e-13);
  set_stage(c, Oregonator{values[0], values[1], values[2]});
  return c;
}

}  // namespace

/// An oscillating chemical reaction whose components change by five decades.
std::vector<Case> oregonator() {
  return {with_tabled_parameters({{"s", 77.27, "ratio of rates"},
                                  {"q", 8.375e-6, "ratio of rates"},
                                  {"w", 0.161, "ratio of rates"}},
                                 make_case)};
}

}  // namespace odeum::cases
