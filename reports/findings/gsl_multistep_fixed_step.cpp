// SPDX-License-Identifier: BSD-3-Clause
// GSL odeiv2 alone: msadams and msbdf at a fixed step of 1/256 on y' = -y, for several tolerances
// of the driver that they ask for. Exits 0 while their result at the same step depends on the
// tolerance: msadams fails at a tight one, msbdf falls back from order 2 or more to 1.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <cstdio>

int rhs(double, const double y[], double dydt[], void*) {
  dydt[0] = -y[0];
  return GSL_SUCCESS;
}
int jacobian(double, const double[], double* dfdy, double dfdt[], void*) {
  dfdy[0] = -1;
  dfdt[0] = 0;
  return GSL_SUCCESS;
}
const gsl_odeiv2_system problem = {rhs, jacobian, 1, nullptr};

/// The order in use after a unit of time; 0 where the stepper failed.
unsigned order_after(const gsl_odeiv2_step_type* type, double tolerance) {
  gsl_odeiv2_driver* driver =
      gsl_odeiv2_driver_alloc_y_new(&problem, type, 1.0 / 256, tolerance, tolerance);
  double y = 1, t = 0;
  int status = GSL_SUCCESS;
  for (int i = 0; i < 256 && status == GSL_SUCCESS; ++i)
    status = gsl_odeiv2_evolve_apply_fixed_step(driver->e, nullptr, driver->s, &problem, &t,
                                                1.0 / 256, &y);
  const unsigned order = status == GSL_SUCCESS ? gsl_odeiv2_step_order(driver->s) : 0;
  std::printf("%-8s tolerance %.0e: order %u, error %.1e\n", gsl_odeiv2_step_name(driver->s),
              tolerance, order, std::abs(y - std::exp(-t)));
  gsl_odeiv2_driver_free(driver);
  return order;
}

int main() {
  gsl_set_error_handler_off();
  const unsigned adams_loose = order_after(gsl_odeiv2_step_msadams, 1e-4),
                 adams_tight = order_after(gsl_odeiv2_step_msadams, 1e-13),
                 bdf_loose = order_after(gsl_odeiv2_step_msbdf, 1e-4),
                 bdf_tight = order_after(gsl_odeiv2_step_msbdf, 1e-13);
  return adams_loose > 1 && adams_tight == 0 && bdf_loose > 1 && bdf_tight == 1 ? 0 : 1;
}
