# SPDX-License-Identifier: BSD-3-Clause
"""Which integrator has an error of 1e-6 in the least time, for a function as solve_ivp takes it?"""
import numpy as np

import odeum


def pendulum(t, y, g, length):
    angle, rate = y
    return [rate, -g / length * np.sin(angle) - 0.1 * rate]


start, span, numbers = [1.0, 0.0], (0, 10), (9.81, 1.5)
print(odeum.text_of(pendulum, start, span, args=numbers, names=["angle", "rate"]))
advice = odeum.advise(pendulum, start, span, error=1e-6, seconds=3, args=numbers)
print(f"{advice.solver} with {advice.setting_kind} {advice.setting:.3g}: error {advice.error:.1e} in {advice.time_ns / 1e3:.1f} us")
for row in advice.runners_up:
    print(f"{row['ratio']:6.2f} times the time: {row['solver']}, {row['why']}")
assert advice.error <= 1e-6

report = odeum.why(pendulum, start, span, solver="rk4", step=0.1, args=numbers)
print(report["summary"])
assert report["status"] == "ok"
