# SPDX-License-Identifier: BSD-3-Clause
"""For a lecture: three steppers of students, of which one is wrong, at four steps each. Their orders are measured, and what is
wrong is named."""
import numpy as np

import odeum


def spring(t, y):
    return np.array([y[1], -4 * y[0]])


def stepped(step, h, end=5.0):
    """The states at all times, from (1, 0)."""
    count = round(end / h)
    states = [np.array([1.0, 0.0])]
    for k in range(count):
        states.append(step(k * h, states[-1], h))
    return np.linspace(0, end, count + 1), np.array(states)


def euler(t, y, h):
    return y + h * spring(t, y)


def symplectic_euler(t, y, h):
    v = y[1] - 4 * h * y[0]
    return np.array([y[0] + h * v, v])


def rk4_with_wrong_weights(t, y, h):
    k1 = spring(t, y)
    k2 = spring(t + h / 2, y + h / 2 * k1)
    k3 = spring(t + h / 2, y + h / 2 * k2)
    k4 = spring(t + h, y + h * k3)
    return y + h / 4 * (k1 + k2 + k3 + k4)


problem = odeum.problem(spring, [1.0, 0.0], (0, 5))
for stepper, claim in ((euler, "explicit_euler"), (symplectic_euler, "symplectic_euler"), (rk4_with_wrong_weights, "rk4")):
    judged = odeum.judge(problem, {h: stepped(stepper, h) for h in (0.02, 0.01, 0.005, 0.0025)}, claims=claim)
    print(f"{stepper.__name__}: {judged.verdict}, order {judged.measured_order:.2f}. {judged.reason}")
    assert (judged.verdict == "confirmed") == (claim != "rk4"), judged
