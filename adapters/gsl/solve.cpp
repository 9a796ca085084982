// SPDX-License-Identifier: BSD-3-Clause
#include <gsl/gsl_errno.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "gsl/method.hpp"
#include "odeum/solvers/dense_jacobian.hpp"
#include "odeum/solvers/first_step.hpp"

namespace odeum::adapters::gsl {
namespace {

/// At a fixed step there is no error control, but the Newton iteration of the implicit steppers
/// takes its tolerance from the driver's control object: this value, relative and absolute. With a
/// larger one the iteration of the second half step stops after one iteration, which is a floor of
/// rk4imp (at 1e-13: errors of 1e-9 where the method has 1e-13, reports/findings/gsl.md); a smaller
/// one is below rounding and fails.
constexpr double newton_tolerance = 1e-15;

/// The problem as passed to the library's callbacks.
struct Problem {
  Problem(const OdeView& view, const Request& request)
      : guarded(view, request.budget, &request.tolerance), jacobian(guarded) {}

  GuardedView guarded;
  DenseJacobian jacobian;
};

/// GSL_EBADFUNC ends a run at once; any other failure halves the step.
int rhs(double t, const double y[], double dydt[], void* problem) {
  return static_cast<Problem*>(problem)->guarded.rhs(t, y, dydt) == 0 ? GSL_SUCCESS : GSL_EBADFUNC;
}

int jacobian(double t, const double y[], double* dfdy, double dfdt[], void* problem) {
  auto& p = *static_cast<Problem*>(problem);
  p.guarded.time_derivative(t, y, dfdt);
  return p.jacobian(t, y, dfdy) == 0 ? GSL_SUCCESS : GSL_EBADFUNC;
}

using Driver = std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)>;

/// Null where the library refuses.
Driver make_driver(const Method& method, const gsl_odeiv2_system& system, double first_step,
                   const Tolerance& tolerance) {
  const double relative = tolerance.relative, a_y = 1;
  if (tolerance.thresholds.size() <= 1)
    return {
        gsl_odeiv2_driver_alloc_standard_new(&system, *method.type, first_step,
                                             tolerance.absolute(0), relative, a_y, method.a_dydt()),
        gsl_odeiv2_driver_free};
  // The absolute tolerance of component i is its first number times the scale i, which is copied.
  return {gsl_odeiv2_driver_alloc_scaled_new(&system, *method.type, first_step, relative, relative,
                                             a_y, method.a_dydt(), tolerance.thresholds.data()),
          gsl_odeiv2_driver_free};
}

const char* name_of(int error) {
  switch (error) {
    case GSL_FAILURE:
      return "GSL_FAILURE";
    case GSL_EFAULT:
      return "GSL_EFAULT";
    case GSL_EINVAL:
      return "GSL_EINVAL";
    case GSL_ESANITY:
      return "GSL_ESANITY";
    case GSL_EBADFUNC:
      return "GSL_EBADFUNC";
    case GSL_EMAXITER:
      return "GSL_EMAXITER";
    case GSL_EUNDRFLW:
      return "GSL_EUNDRFLW";
    case GSL_ESING:
      return "GSL_ESING";
    case GSL_EDOM:
      return "GSL_EDOM";
    case GSL_ENOPROG:
      return "GSL_ENOPROG";
    default:
      return "another error";
  }
}

/// `meaning`: what GSL_FAILURE stands for there, since the library's own word for it is "failure".
void fail(Outcome& outcome, Status status, const char* name, int error, double t,
          const char* meaning) {
  outcome.status = status;
  outcome.t = t;
  outcome.detail = fmt::format("{} returned {} ({}) at t = {}", name, name_of(error),
                               error == GSL_FAILURE ? meaning : gsl_strerror(error), t);
}

/// bsimp returns success with an infinite error estimate where a sub-step diverged, so that a
/// controller shortens the step; its result is not a valid step.
bool ran_away(const gsl_odeiv2_driver& driver) {
  for (std::size_t i = 0; i < driver.sys->dimension; ++i)
    if (std::isinf(driver.e->yerr[i])) return true;
  return false;
}

void walk_fixed(const Method& method, gsl_odeiv2_driver& driver, double t0, const Request& request,
                std::vector<double>& y, Outcome& outcome) {
  const FixedGrid grid(t0, request);
  std::uint64_t& i = outcome.counters.steps;
  for (std::size_t stop = 0; stop < grid.stop_count(); ++stop) {
    for (const std::uint64_t end = grid.index_of(stop); i < end; ++i) {
      double t = grid.t(i);
      // Without a control object a step is accepted for any error estimate.
      const int error = gsl_odeiv2_evolve_apply_fixed_step(driver.e, nullptr, driver.s, driver.sys,
                                                           &t, grid.h(), y.data());
      if (error != GSL_SUCCESS)
        return fail(outcome, Status::newton_failed, method.name, error, grid.t(i),
                    "the stepper's iteration does not converge at this step");
      if (method.kind == Kind::extrapolation && ran_away(driver)) {
        outcome.status = Status::newton_failed;
        outcome.t = grid.t(i);
        outcome.detail = fmt::format(
            "{} failed the step at t = {}: a substep diverged, and it set the "
            "error estimate to infinity",
            method.name, grid.t(i));
        return;
      }
      if (!is_finite(y.data(), y.size())) return outcome.record(grid.t(i), y.data(), y.size());
    }
    outcome.record(request.stops[stop], y.data(), y.size());
  }
}

/// gsl_odeiv2_driver_apply, which takes as many calls of the evolution as steps, with their ends.
int step_to(gsl_odeiv2_driver& driver, double& t, double stop, std::vector<double>& y,
            Outcome& outcome) {
  driver.n = 0;
  while (t < stop) {
    const int error = gsl_odeiv2_evolve_apply(driver.e, driver.c, driver.s, driver.sys, &t, stop,
                                              &driver.h, y.data());
    if (error != GSL_SUCCESS) return error;
    if (driver.n > driver.nmax) return GSL_EMAXITER;
    ++driver.n;
    outcome.step_ends.push_back(t);
  }
  return GSL_SUCCESS;
}

void walk_adaptive(const Method& method, gsl_odeiv2_driver& driver, double t,
                   const Request& request, std::vector<double>& y, Outcome& outcome) {
  for (const double stop : request.stops) {
    const int error = request.record_steps ? step_to(driver, t, stop, y, outcome)
                                           : gsl_odeiv2_driver_apply(&driver, &t, stop, y.data());
    outcome.counters.steps += driver.n;  // of this call, accepted
    outcome.counters.rejected_steps = driver.e->failed_steps;
    if (error != GSL_SUCCESS)
      return fail(outcome, error == GSL_EMAXITER ? Status::over_budget : Status::step_too_small,
                  method.name, error, t,
                  "its error or iteration failed down to steps at the rounding of t");
    outcome.record(stop, y.data(), y.size());
  }
}

}  // namespace

