// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// x' = s (y - x), y' = x (r - z) - y, z' = x y - b z.
struct Lorenz {
  static constexpr std::size_t dimension = 3;
  double s = 10, r = 28, b = 8.0 / 3;

  template <class R>
  void rhs(R, const R* y, R* f) const {
    f[0] = s * (y[1] - y[0]);
    f[1] = y[0] * (r - y[2]) - y[1];
    f[2] = y[0] * y[1] - b * y[2];
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = -s;
    j[1] = s;
    j[2] = 0;
    j[3] = r - y[2];
    j[4] = -1;
    j[5] = -y[0];
    j[6] = y[1];
    j[7] = y[0];
    j[8] = -b;
  }
  void taylor(double, const double* y, int order, double* c) const {
    std::copy_n(y, 3, c);
    for (int k = 0; k < order; ++k) {
      double xy = 0, xz = 0;  // products of series
      for (int j = 0; j <= k; ++j) {
        xy += c[3 * j] * c[3 * (k - j) + 1];
        xz += c[3 * j] * c[3 * (k - j) + 2];
      }
      const double* const now = c + 3 * k;
      double* const next = c + 3 * (k + 1);
      next[0] = s * (now[1] - now[0]) / (k + 1);
      next[1] = (r * now[0] - xz - now[1]) / (k + 1);
      next[2] = (xy - b * now[2]) / (k + 1);
    }
  }
};

Case make_case(const Values& values) {
  const Lorenz problem{values[0], values[1], values[2]};
  Case c;
  c.id = "lorenz_kehlet_logg";
  c.title = "Lorenz's attractor";
  c.equation = "x' = s (y - x), y' = x (r - z) - y, z' = x y - b z";
  c.source = "Lorenz 1963; Kehlet, Logg, arXiv:1306.2782";
  c.tags = {"nonlinear", "autonomous", "chaotic"};
  c.y0 = {values[3], values[4], values[5]};
  c.stops = {10};
  c.settings.coarsest_steps = 512;
  c.settings.finest_steps = 16384;
  c.settings.evaluation_budget = 80'000;
  c.truth = reference_truth("lorenz_kehlet_logg", 6.9e-15);
  // A denser reference for the horizons of the drift study, computed here; a test compares it with
  // the published one.
  c.truth.at = [sparse = c.truth.at, dense = reference_truth("lorenz_dense", 6.9e-15).at](
                   double t, double* y) { return sparse(t, y) || dense(t, y); };
  c.components = {"x", "y", "z"};
  set_stage(c, problem);
  return c;
}

}  // namespace

/// Chaotic: errors grow as exp(0.9 t). Double precision resolves the solution to t = 10; by t = 50
/// the rounding of the parameters alone has decorrelated it.
std::vector<Case> lorenz() {
  return {with_tabled_parameters({{"s", 10, "Prandtl number"},
                                  {"r", 28, "Rayleigh number over its critical value"},
                                  {"b", 8.0 / 3, "shape of the cell"},
                                  {"x0", 1, "x at the start"},
                                  {"y0", 0, "y at the start"},
                                  {"z0", 0, "z at the start"}},
                                 make_case)};
}

}  // namespace odeum::cases
