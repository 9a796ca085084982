// SPDX-License-Identifier: BSD-3-Clause
// Runs with one cause, and all that are made.
#include "why/made_failures.hpp"

namespace odeum::tests {

using enum why::Cause;

namespace {

std::vector<MadeFailure> failures_of_one_cause() {
  const std::string robertson =
      "states: {a: 1, b: 0, c: 0}\n"
      "equations: {a: -0.04*a + 1e4*b*c, b: 0.04*a - 1e4*b*c - 3e7*b^2, c: 3e7*b^2}\n"
      "time: {end: 4}\n";
  const std::string van_der_pol =
      "states: {y: 2, v: 0}\nequations: {y: v, v: 1000*((1 - y^2)*v) - y}\ntime: {end: 20}\n";
  const std::string spring =
      "states: {q: 1, v: 0}\nequations: {q: v, v: -100*q}\ntime: {end: 10}\n";
  return {
      // An eigenvalue that the solution does not show.
      {.name = "robertson_dp54",
       .text = robertson,
       .solver = "odeum/dormand_prince54",
       .causes = {stability}},
      {.name = "van_der_pol_gsl",
       .text = van_der_pol,
       .solver = "gsl/rkf45",
       .causes = {stability}},
      {.name = "robertson_adams",
       .text = robertson,
       .solver = "cvode/adams",
       .causes = {stability}},
      {.name = "van_der_pol_dp54",
       .text = van_der_pol,
       .solver = "odeum/dormand_prince54",
       .causes = {stability}},
      {.name = "van_der_pol_odeint",
       .text = van_der_pol,
       .solver = "odeint/runge_kutta_dopri5",
       .causes = {stability}},
      {.name = "robertson_to_a_loose_tolerance",
       .text = robertson,
       .solver = "odeum/dormand_prince54",
       .relative = 1e-5,
       .absolute = {1e-5},
       .causes = {astray},
       .also = {stability, accuracy}},
      {.name = "decay_to_a_slow_curve",
       .text = "states: {x: 1, y: 1}\nequations: {x: -x, y: -1e4*(y - x^2)}\ntime: {end: 5}\n",
       .solver = "odeum/tsitouras54",
       .causes = {stability}},
      {.name = "fast_rotation_at_rest",
       .text =
           "states: {x: 1, p: 1, q: 0}\nequations: {x: -x, p: -1e3*q - 100*p, q: 1e3*p - 100*q}\n"
           "time: {end: 5}\n",
       .solver = "odeum/dormand_prince853",
       .causes = {stability},
       .also = {accuracy}},
      {.name = "heat_line",
       .text = "parameters: {n: 20}\nstates: {u[1..n]: sin(pi*i/(n + 1))}\n"
               "equations: {u[1..n]: 441*(u[i-1] - 2*u[i] + u[i+1])}\nboundaries: {u[0]: 0, "
               "u[n+1]: 0}\n"
               "time: {end: 2}\n",
       .solver = "odeum/verner65",
       .relative = 1e-3,
       .absolute = {1e-3},
       .causes = {stability}},
      // The error test.
      {.name = "circle",
       .text = "states: {x: 1, y: 0}\nequations: {x: -y, y: x}\ntime: {end: 200}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-9,
       .causes = {accuracy}},
      // Besides, errors of 1e-9 grow e^18-fold.
      {.name = "lorenz",
       .text = "states: {x: 1, y: 1, z: 20}\n"
               "equations: {x: 10*(y - x), y: x*(28 - z) - y, z: x*y - 8/3*z}\ntime: {end: 20}\n",
       .solver = "gsl/rkf45",
       .relative = 1e-9,
       .causes = {accuracy, astray},
       .also = {amplification}},
      {.name = "chirp_bdf",
       .text = "states: {x: 0}\nequations: {x: cos(t^2)*t}\ntime: {end: 20}\n",
       .solver = "cvode/bdf",
       .causes = {accuracy}},
      {.name = "euler_to_a_tight_tolerance",
       .text = "states: {x: 1}\nequations: {x: -x}\ntime: {end: 2}\n",
       .solver = "odeum/implicit_euler",
       .relative = 1e-7,
       .causes = {accuracy}},
      // Corners and jumps.
      {.name = "bounce",
       .text = "states: {y: 1, v: 0}\nequations: {y: v, v: 'if(y > 0, -1, -1000*y - 1)'}\ntime: "
               "{end: 3}\n",
       .solver = "odeum/dormand_prince853",
       .relative = 1e-9,
       .causes = {kink},
       .also = {accuracy}},
      {.name = "switch",
       .text = "states: {x: 0}\nequations: {x: 'if(t > 1.2345, 1, 0) - x'}\ntime: {end: 2}\n",
       .solver = "odeum/dormand_prince853",
       .relative = 1e-9,
       .causes = {kink},
       .also = {accuracy}},
      {.name = "rectifier",
       .text = "states: {x: 0}\nequations: {x: abs(sin(t)) - x}\ntime: {end: 10}\n",
       .solver = "odeum/verner98",
       .relative = 1e-10,
       .causes = {kink},
       .also = {accuracy}},
      {.name = "friction",
       .text = "states: {q: 0, v: 1}\nequations: {q: v, v: -0.3*sign(v) - q}\ntime: {end: 1.6}\n",
       .solver = "odeum/radau_iia5",
       .relative = 1e-9,
       .causes = {kink},
       .also = {accuracy}},
      {.name = "pulses",
       .text = "states: {x: 0}\nequations: {x: 'if(sin(60*t) > 0, 30, -30) - x'}\n"
               "time: {end: 4}\n",
       .solver = "odeum/dormand_prince54",
       .causes = {kink},
       .also = {accuracy}},
      // It stays at a jump, to which both sides lead.
      {.name = "thermostat",
       .text = "states: {T: 15}\nequations: {T: '-0.1*(T - 5) + if(T < 20, 2.5, 0)'}\n"
               "time: {end: 20}\n",
       .solver = "odeum/radau_iia5",
       .relative = 1e-4,
       .causes = {sliding},
       .also = {accuracy}},
      {.name = "friction_that_holds",
       .text = "states: {q: 0, v: 1}\nequations: {q: v, v: 0.2 - q - 3*sign(v)}\ntime: {end: 3}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-5,
       .causes = {sliding},
       .also = {accuracy}},
      // Errors of steps grow a thousandfold.
      {.name = "arenstorf",
       .text = "parameters: {m: 0.012277471}\n"
               "states: {x: 0.994, y: 0, u: 0, v: -2.001585106379082}\n"
               "equations:\n  x: u\n  y: v\n"
               "  u: x + 2*v - (1 - m)*(x + m)/((x + m)^2 + y^2)^1.5 - "
               "m*(x - 1 + m)/((x - 1 + m)^2 + y^2)^1.5\n"
               "  v: y - 2*u - (1 - m)*y/((x + m)^2 + y^2)^1.5 - m*y/((x - 1 + m)^2 + y^2)^1.5\n"
               "time: {end: 17.06521656}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-3,
       .absolute = {1e-3},
       .causes = {amplification},
       .also = {accuracy, astray}},
      // The solution ends.
      {.name = "square",
       .text = "states: {y: 1}\nequations: {y: y^2}\ntime: {end: 2}\n",
       .solver = "odeum/dormand_prince54",
       .causes = {pole},
       .also = {accuracy}},
      {.name = "square_radau",
       .text = "states: {y: 1}\nequations: {y: y^2}\ntime: {end: 2}\n",
       .solver = "odeum/radau_iia5",
       .causes = {pole},
       .also = {accuracy}},
      {.name = "square_fixed",
       .text = "states: {y: 1}\nequations: {y: y^2}\ntime: {end: 2}\n",
       .solver = "odeum/rk4",
       .step = 0.01,
       .causes = {pole}},
      {.name = "tangent_gsl",
       .text = "states: {y: 0}\nequations: {y: 1 + y^2}\ntime: {end: 2}\n",
       .solver = "gsl/rk8pd",
       .causes = {pole},
       .also = {accuracy}},
      {.name = "collapse",
       .text = "states: {y: 1}\nequations: {y: -1/y}\ntime: {end: 2}\n",
       .solver = "odeum/dormand_prince54",
       .causes = {singular},
       .also = {accuracy}},
      {.name = "growth",
       .text = "states: {y: 1}\nequations: {y: 100*y}\ntime: {end: 10}\n",
       .solver = "odeum/dormand_prince54",
       .causes = {growth},
       .also = {accuracy}},
      // States at which f is not defined.
      {.name = "root_of_a_negative",
       .text = "states: {c: 1}\nequations: {c: -sqrt(c) - 0.1}\ntime: {end: 5}\n",
       .solver = "odeum/dormand_prince54",
       .causes = {domain},
       .also = {accuracy, singular}},
      {.name = "log_of_a_concentration",
       .text =
           "states: {c: 1, d: 0}\nequations: {c: -c*(2 + log(c)) - 0.2, d: c}\ntime: {end: 10}\n",
       .solver = "odeum/tsitouras54",
       .causes = {domain},
       .also = {accuracy}},
      {.name = "root_of_time",
       .text = "states: {y: 0}\nequations: {y: sqrt(1 - t)}\ntime: {end: 2}\n",
       .solver = "odeum/verner65",
       .causes = {domain},
       .also = {accuracy, kink}},
      // Settings.
      {.name = "tolerance_below_rounding",
       .text = "states: {x: 1, y: 0}\nequations: {x: -y, y: x}\ntime: {end: 20}\n",
       .solver = "odeum/dormand_prince853",
       .relative = 3e-16,
       .absolute = {1e-20},
       .causes = {rounding},
       .also = {accuracy}},
      {.name = "absolute_above_a_concentration",
       .text = "states: {a: 0, b: 1}\nequations: {a: b*1e-8*cos(40*t), b: -b}\ntime: {end: 3}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-3,
       .absolute = {1e-6},
       .causes = {absolute},
       .also = {accuracy}},
      {.name = "wrong_jacobian_rodas",
       .text = "states: {x: 1, y: 1}\nequations: {x: -x, y: -1e3*(y - x^2)}\ntime: {end: 5}\n",
       .solver = "odeum/rodas4",
       .causes = {wrong_jacobian},
       .also = {accuracy, stability},
       .wrong_jacobian = 0.3},
      {.name = "wrong_jacobian_that_no_step_asks_for",
       .text = "states: {x: 1, y: 0}\nequations: {x: -y, y: x}\ntime: {end: 20}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-8,
       .causes = {accuracy},
       .wrong_jacobian = 5},
      {.name = "wrong_jacobian_bdf",
       .text = "states: {x: 1, y: 1}\nequations: {x: -x, y: -1e3*(y - x^2)}\ntime: {end: 5}\n",
       .solver = "cvode/bdf",
       .causes = {wrong_jacobian},
       .also = {accuracy, stability, newton},
       .wrong_jacobian = -1},
      // Fixed steps.
      {.name = "spring_explicit_euler",
       .text = spring,
       .solver = "odeum/explicit_euler",
       .step = 0.01,
       .causes = {energy}},
      {.name = "spring_implicit_euler",
       .text = spring,
       .solver = "odeum/implicit_euler",
       .step = 0.01,
       .causes = {energy}},
      {.name = "spring_rk4_too_long",
       .text = spring,
       .solver = "odeum/rk4",
       .step = 0.4,
       .causes = {stability},
       .also = {energy}},
      {.name = "spring_verlet_too_long",
       .text = spring,
       .solver = "odeum/velocity_verlet",
       .step = 0.25,
       .causes = {stability},
       .also = {energy}},
      {.name = "decay_euler_too_long",
       .text = "states: {y: 1}\nequations: {y: -50*(y - cos(t))}\ntime: {end: 10}\n",
       .solver = "odeum/explicit_euler",
       .step = 0.05,
       .causes = {stability}},
      {.name = "advection_too_long",  // all eigenvalues are -30, which is not a bound here
       .text = "parameters: {n: 30}\nstates: {u[1..n]: exp(-(i - 10)^2/8)}\n"
               "equations: {u[1..n]: -30*(u[i] - u[i-1])}\nboundaries: {u[0]: 0}\n"
               "time: {end: 3}\n",
       .solver = "odeum/heun",
       .step = 0.05,
       .causes = {stability}},
      {.name = "decay_ab4_too_long",
       .text = "states: {y: 1}\nequations: {y: -50*(y - cos(t))}\ntime: {end: 10}\n",
       .solver = "odeum/adams_bashforth4",
       .step = 0.02,
       .causes = {stability}},
      {.name = "too_coarse",
       .text = "states: {x: 0}\nequations: {x: cos(30*t)}\ntime: {end: 0.8}\n",
       .solver = "odeum/heun",
       .step = 0.1,
       .causes = {too_coarse}},
  };
}

}  // namespace

const std::vector<MadeFailure>& made_failures() {
  static const std::vector<MadeFailure> all = [] {
    std::vector<MadeFailure> each = failures_of_one_cause();
    for (const auto& more : {brought_failures(), failures_of_two_causes()})
      each.insert(each.end(), more.begin(), more.end());
    return each;
  }();
  return all;
}

}  // namespace odeum::tests
