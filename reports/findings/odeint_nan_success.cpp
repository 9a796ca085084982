// SPDX-License-Identifier: BSD-3-Clause
// Boost.odeint alone: integrate_adaptive past where there is no solution. `missing`: a right-hand
// side that is NaN after t = 0.5, to t = 1. `pole`: y' = y^2 from y = 1, which ends at t = 1, to t
// = 2. Exits 0 while every controlled and dense stepper here returns at the end with y = NaN.
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer_dense_out.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace {

namespace od = boost::numeric::odeint;
using State = std::vector<double>;

template <class Stepper>
bool returns_nan(const char* name, Stepper stepper, bool pole) {
  const auto rhs = [pole](const State& y, State& dydt, double t) {
    if (pole)
      dydt[0] = y[0] * y[0];
    else
      dydt[0] = t > 0.5 ? std::numeric_limits<double>::quiet_NaN() : -y[0];
  };
  State y(1, 1.0);
  double reached = 0;
  const double end = pole ? 2 : 1;
  od::integrate_adaptive(stepper, rhs, y, 0.0, end, 1e-3,
                         [&reached](const State&, double t) { reached = t; });
  std::printf("%-24s %-7s returns at t = %g with y = %g\n", name, pole ? "pole" : "missing",
              reached, y[0]);
  return std::isnan(y[0]) && std::abs(reached - end) < 1e-9;
}

}  // namespace

int main() {
  bool stands = true;
  for (const bool pole : {false, true}) {
    const auto check = [&](const char* name, const auto& stepper) {
      stands = returns_nan(name, stepper, pole) && stands;
    };
    const double tolerance = 1e-6;
    check("cash_karp54",
          od::make_controlled<od::runge_kutta_cash_karp54<State>>(tolerance, tolerance));
    check("dopri5", od::make_controlled<od::runge_kutta_dopri5<State>>(tolerance, tolerance));
    check("fehlberg78",
          od::make_controlled<od::runge_kutta_fehlberg78<State>>(tolerance, tolerance));
    check("dopri5, dense",
          od::make_dense_output<od::runge_kutta_dopri5<State>>(tolerance, tolerance));
    check("bulirsch_stoer", od::bulirsch_stoer<State>(tolerance, tolerance));
    check("bulirsch_stoer_dense_out", od::bulirsch_stoer_dense_out<State>(tolerance, tolerance));
  }
  return stands ? 0 : 1;
}
