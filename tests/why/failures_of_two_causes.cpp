// SPDX-License-Identifier: BSD-3-Clause
// Runs with two causes at once; their ends by closed forms and SciPy at 1e-12.
#include "why/made_failures.hpp"

namespace odeum::tests {

using enum why::Cause;

std::vector<MadeFailure> failures_of_two_causes() {
  return {
      {.name = "rotor_that_slows_beside_a_filter",
       .text =
           "states: {c: 0, p: 1, q: 0, r: 0, s: 0}\n"
           "equations: {c: 1, p: -30*q*exp(-t), q: 30*p*exp(-t), r: 'if(c > 1.37, 0, 1)*2 - r', "
           "s: 400*(r - s)}\ntime: {end: 6}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-8,
       .absolute = {1e-8},
       .causes = {stability, accuracy},
       .also = {kink},
       .end = {6.000000000000001, 0.08042028700683158, -0.996761043299075, 0.014552013851288539,
               0.014588485063963276}},
      {.name = "stiff_then_pole",
       .text = "states: {x: 1, y: 1}\nequations: {x: x^2, y: -1e4*(y - cos(t))}\ntime: {end: 2}\n",
       .solver = "odeum/dormand_prince54",
       .causes = {pole, stability},
       .also = {accuracy}},
      {.name = "stiff_with_a_switch",
       .text = "states: {x: 1, y: 0}\n"
               "equations: {x: -x, y: '-300*(y - x) + if(t > 0.7, 100, 0)'}\ntime: {end: 1}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-8,
       .causes = {stability, kink},
       .also = {accuracy}},
      {.name = "heater_with_a_fast_sensor",
       .text = "states: {heat: 0, sensor: 0}\n"
               "equations: {heat: '-heat + if(t > 1.3, 40, 0)', sensor: -500*(sensor - heat)}\n"
               "time: {end: 3}\n",
       .solver = "odeum/tsitouras54",
       .relative = 1e-9,
       .causes = {stability, kink},
       .also = {accuracy}},
      {.name = "absolute_and_a_switch",
       .text = "states: {a: 0, b: 0}\nequations: {a: 1e-8*cos(40*t), b: 'if(t > 1.6, 1, 0) - "
               "b'}\ntime: {end: 3}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-4,
       .absolute = {1e-6},
       .causes = {absolute, kink},
       .also = {accuracy}},
      {.name = "circle_then_stiff",
       .text =
           "states: {x: 1, y: 0, z: 0}\n"
           "equations: {x: -40*y*exp(-t), y: 40*x*exp(-t), z: -100*t*(z - x)}\ntime: {end: 20}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-9,
       .causes = {accuracy, stability}},
      {.name = "stiff_then_square_root_of_a_negative",
       .text = "states: {c: 1, y: 1}\nequations: {c: -sqrt(c) - 0.1, y: -1e4*(y - c)}\n"
               "time: {end: 5}\n",
       .solver = "odeum/tsitouras54",
       .causes = {domain, stability},
       .also = {accuracy}},
      {.name = "switch_then_pole",
       .text = "states: {x: 0, y: 0.5}\n"
               "equations: {x: 'if(t > 0.3, 5, 0) - x', y: y^2}\ntime: {end: 3}\n",
       .solver = "odeum/verner65",
       .relative = 1e-9,
       .causes = {kink, pole},
       .also = {accuracy}},
      {.name = "wrong_jacobian_and_a_switch",
       .text = "states: {x: 1, y: 1}\n"
               "equations: {x: -x, y: '-1e3*(y - x^2) + if(t > 1, 300, 0)'}\ntime: {end: 2}\n",
       .solver = "odeum/rodas4",
       .causes = {wrong_jacobian, kink},
       .also = {accuracy, stability},
       .wrong_jacobian = 0.7},
      {.name = "wrong_jacobian_then_pole",
       .text = "states: {x: 1, y: 1}\nequations: {x: x^2, y: -1e3*(y - cos(t))}\ntime: {end: 2}\n",
       .solver = "cvode/bdf",
       .causes = {wrong_jacobian, pole},
       .also = {accuracy, stability},
       .wrong_jacobian = 3},
      {.name = "absolute_and_stiff_at_the_end",
       .text = "states: {a: 0, b: 1}\n"
               "equations: {a: 1e-8*cos(40*t)*(1 - tanh(20*(t - 2)))/2, b: -t^8*10*(b - cos(t))}\n"
               "time: {end: 3}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-4,
       .absolute = {1e-6},
       .causes = {absolute, stability},
       .also = {accuracy}},
      {.name = "absolute_and_wrong_jacobian",
       .text = "states: {a: 0, b: 1}\nequations: {a: 1e-8*cos(40*t), b: -b}\ntime: {end: 3}\n",
       .solver = "odeum/radau_iia5",
       .relative = 1e-4,
       .absolute = {1e-6},
       .causes = {absolute, wrong_jacobian},
       .also = {accuracy},
       .wrong_jacobian = 40},
      {.name = "energy_of_one_stability_of_another",
       .text = "states: {q: 1, v: 0, y: 1}\nequations: {q: v, v: -q, y: -90*(y - q)}\n"
               "time: {end: 20}\n",
       .solver = "odeum/explicit_euler",
       .step = 0.025,
       .causes = {energy, stability}},
      {.name = "rounding_and_a_switch",
       .text = "states: {x: 1, y: 0}\nequations: {x: -y, y: 'x + if(t > 3, 1, 0)'}\n"
               "time: {end: 6}\n",
       .solver = "odeum/dormand_prince853",
       .relative = 4e-16,
       .absolute = {1e-20},
       .causes = {rounding, kink},
       .also = {accuracy}},
      {.name = "bounces_of_a_fast_circle",
       .text = "states: {x: 1, y: 0, z: 0}\nequations: {x: -30*y, y: 30*x, z: abs(y) - z}\n"
               "time: {end: 3}\n",
       .solver = "odeum/verner98",
       .relative = 1e-9,
       .causes = {kink, accuracy}},
      {.name = "accuracy_then_pole",
       .text = "states: {x: 1, y: 0, z: 1}\nequations: {x: -50*y, y: 50*x, z: z^2}\n"
               "time: {end: 2}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-8,
       .causes = {accuracy, pole}},
      {.name = "accuracy_then_log_of_a_negative",
       .text = "states: {x: 1, y: 0, c: 1}\n"
               "equations: {x: -50*y, y: 50*x, c: -1 - 0.001*sqrt(c)}\ntime: {end: 2}\n",
       .solver = "gsl/rk8pd",
       .relative = 1e-8,
       .causes = {accuracy, domain}},
      {.name = "heat_with_a_switch",
       .text = "parameters: {n: 20}\nstates: {u[1..n]: sin(pi*i/(n + 1))}\n"
               "equations: {u[1..n]: '441*(u[i-1] - 2*u[i] + u[i+1]) + if(t > 0.05, 50, 0)'}\n"
               "boundaries: {u[0]: 0, u[n+1]: 0}\ntime: {end: 0.1}\n",
       .solver = "odeint/runge_kutta_dopri5",
       .relative = 1e-6,
       .causes = {stability, kink},
       .also = {accuracy}},
      {.name = "growth_beside_a_fast_decay",
       .text = "states: {x: 1, z: 0}\nequations: {x: 100*x, z: -1e4*(z - 1)}\ntime: {end: 10}\n",
       .solver = "odeum/dormand_prince54",
       .causes = {growth, stability},
       .also = {accuracy}},
      {.name = "square_root_of_a_negative_and_a_switch",
       .text = "states: {c: 1, x: 0}\n"
               "equations: {c: -sqrt(c) - 0.1, x: 'if(t > 0.5, 1, 0) - x'}\ntime: {end: 5}\n",
       .solver = "odeum/dormand_prince853",
       .relative = 1e-9,
       .causes = {domain, kink},
       .also = {accuracy}},
      {.name = "pole_to_rounding",
       .text = "states: {y: 1}\nequations: {y: y^2}\ntime: {end: 2}\n",
       .solver = "odeum/verner98",
       .relative = 4e-16,
       .absolute = {1e-20},
       .causes = {pole, rounding},
       .also = {accuracy}},
      {.name = "chapman_moles",
       .text = "parameters: {k1: 2.5e-3, k2: 5e-1, k3: 3e3, k4: 4e-1, M: 1.3, A: 8.6}\n"
               "states: {O: 0, O3: 1e-7}\n"
               "equations:\n"
               "  O: 2*1e-9*k1*A + k4*O3 - k2*M*A*O*20 - k3*O*O3\n"
               "  O3: k2*M*A*O*20 - k4*O3 - k3*O*O3\n"
               "time: {end: 2000}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-5,
       .absolute = {1e-6},
       .causes = {stability, absolute},
       .also = {accuracy, astray},
       .end = {6.602941744879136e-10, 1.844460119118312e-07}},
      {.name = "pulse_and_too_fine",
       .text = "states: {clock: 0, c: 1}\n"
               "equations: {clock: 1, c: '-0.2*c + 900*exp(-((clock - 3.0025)/0.0004)^2)'}\n"
               "time: {end: 6}\n",
       .solver = "odeum/rk4",
       .step = 0.01,
       .causes = {pulse, too_fine},
       .also = {kink},
       .end = {5.9999999999999964, 0.6515569372573762}},
      {.name = "lorenz84_loose",
       .text = "parameters: {a: 0.25, b: 4, F: 8, G: 1}\n"
               "states: {x: 1, y: 1, z: 0}\n"
               "equations:\n"
               "  x: -y^2 - z^2 - a*x + a*F\n"
               "  y: x*y - b*x*z - y + G\n"
               "  z: b*x*y + x*z - z\n"
               "time: {end: 40}\n",
       .solver = "cvode/adams",
       .relative = 1e-4,
       .absolute = {1e-4},
       .causes = {amplification, accuracy},
       .also = {astray},
       .end = {1.1526033056106662, -0.2874572069596394, -0.7891482697677517}},
      {.name = "pulse_beside_stiff",
       .text = "parameters: {kon: 60, koff: 40, kd: 0.3}\n"
               "states: {clock: 0, s: 0.2, b: 0.12}\n"
               "equations:\n"
               "  clock: 1\n"
               "  s: '0.06 - kd*s + 800*exp(-((clock - 17.77)/0.0007)^2)'\n"
               "  b: kon*s*(1 - b) - koff*b\n"
               "time: {end: 25}\n",
       .solver = "odeum/bogacki_shampine32",
       .relative = 1e-4,
       .absolute = {1e-4},
       .causes = {stability, pulse},
       .also = {accuracy},
       .end = {24.999999999999968, 0.31344313949324704, 0.3202070791605287}},
      {.name = "hum_unstable_fixed",
       .text = "states: {T: 0}\n"
               "equations: {T: '-120*(T - 1) + 200*cos(100*pi*t)'}\n"
               "time: {end: 1}\n",
       .solver = "odeum/explicit_euler",
       .step = 0.02,
       .causes = {stability, aliasing},
       .also = {too_coarse},
       .end = {1.212209014115735}},
      {.name = "inverted_pendulum_tiny",
       .text = "parameters: {g: 9.81, l: 0.5}\n"
               "states: {th: 1e-6, w: 0}\n"
               "equations: {th: w, w: g/l*sin(th)}\n"
               "time: {end: 4}\n",
       .solver = "odeum/dormand_prince853",
       .relative = 1e-4,
       .absolute = {1e-4},
       .causes = {absolute, amplification},
       .also = {accuracy, astray},
       .end = {5.642454454834947, 2.7897845117888975}},
      {.name = "thermal_runaway_stiff_wall",
       .text = "parameters: {d: 1}\n"
               "states: {th: 0, wall: 0}\n"
               "equations: {th: d*exp(th) - 0.2*th, wall: 5000*(0.3*sin(3*t) - wall)}\n"
               "time: {end: 3}\n",
       .solver = "odeum/dormand_prince54",
       .absolute = {1e-6},
       .causes = {pole, stability},
       .also = {accuracy}},
      {.name = "diode_bridge_stiff",
       .text = "parameters: {R: 10, C: 1e-2, Rd: 0.01}\n"
               "states: {v: 0}\n"
               "equations: {v: 'if(sin(2*pi*t) > v, (sin(2*pi*t) - v)/Rd, 0)/C - v/(R*C)'}\n"
               "time: {end: 3}\n",
       .solver = "odeum/tsitouras54",
       .relative = 1e-7,
       .absolute = {1e-7},
       .causes = {stability, kink},
       .also = {accuracy},
       .end = {0.001467919280876531}},
      {.name = "planet_and_thermal_node",
       .text = "states: {x: 1, y: 0, u: 0, v: 1, T: 1}\n"
               "equations: {x: u, y: v, u: -x/(x^2 + y^2)^1.5, v: -y/(x^2 + y^2)^1.5, T: -220*(T - "
               "x)}\n"
               "time: {end: 6}\n",
       .solver = "odeum/explicit_euler",
       .step = 0.01,
       .causes = {too_coarse, stability},
       .end = {0.9601702868006875, -0.27941549491240864, 0.2794154952336744, 0.9601702879374472,
               0.9588804047891499}},
      {.name = "iodine_xenon_moles",
       .text = "states: {Te: 2e-6, I: 0, Xe: 0}\n"
               "equations: {Te: -0.3*Te, I: 0.3*Te - 400*I, Xe: 400*I - 0.02*Xe}\n"
               "time: {end: 30}\n",
       .solver = "cvode/adams",
       .relative = 1e-5,
       .absolute = {1e-8},
       .causes = {stability, absolute},
       .also = {accuracy, astray},
       .end = {2.4681960847787595e-10, 1.8525364659335197e-13, 1.1758190906075677e-06}},
      {.name = "clutch_and_filter",
       .text = "states: {w1: 10, w2: 0, p: 0}\n"
               "equations:\n"
               "  w1: '2 - 6*sign(w1 - w2)'\n"
               "  w2: '4*sign(w1 - w2) - 0.5*w2'\n"
               "  p: 900*(w1 - p)\n"
               "time: {end: 3}\n",
       .solver = "odeum/tsitouras54",
       .relative = 1e-4,
       .absolute = {1e-4},
       .causes = {sliding, stability},
       .also = {accuracy},
       .end = {3.6017285248499897, 3.6017285248499897, 3.6020403160664562}},
  };
}

}  // namespace odeum::tests
