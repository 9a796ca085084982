// SPDX-License-Identifier: BSD-3-Clause
// Questions and bug reports of others, and equations that were published.
#include "why/made_failures.hpp"

namespace odeum::tests {

using enum why::Cause;

std::vector<MadeFailure> brought_failures() {
  return {
      // Questions and bug reports of others; their ends by closed forms, mpmath and SciPy at 1e-12.
      {.name = "levels_with_a_switch",
       .text = "states: {x1: 0, x2: 0, x3: 0, x4: 0}\n"
               "definitions: {on: 'if(t > 1, 1, 0)'}\n"
               "equations:\n  x1: 1e9 + 5e4*x3 - 50*x1\n  x2: 40*x1 - 3.3e3*x2\n"
               "  x3: 2e3*x2 - 5e4*x3 + 3.5e7*on*x4\n  x4: 1e3*x2 - on*5e7*x4\ntime: {end: 2}\n",
       .solver = "odeum/rodas4",
       .causes = {kink},
       .also = {accuracy, stability},
       .end = {57894747.958, 701754.5214, 37894.7442, 14.03509043}},
      {.name = "channel_with_a_late_pulse",
       .text = "states: {n: 0}\ndefinitions: {cc: 'if(t > 5, if(t < 6, 1, 0), 0)'}\n"
               "equations: {n: 'cc*(1 - n) - n'}\ntime: {end: 10}\n",
       .solver = "odeum/verner65",
       .causes = {pulse},
       .also = {kink, accuracy},
       .end = {0.0079184}},
      {.name = "friction_on_a_shaken_table",
       .text = "states: {x: 0, v: 10}\n"
               "equations: {x: v, v: '(2*pi)^2*sin(2*pi*t) - 2*sign(v)'}\ntime: {end: 10}\n",
       .solver = "odeum/dormand_prince54",
       .causes = {kink},
       .also = {accuracy, sliding},  // from t = 5, for a hundredth
       .end = {74.31808248, -4.24945898}},
      {.name = "box_with_friction",
       .text = "states: {v: 10}\nequations: {v: -sign(v)*9.8*0.3}\ntime: {end: 4}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-4,
       .causes = {sliding},
       .also = {accuracy}},
      {.name = "growth_beside_a_switch",
       .text = "states: {x: 1, y: 0}\nequations: {x: x*(y + 1), y: 'if(y > 0.5, -0.01, 1)'}\n"
               "time: {end: 0.52}\n",
       .solver = "cvode/bdf",
       .causes = {sliding},
       .also = {accuracy}},
      {.name = "mass_that_comes_to_rest",
       .text = "states: {x: 1, v: 0}\nequations: {x: v, v: -100*x - 10*sign(v)}\n"
               "time: {end: 1.6}\n",
       .solver = "cvode/bdf",
       .relative = 1e-4,
       .causes = {sliding},
       .also = {accuracy}},
      {.name = "oscillator_of_quality_100",
       .text = "states: {X: 1, P: 0}\nequations: {X: P, P: -P/100 - X}\ntime: {end: 500}\n",
       .solver = "odeum/explicit_euler",
       .step = 0.0125,
       .causes = {stability}},
      {.name = "saddle",
       .text = "states: {y: 1, z: -10}\nequations: {y: z, z: 100*y}\ntime: {end: 4}\n",
       .solver = "odeum/dormand_prince54",
       .causes = {amplification},
       .also = {accuracy, astray},
       .end = {4.248354255e-18, -4.248354255e-17}},
      {.name = "decay_at_a_swinging_temperature",
       .text = "states: {y: 4}\ndefinitions: {T: 5*cos(2*t) + 50}\n"
               "equations: {y: -50*exp(-500/T)*y}\ntime: {end: 30}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-3,
       .absolute = {1e-6},
       .causes = {aliasing},
       .also = {accuracy},
       .end = {3.68671253}},
      {.name = "pulse_of_gauss",  // its end is a closed form
       .text = "states: {x: 0}\nequations: {x: -x + 100*exp(-((t-50)/0.05)^2)}\ntime: {end: 52}\n",
       .solver = "odeum/dormand_prince54",
       .causes = {pulse},
       .also = {accuracy, stability},
       .end = {1.2001275650577}},
      {.name = "bolus_after_forty",
       .text = "states: {c: 0, d: 0}\n"
               "equations: {c: 'if(t > 40, if(t < 40.2, 5, 0), 0) - 0.3*c', d: 0.3*c - 0.1*d}\n"
               "time: {end: 48}\n",
       .solver = "cvode/adams",
       .causes = {pulse},
       .also = {accuracy, kink},
       .end = {0.093494749016, 0.540536415562}},
      // Clocks that are states: no solver is told the times; their ends by closed forms.
      {.name = "infusion_that_a_clock_starts",
       .text =
           "states: {clock: 0, gut: 0, blood: 0}\n"
           "equations: {clock: 1, gut: 'if(clock > 30, if(clock < 30.25, 40, 0), 0) - 1.2*gut', "
           "blood: 1.2*gut - 0.1*blood}\ntime: {end: 36}\n",
       .solver = "cvode/bdf",
       .absolute = {1e-8},
       .causes = {pulse},
       .also = {accuracy, kink},
       .end = {36, 0.00870665402239, 6.05300337944}},
      {.name = "doses_by_a_clock",
       .text = "states: {clock: 0.5, c: 0}\n"
               "equations: {clock: 1, c: 'if(mod(clock, 3) < 1, 4, 0) - 0.4*c'}\n"
               "time: {end: 8}\n",
       .solver = "odeum/dormand_prince853",
       .relative = 1e-9,
       .causes = {kink},
       .also = {accuracy},
       .end = {8.5, 2.44452789171}},
      {.name = "enzyme_in_moles",
       .text = "states: {s: 1e-6, c: 0, p: 0}\n"
               "equations: {s: -1e6*(1e-8 - c)*s + 0.1*c, c: 1e6*(1e-8 - c)*s - 0.6*c, p: 0.5*c}\n"
               "time: {end: 100}\n",
       .solver = "odeum/dormand_prince54",
       .absolute = {1e-6},
       .causes = {absolute},
       .also = {accuracy, stability, astray},
       .end = {7.04352304186e-07, 5.40727550543e-09, 2.90240420309e-07}},
      {.name = "cubic_damper_in_three_steps",
       .text = "states: {v: 100}\nequations: {v: -v^3}\ntime: {end: 2}\n",
       .solver = "odeum/explicit_euler",
       .step = 0.01,
       .causes = {stability},
       .end = {0.499993750117}},
      {.name = "logistic_growth_in_short_steps",
       .text = "states: {n: 0.1}\nequations: {n: n*(1 - n)}\ntime: {end: 20}\n",
       .solver = "odeum/rk4",
       .step = 2e-4,
       .causes = {too_fine}},
      {.name = "relay_on_a_line",
       .text = "states: {x: 1, v: 0}\nequations: {x: v, v: -0.5*x - 2*sign(v + x)}\n"
               "time: {end: 1.5}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-4,
       .causes = {sliding},
       .also = {accuracy}},
      // A half wave does not jump at its ends; beside it the beam swings as fast as the wave does.
      {.name = "hammer_on_a_beam",
       .text = "states: {s: 0, x: 0.01, v: 0}\n"
               "equations: {s: 1, x: v, v: 'if(s > 20 and s < 20.05, 40*sin(pi*(s - 20)/0.05), 0) "
               "- 2.4*v - 144*x'}\ntime: {end: 20.6}\n",
       .solver = "cvode/adams",
       .relative = 1e-5,
       .absolute = {1e-5},
       .causes = {pulse},
       .also = {accuracy, kink, stability},
       .end = {20.6, 0.02909144900505612, 0.4946454630064883}},
      // A component below its tolerance is off before the pulse, and does not hide it.
      {.name = "trace_beside_a_pulse",
       .text = "states: {c: 0, x: 0, y: 1}\n"
               "equations: {c: 1, x: 1e-8*y - 3*x, y: -y/20 + 2*exp(-((c - 41)/0.02)^2)}\n"
               "time: {end: 45}\n",
       .solver = "odeum/dormand_prince54",
       .relative = 1e-4,
       .absolute = {1e-5},
       .causes = {pulse, absolute},
       .also = {accuracy, stability},
       .end = {45, 5.540815475347763e-10, 0.16344573811935442}},
      // The looser run, which the others are compared with, ends in values that are not finite.
      {.name = "diode_clamp",
       .text = "states: {v: 0, w: 0}\n"
               "equations: {v: (5*sin(3*t) - v)/0.01 - 0.01*(exp(v/0.052) - 1), w: v - w}\n"
               "time: {end: 6}\n",
       .solver = "gsl/rkf45",
       .relative = 1e-5,
       .absolute = {1e-5},
       .causes = {stability},
       .also = {accuracy},
       .end = {-3.8504182736492196, -2.248605667631061}},
      // Equal steps: as long as a period, one inside of which the equations change, beyond the edge
      // where f bends back, and ones that damp or feed an energy over many periods.
      {.name = "hum_of_one_period_a_step",
       .text = "states: {x: 0}\nequations: {x: -x + cos(100*pi*t)}\ntime: {end: 4}\n",
       .solver = "odeum/rk4",
       .step = 0.02,
       .causes = {aliasing},
       .also = {too_coarse},
       .end = {9.94644136460036e-06}},
      {.name = "infusion_that_ends_inside_a_step",
       .text = "states: {a: 1, b: 0}\n"
               "equations: {a: 'if(t < 3.333, 2, 0) - 0.7*a', b: 0.7*a - 3*b}\ntime: {end: 4}\n",
       .solver = "odeum/rk4",
       .step = 0.25,
       .causes = {kink},
       .end = {1.6783321167129448, 0.4833642206247015}},
      {.name = "enzyme_cycle_beyond_the_edge",
       .text = "states: {x: 0.1}\nequations: {x: 2*(1 - x)/(1.002 - x) - x/(0.002 + x)}\n"
               "time: {end: 4}\n",
       .solver = "odeum/explicit_euler",
       .step = 0.01,
       .causes = {stability},
       .end = {0.9980079839683196}},
      {.name = "orbits_that_are_damped",
       .text = "states: {x: 0.7, y: 0, u: 0, v: 1.3627702877384937}\n"
               "equations: {x: u, y: v, u: -x/(x^2 + y^2)^1.5, v: -y/(x^2 + y^2)^1.5}\n"
               "time: {end: 600}\n",
       .solver = "odeum/rk4",
       .step = 0.1,
       .causes = {energy},
       .end = {-1.2994220887855021, 0.03242674483437319, -0.026151537815516254,
               -0.7334731342164219}},
      {.name = "burst_of_neutrons",  // n has begun to rise before half of its height
       .text = "states: {n: 1e-2, c: 8.125e-2}\n"
               "equations: {n: -1.65*n + 0.08*c + 400*exp(-((t - 350)/0.05)^2), "
               "c: 0.65*n - 0.08*c}\ntime: {end: 352}\n",
       .solver = "odeum/radau_iia_variable",
       .relative = 1e-5,
       .absolute = {1e-5},
       .causes = {pulse},
       .also = {accuracy},
       .end = {1.8429010643771464, 12.327210168192448}},
      {.name = "virions_from_a_few",
       .text = "states: {T: 1, I: 0, V: 1e-9}\n"
               "equations: {T: -50*T*V, I: 50*T*V - 0.5*I, V: 1.2*I - 3*V}\ntime: {end: 6}\n",
       .solver = "odeum/tsitouras54",
       .relative = 1e-5,
       .absolute = {1e-6},
       .causes = {absolute},
       .also = {accuracy, stability, amplification},
       .end = {4.5159641853706725e-13, 0.24116506229876722, 0.11564460188484209}},
      {.name = "bucket_that_overflows",
       .text = "states: {S: 0}\nequations: {S: '2 + sin(t) - 3*max(S - 1, 0) - 0.1*S'}\n"
               "time: {end: 2}\n",
       .solver = "odeum/rk4",
       .step = 0.125,
       .causes = {kink},
       .end = {1.9122549902496437}},
      {.name = "a_start_below_the_rounding_of_t",  // c = sqrt(1 + 2e50 (t - 1))
       .text = "states: {c: 1}\nequations: {c: 1e50/c}\ntime: {start: 1, end: 2}\n",
       .solver = "odeum/rodas4",
       .causes = {rounding},
       .also = {accuracy},
       .end = {1.4142135623730951e25}},
      {.name = "current_that_fires_a_neuron",
       .text = "states: {clock: 0, v: -1.1994, w: -0.6243}\n"
               "equations: {clock: 1, v: v - v^3/3 - w + 8*exp(-((clock - 150)/0.06)^2), "
               "w: 0.08*(v + 0.7 - 0.8*w)}\ntime: {end: 165}\n",
       .solver = "odeum/dormand_prince853",
       .relative = 1e-5,
       .absolute = {1e-5},
       .causes = {pulse},
       .also = {accuracy, stability},
       .end = {165, -2.0208778838105466, 0.7380272981736005}},
      {.name = "relay_altitude",
       .text = "states: {h: -2, v: 0}\n"
               "equations: {h: v, v: '-sign(h + 1.5*v) - 0.2*v'}\n"
               "time: {end: 7}\n",
       .solver = "cvode/bdf",
       .relative = 1e-5,
       .absolute = {1e-5},
       .causes = {sliding},
       .also = {accuracy},
       .end = {-0.028140380165051736, 0.018760253443367826}},
  };
}

}  // namespace odeum::tests
