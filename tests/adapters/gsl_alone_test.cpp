// SPDX-License-Identifier: BSD-3-Clause
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "adapters/alone.hpp"

namespace odeum::test::gsl_alone_test {
namespace {

int rhs(double t, const double y[], double dydt[], void* view) {
  const auto& ode = *static_cast<const OdeView*>(view);
  ode.rhs(ode.problem, t, y, dydt);
  return GSL_SUCCESS;
}

int jacobian(double t, const double y[], double* dfdy, double dfdt[], void* view) {
  const auto& ode = *static_cast<const OdeView*>(view);
  ode.jacobian(ode.problem, t, y, dfdy);
  std::fill(dfdt, dfdt + ode.dimension, 0.0);  // the hard cases are autonomous
  return GSL_SUCCESS;
}

/// The manual's example, with a first step of 1e-6.
Program driver(const gsl_odeiv2_step_type* stepper) {
  return [stepper](const Case& c, double tolerance, std::vector<double>& y) {
    gsl_set_error_handler_off();
    OdeView view = c.problem.view;
    const gsl_odeiv2_system system = {rhs, jacobian, y.size(), &view};
    gsl_odeiv2_driver* const d =
        gsl_odeiv2_driver_alloc_y_new(&system, stepper, 1e-6, tolerance, tolerance);
    gsl_odeiv2_driver_set_nmax(d, 10'000);
    double t = c.t0;
    int error = GSL_SUCCESS;
    for (std::size_t k = 0; k < c.stops.size() && error == GSL_SUCCESS; ++k)
      error = gsl_odeiv2_driver_apply(d, &t, c.stops[k], y.data());
    gsl_odeiv2_driver_free(d);
    return error == GSL_SUCCESS;
  };
}

TEST(GslAlone, MsbdfFailsNowhereElse) {
  expect_no_worse_than_alone("gsl/msbdf", driver(gsl_odeiv2_step_msbdf));
}
TEST(GslAlone, BsimpFailsNowhereElse) {
  expect_no_worse_than_alone("gsl/bsimp", driver(gsl_odeiv2_step_bsimp));
}
TEST(GslAlone, EachHardCaseIsSolved) { expect_each_case_solved("gsl"); }

}  // namespace
}  // namespace odeum::test::gsl_alone_test
