// SPDX-License-Identifier: BSD-3-Clause
#include <boost/numeric/odeint/integrate/integrate_times.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/extrapolation_stepper.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "bench/peers/odeint_stiff.hpp"
#include "bench/peers/peers.hpp"
#include "odeum/solvers/first_step.hpp"

namespace odeum::peers {
namespace {

namespace od = boost::numeric::odeint;
using Y = std::vector<double>;

struct TooMany {};

/// The first step: of the rule for a method of that order; 0: a ten thousandth of the span, -1:
/// 1e-4.
double first(const Case& c, double tolerance, int order) {
  if (order < 0) return 1e-4;
  if (order == 0) return 1e-4 * (c.stops.back() - c.t0);
  GuardedView problem(c.problem.view, {});
  return first_step(problem, c.t0, c.y0, c.stops.back(), order, tolerance);
}

/// make(absolute, relative): a controlled or dense-output stepper.
template <class Make>
Alternative explicit_run(const char* setting, bool taken, int order, double threshold, Make make) {
  return {setting, taken, [=](const Case& c, double tolerance, Counted& counted) {
            Run run{.y = c.y0};
            const auto system = [&](const Y& y, Y& dydt, double t) {
              if (!counted.rhs(t, y.data(), dydt.data())) throw TooMany();
            };
            Y times{c.t0};
            times.insert(times.end(), c.stops.begin(), c.stops.end());
            try {
              run.steps = static_cast<long>(od::integrate_times(
                  make(threshold * tolerance, tolerance), system, run.y, times.begin(), times.end(),
                  first(c, tolerance, order), [](const Y&, double) {}));
              run.ok = true;
            } catch (const TooMany&) {
            } catch (const std::exception&) {
            }
            return run;
          }};
}

Alternative rosenbrock(const char* setting, bool taken, int order, double threshold, bool dense) {
  return {setting, taken, [=](const Case& c, double tolerance, Counted& counted) {
            Run run{.y = c.y0};
            const RosenbrockSettings settings{threshold * tolerance, tolerance,
                                              first(c, tolerance, order), dense};
            run.steps = run_rosenbrock4(
                counted.view, c.t0, c.stops, settings,
                [&] { return ++counted.evaluations <= Counted::most_evaluations; }, run.y);
            run.ok = run.steps >= 0;
            return run;
          }};
}

template <class Stepper>
auto controlled() {
  return [](double absolute, double relative) {
    using Controlled = od::controlled_runge_kutta<Stepper>;  // extrapolation has no make_controlled
    return Controlled(typename Controlled::error_checker_type(absolute, relative));
  };
}

constexpr const char* documentation =
    "Headers of Boost 1.74 (controlled_runge_kutta.hpp, rosenbrock4_controller.hpp): the user "
    "gives "
    "the absolute and the relative tolerance and a first step. The error level is abs + rel (a_x "
    "|x| "
    "+ a_dxdt |h x'|), both weights 1 by default; rosenbrock4's is abs + rel |x|.";

}  // namespace

std::vector<Choice> odeint_choices() {
  using Dopri5 = od::runge_kutta_dopri5<Y>;
  const auto without_slope = [](double absolute, double relative) {
    using Controlled = od::controlled_runge_kutta<Dopri5>;
    return Controlled(Controlled::error_checker_type(absolute, relative, 1, 0));
  };
  const auto dense = [](double absolute, double relative) {
    return od::make_dense_output<Dopri5>(absolute, relative);
  };
  const auto bulirsch = [](double absolute, double relative) {
    return od::bulirsch_stoer<Y>(absolute, relative);
  };
  return {{"odeint, rosenbrock4",
           "first step, absolute tolerance, dense output",
           documentation,
           {rosenbrock("first step 1e-4 of the span", false, 0, 1, false),
            rosenbrock("first step 1e-4", false, -1, 1, false),
            rosenbrock("first step by the rule", true, 4, 1, false),
            rosenbrock("the same, absolute tolerance a hundredth", false, 4, 0.01, false),
            rosenbrock("dense output, first step by the rule", true, 4, 1, true)}},
          {"odeint, runge_kutta_dopri5",
           "error level, first step, dense output",
           documentation,
           {explicit_run("first step 1e-4 of the span", false, 0, 1, controlled<Dopri5>()),
            explicit_run("first step by the rule", true, 4, 1, controlled<Dopri5>()),
            explicit_run("the same, a_dxdt = 0", false, 4, 1, without_slope),
            explicit_run("the same, absolute tolerance a hundredth", false, 4, 0.01,
                         controlled<Dopri5>()),
            explicit_run("dense output, first step by the rule", true, 4, 1, dense)},
           true},
          {"odeint",
           "the explicit stepper",
           "Boost.Numeric.Odeint, odeint in detail, Steppers, table of stepper algorithms: "
           "runge_kutta_dopri5 is the standard method with error control and dense output, "
           "runge_kutta_fehlberg78 a good high order method with error estimation. "
           "extrapolation_stepper is in the headers alone.",
           {explicit_run("runge_kutta_dopri5", true, 4, 1, controlled<Dopri5>()),
            explicit_run("runge_kutta_fehlberg78", true, 7, 1,
                         controlled<od::runge_kutta_fehlberg78<Y>>()),
            explicit_run("extrapolation_stepper of order 8", true, 7, 1,
                         controlled<od::extrapolation_stepper<8, Y>>()),
            explicit_run("extrapolation_stepper of order 12", true, 11, 1,
                         controlled<od::extrapolation_stepper<12, Y>>()),
            explicit_run("bulirsch_stoer", true, 4, 1, bulirsch)},
           true}};
}

}  // namespace odeum::peers
