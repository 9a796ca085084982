// SPDX-License-Identifier: BSD-3-Clause
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>

#include "bench/peers/peers.hpp"
#include "odeum/solvers/first_step.hpp"

namespace odeum::peers {
namespace {

int rhs(double t, const double y[], double dydt[], void* data) {
  return static_cast<Counted*>(data)->rhs(t, y, dydt) ? GSL_SUCCESS : GSL_EBADFUNC;
}

int jacobian(double t, const double y[], double* dfdy, double dfdt[], void* data) {
  const OdeView& ode = static_cast<Counted*>(data)->view;
  ode.jacobian(ode.problem, t, y, dfdy);
  std::fill(dfdt, dfdt + ode.dimension, 0.0);  // the cases are autonomous
  return GSL_SUCCESS;
}

double rule(const Case& c, double tolerance, int order) {
  GuardedView problem(c.problem.view, {});
  return first_step(problem, c.t0, c.y0, c.stops.back(), order, tolerance);
}

/// order: of the rule for the first step; 0: a ten thousandth of the span.
Alternative driver(const gsl_odeiv2_step_type* stepper, const char* setting, int order,
                   double a_dydt, bool taken) {
  return {setting, taken,
          [stepper, order, a_dydt](const Case& c, double tolerance, Counted& counted) {
            gsl_set_error_handler_off();
            Run run{.y = c.y0};
            const gsl_odeiv2_system system = {rhs, jacobian, run.y.size(), &counted};
            const double h = order ? rule(c, tolerance, order) : 1e-4 * (c.stops.back() - c.t0);
            gsl_odeiv2_driver* const d = gsl_odeiv2_driver_alloc_standard_new(
                &system, stepper, h, tolerance, tolerance, 1, a_dydt);
            double t = c.t0;
            int error = GSL_SUCCESS;
            for (std::size_t k = 0; k < c.stops.size() && error == GSL_SUCCESS; ++k) {
              error = gsl_odeiv2_driver_apply(d, &t, c.stops[k], run.y.data());
              run.steps += static_cast<long>(d->n);
            }
            gsl_odeiv2_driver_free(d);
            run.ok = error == GSL_SUCCESS;
            return run;
          }};
}

Choice first_step_and_control(const char* name, const gsl_odeiv2_step_type* stepper, int order,
                              bool smooth = false, bool slope = false) {
  return {
      std::string("GSL, ") + name,
      "first step and error level",
      "GSL 2.7 reference manual, Ordinary Differential Equations. Adaptive Step-size Control: the "
      "error level is abs + rel (a_y |y| + a_dydt h |y'|), without a recommended choice; Driver: "
      "the "
      "user gives the first step; Examples: the driver has the level of y alone (a_y = 1, a_dydt = "
      "0) and the first step is 1e-6.",
      {driver(stepper, "first step 1e-4 of the span", 0, 0, false),
       driver(stepper, "first step by the rule", order, 0, !slope),
       driver(stepper, "first step by the rule, a_dydt = 1", order, 1, slope)},
      smooth};
}

Choice explicit_choice(const char* name, const gsl_odeiv2_step_type* stepper, int order) {
  return first_step_and_control(name, stepper, order, true, true);
}

}  // namespace

std::vector<Choice> gsl_choices() {
  return {first_step_and_control("msbdf", gsl_odeiv2_step_msbdf, 1),
          first_step_and_control("bsimp", gsl_odeiv2_step_bsimp, 6),
          first_step_and_control("rk4imp", gsl_odeiv2_step_rk4imp, 4),
          explicit_choice("rk2", gsl_odeiv2_step_rk2, 2),
          explicit_choice("rk4", gsl_odeiv2_step_rk4, 4),
          explicit_choice("rkf45", gsl_odeiv2_step_rkf45, 5),
          explicit_choice("rkck", gsl_odeiv2_step_rkck, 5),
          explicit_choice("rk8pd", gsl_odeiv2_step_rk8pd, 8),
          first_step_and_control("msadams", gsl_odeiv2_step_msadams, 1, true)};
}

}  // namespace odeum::peers
