// SPDX-License-Identifier: BSD-3-Clause
// GSL alone: rk4imp does not damp a fast component, and its error estimate does not see that.
// (a) y' = -1e6 (y - 1) from 1.001, ten fixed steps of 1: rk4imp and rk2imp stay where they began.
// (b) Robertson's reactions to t = 40: the distance of y2 from the root of y2' at the y1 and y3
// reached, relative to y2, is what rk4imp is off by; for rk1imp and msbdf it is small. How far it
// is depends on rounding, hence the largest of several tolerances.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

namespace {

constexpr double rate = 1e6;
int decay(double, const double* y, double* f, void*) {
  f[0] = -rate * (y[0] - 1);
  return GSL_SUCCESS;
}
int decay_jacobian(double, const double*, double* j, double* dfdt, void*) {
  j[0] = -rate;
  dfdt[0] = 0;
  return GSL_SUCCESS;
}

/// What is left of the initial distance from 1.
double left(const gsl_odeiv2_step_type* type) {
  const gsl_odeiv2_system system = {decay, decay_jacobian, 1, nullptr};
  gsl_odeiv2_driver* const driver = gsl_odeiv2_driver_alloc_y_new(&system, type, 1, 1e-12, 1e-12);
  double t = 0, y = 1.001;
  for (int i = 0; i < 10; ++i)
    gsl_odeiv2_evolve_apply_fixed_step(driver->e, nullptr, driver->s, &system, &t, 1, &y);
  gsl_odeiv2_driver_free(driver);
  return (y - 1) / 0.001;
}

constexpr double k1 = 0.04, k2 = 3e7, k3 = 1e4;
int reactions(double, const double* y, double* f, void*) {
  f[0] = -k1 * y[0] + k3 * y[1] * y[2];
  f[2] = k2 * y[1] * y[1];
  f[1] = -f[0] - f[2];
  return GSL_SUCCESS;
}
int reactions_jacobian(double, const double* y, double* j, double* dfdt, void*) {
  const double rows[9] = {-k1,        k3 * y[2], k3 * y[1],     k1, -k3 * y[2] - 2 * k2 * y[1],
                          -k3 * y[1], 0,         2 * k2 * y[1], 0};
  for (int i = 0; i < 9; ++i) j[i] = rows[i];
  for (int i = 0; i < 3; ++i) dfdt[i] = 0;
  return GSL_SUCCESS;
}

/// The relative distance of y2 from the root of y2' = k1 y1 - k3 y3 y2 - k2 y2^2.
double off(const gsl_odeiv2_step_type* type, double tolerance) {
  const double exact_y2 = 9.185534764557338e-6;
  const double scales[3] = {1e-4, 1e-10, 1e-2};
  const gsl_odeiv2_system system = {reactions, reactions_jacobian, 3, nullptr};
  gsl_odeiv2_driver* const driver =
      gsl_odeiv2_driver_alloc_scaled_new(&system, type, 1e-5, tolerance, tolerance, 1, 0, scales);
  double t = 0, y[3] = {1, 0, 0};
  const int error = gsl_odeiv2_driver_apply(driver, &t, 40, y);
  gsl_odeiv2_driver_free(driver);
  const double b = k3 * y[2], root = 2 * k1 * y[0] / (b + std::sqrt(b * b + 4 * k1 * k2 * y[0]));
  std::printf("  %-8s %.0e: status %d, y2 off by %.1e, from the root of y2' by %.1e\n",
              (*type).name, tolerance, error, y[1] / exact_y2 - 1, y[1] / root - 1);
  return error ? 0 : std::abs(y[1] / root - 1);
}

}  // namespace

int main() {
  gsl_set_error_handler_off();
  const double by_4 = left(gsl_odeiv2_step_rk4imp), by_2 = left(gsl_odeiv2_step_rk2imp),
               by_1 = left(gsl_odeiv2_step_rk1imp);
  std::printf("(a) left of the distance: rk4imp %.4f, rk2imp %.4f, rk1imp %.1e\n(b)\n", by_4, by_2,
              by_1);
  bool holds = by_4 > 0.99 && by_2 > 0.99 && std::abs(by_1) < 1e-6;
  double farthest = 0;
  for (const double tolerance : {1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5}) {
    farthest = std::fmax(farthest, off(gsl_odeiv2_step_rk4imp, tolerance));
    holds = off(gsl_odeiv2_step_rk1imp, tolerance) < 1e-3 && holds;
    holds = off(gsl_odeiv2_step_msbdf, tolerance) < 1e-3 && holds;
  }
  return holds && farthest > 1e-3 ? 0 : 1;
}
