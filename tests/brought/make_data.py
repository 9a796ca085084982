#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the trajectories in data/: of SciPy's solvers, and of methods and mistakes as people write them by hand.

    make_data.py FOLDER

Nothing here comes from Odeum: each is a short program as a student or a user of SciPy writes it. The problem is a
damped oscillator, q'' = -q - 0.2 q', or a driven one; a folder a program, a file a step.
"""
import sys
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

OUT = Path(sys.argv[1])
END = 4.0
STEPS = [0.2, 0.1, 0.05]


def oscillator(t, y):
    return np.array([y[1], -y[0] - 0.2 * y[1]])


def driven(t, y):
    return np.array([y[1], -y[0] + np.sin(2 * t)])


def write(name, h, t, y, names, fmt="%.12g"):
    folder = OUT / name
    folder.mkdir(parents=True, exist_ok=True)
    np.savetxt(folder / f"{name}_h{h:g}.csv", np.column_stack([t, y]), delimiter=",", comments="", fmt=fmt,
               header="t," + ",".join(names))


def march(step, f, y0, h):
    n = round(END / h)
    t = np.arange(n + 1) * h
    y = [np.array(y0, dtype=float)]
    for k in range(n):
        y.append(step(f, t[k], y[-1].copy(), h))
    return t, np.array(y)


# Right ones.
def euler(f, t, y, h):
    return y + h * f(t, y)


def symplectic_euler(f, t, y, h):
    v = y[1] + h * f(t, y)[1]
    return np.array([y[0] + h * v, v])


def heun(f, t, y, h):
    k1 = f(t, y)
    return y + h / 2 * (k1 + f(t + h, y + h * k1))


def rk4(f, t, y, h):
    k1 = f(t, y)
    k2 = f(t + h / 2, y + h / 2 * k1)
    k3 = f(t + h / 2, y + h / 2 * k2)
    k4 = f(t + h, y + h * k3)
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


# Mistakes.
def rk4_k3_from_k1(f, t, y, h):
    k1 = f(t, y)
    k2 = f(t + h / 2, y + h / 2 * k1)
    k3 = f(t + h / 2, y + h / 2 * k1)
    k4 = f(t + h, y + h * k3)
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


def rk4_half_k4(f, t, y, h):
    k1 = f(t, y)
    k2 = f(t + h / 2, y + h / 2 * k1)
    k3 = f(t + h / 2, y + h / 2 * k2)
    k4 = f(t + h, y + h / 2 * k3)
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


def rk4_equal_weights(f, t, y, h):
    k1 = f(t, y)
    k2 = f(t + h / 2, y + h / 2 * k1)
    k3 = f(t + h / 2, y + h / 2 * k2)
    k4 = f(t + h, y + h * k3)
    return y + h * (k1 + k2 + k3 + k4) / 4


def rk4_frozen_time(f, t, y, h):
    k1 = f(t, y)
    k2 = f(t, y + h / 2 * k1)
    k3 = f(t, y + h / 2 * k2)
    k4 = f(t, y + h * k3)
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


def rk4_in_place(f, t, y, h):
    start = y  # not a copy
    k1 = f(t, y)
    y += h / 2 * k1
    k2 = f(t + h / 2, y)
    y += h / 2 * k2
    k3 = f(t + h / 2, y)
    y += h * k3
    k4 = f(t + h, y)
    return start + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


def rk4_by_component(f, t, y, h):
    new = y.copy()
    for i in range(len(y)):

        def g(x):
            z = y.copy()
            z[i] = x
            return f(t, z)[i]

        k1 = g(y[i])
        k2 = g(y[i] + h / 2 * k1)
        k3 = g(y[i] + h / 2 * k2)
        k4 = g(y[i] + h * k3)
        new[i] = y[i] + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return new


def verlet_old_acceleration(f, t, y, h):
    a = f(t, y)[1]
    return np.array([y[0] + h * y[1] + h * h / 2 * a, y[1] + h * a])


def heun_half_step(f, t, y, h):
    k1 = f(t, y)
    return y + h / 2 * (k1 + f(t + h / 2, y + h / 2 * k1))


def adams_bashforth(weights):
    def run(f, y0, h):
        n = round(END / h)
        t = np.arange(n + 1) * h
        y = [np.array(y0, dtype=float)]
        y.append(euler(f, 0, y[0], h))
        for k in range(1, n):
            y.append(y[-1] + h * (weights[0] * f(t[k], y[k]) + weights[1] * f(t[k - 1], y[k - 1])))
        return t, np.array(y)

    return run


def main():
    start, names = [1.0, 0.0], ["q", "v"]
    for h in STEPS:
        for method in ["RK23", "RK45", "DOP853", "Radau"]:
            found = solve_ivp(oscillator, (0, END), start, method=method, max_step=h, first_step=h, rtol=1, atol=1)
            write("scipy_" + method, h, found.t, found.y.T, names, "%.17g")
        for step in [euler, symplectic_euler, heun, rk4, rk4_k3_from_k1, rk4_half_k4, rk4_equal_weights, rk4_in_place,
                     rk4_by_component, verlet_old_acceleration, heun_half_step]:
            t, y = march(step, oscillator, start, h)
            write(step.__name__, h, t, y, names)
        t, y = march(rk4_frozen_time, driven, start, h)
        write("rk4_frozen_time", h, t, y, names)
        # The positions use the old velocity, where symplectic Euler was meant: explicit Euler.
        write("old_velocity", h, *march(euler, oscillator, start, h), names, "%.8f")
        # linspace with one time too few: the steps are END / n, the times END / (n - 1) apart.
        n = round(END / h)
        y = [np.array(start)]
        for k in range(n - 1):
            y.append(rk4(oscillator, 0, y[-1], END / n))
        write("one_time_too_few", h, np.linspace(0, END, n), np.array(y), names)
        # A factor of 1.5 forgotten: both slopes have the weight 1/2.
        write("adams_equal_weights", h, *adams_bashforth([0.5, 0.5])(oscillator, start, h), names)
        # Another constant than the problem's: damping of 0.25.
        write("other_damping", h, *march(rk4, lambda t, y: np.array([y[1], -y[0] - 0.25 * y[1]]), start, h), names)


main()
