// SPDX-License-Identifier: BSD-3-Clause
// GSL alone: gsl_odeiv2_driver_apply from t = 0 to 1 where the right-hand side is NaN after t =
// 0.5. Exits 0 while the explicit Runge-Kutta steppers and bsimp answer GSL_SUCCESS with y = NaN.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <limits>

namespace {

double factor(double t) { return t > 0.5 ? std::numeric_limits<double>::quiet_NaN() : -1; }

int rhs(double t, const double y[], double dydt[], void*) {
  dydt[0] = factor(t) * y[0];
  return GSL_SUCCESS;
}

int jacobian(double t, const double*, double* dfdy, double* dfdt, void*) {
  dfdy[0] = factor(t);
  dfdt[0] = 0;
  return GSL_SUCCESS;
}

}  // namespace

int main() {
  gsl_set_error_handler_off();
  bool stands = true;
  for (const gsl_odeiv2_step_type* stepper :
       {gsl_odeiv2_step_rk2, gsl_odeiv2_step_rk4, gsl_odeiv2_step_rkf45, gsl_odeiv2_step_rkck,
        gsl_odeiv2_step_rk8pd, gsl_odeiv2_step_bsimp}) {
    const gsl_odeiv2_system system = {rhs, jacobian, 1, nullptr};
    gsl_odeiv2_driver* const driver =
        gsl_odeiv2_driver_alloc_y_new(&system, stepper, 1e-3, 1e-6, 1e-6);
    double t = 0, y = 1;
    const int error = gsl_odeiv2_driver_apply(driver, &t, 1, &y);
    std::printf("%-6s %s at t = %g with y = %g\n", stepper->name, gsl_strerror(error), t, y);
    stands = stands && error == GSL_SUCCESS && t == 1 && std::isnan(y);
    gsl_odeiv2_driver_free(driver);
  }
  return stands ? 0 : 1;
}