Outcome solve(const Method& method, const ErasedContest& contest, const Request& request) {
  const std::size_t n = contest.view.dimension;
  if (n == 0) return refused("the library has no vectors of length 0");
  if (method.needs_jacobian() && n > dense_dimension_limit) return dense_over_budget(n);

  const bool fixed = request.mode == Mode::fixed;
  if (fixed && method.multistep())
    return refused(fmt::format(
        "{} chooses its order from a tolerance; at a fixed step it stays at order 1 or 2, "
        "or its corrector fails, depending on the tolerance",
        method.name));

  Problem problem(contest.view, request);
  const gsl_odeiv2_system system = {rhs, jacobian, n, &problem};
  const Tolerance tolerance = fixed ? Tolerance(newton_tolerance) : request.tolerance;
  const double first = fixed ? FixedGrid(contest.t0, request).h()
                             : first_step(problem.guarded, contest.t0, *contest.y0,
                                          request.stops.back(), method.first_order(), tolerance);

  const Driver driver = make_driver(method, system, first, tolerance);
  if (!driver) return refused(fmt::format("gsl_odeiv2_driver gave no driver for {}", method.name));
  Outcome outcome;
  std::vector<double> y = *contest.y0;
  if (fixed) {
    walk_fixed(method, *driver, contest.t0, request, y, outcome);
  } else {
    // Each step evaluates at least once, so that the guard's budget is reached before this.
    gsl_odeiv2_driver_set_nmax(driver.get(), request.budget.evaluations);
    walk_adaptive(method, *driver, contest.t0, request, y, outcome);
  }
  problem.guarded.guard().conclude(request, outcome);
  return outcome;
}

}  // namespace odeum::adapters::gsl
