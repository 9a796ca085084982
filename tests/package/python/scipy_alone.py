# SPDX-License-Identifier: BSD-3-Clause
"""Runs SciPy alone on four cases, written down here once more, and holds what it finds against reports/measured/scipy.csv: the
evaluations and errors that the plug-in had.
    scipy_alone.py ROOT"""
import csv, pathlib, sys

root = pathlib.Path(sys.argv[1])
try:
    import numpy as np
    from scipy import integrate
except ImportError as error:
    sys.exit(f"not checked: {error} (python3-numpy, python3-scipy)")


def predators(t, y):
    return [(1.5 - y[1]) * y[0], (y[0] - 3) * y[1]]


def kepler(t, y):
    r3 = (y[0] ** 2 + y[1] ** 2) ** 1.5
    return [y[2], y[3], -y[0] / r3, -y[1] / r3]


def brusselator(t, y):
    return [1 + y[0] ** 2 * y[1] - 4 * y[0], 3 * y[0] - y[0] ** 2 * y[1]]


def oregonator(t, y):
    return [77.27 * (y[1] + y[0] * (1 - 8.375e-6 * y[0] - y[1])), (y[2] - (1 + y[0]) * y[1]) / 77.27, 0.161 * (y[0] - y[2])]


def oregonator_jacobian(t, y):
    return [[77.27 * (1 - 2 * 8.375e-6 * y[0] - y[1]), 77.27 * (1 - y[0]), 0], [-y[1] / 77.27, -(1 + y[0]) / 77.27, 1 / 77.27],
            [0.161, 0, -0.161]]


methods = {"rk23": integrate.RK23, "rk45": integrate.RK45, "dop853": integrate.DOP853, "radau": integrate.Radau, "bdf": integrate.BDF,
           "lsoda": integrate.LSODA}
explicit = ["rk23", "rk45", "dop853"]
problems = {"lotka_volterra": (predators, None, [1.0, 1.0], explicit + ["lsoda"]),
            "kepler_e06": (kepler, None, [0.4, 0.0, 0.0, 2.0], explicit),
            "brusselator2": (brusselator, None, [1.5, 3.0], explicit),
            "oregonator": (oregonator, oregonator_jacobian, [1.0, 2.0, 3.0], ["radau", "bdf", "lsoda"])}
kept = {(row["case"], row["solver"], float(row["tolerance"])): row
        for row in csv.DictReader(open(root / "reports/measured/scipy.csv", newline="")) if row["library"] == "scipy"}


def truth(case):
    """Times and states of cases/reference."""
    with open(root / "cases/reference" / f"{case}.csv", newline="") as file:
        return [[float(cell) for cell in row] for row in csv.reader(file) if row[0][0].isdigit()]


def solved(method, f, jacobian, y, stops, tolerance):
    """Evaluations, steps and states at the stops: a one-step method steps onto each, a multistep one interpolates there."""
    count, steps, states, h = [0], 0, [], None

    def counted(t, y):
        count[0] += 1
        return np.array(f(t, y), dtype=float)

    settings = {"rtol": tolerance, "atol": tolerance}
    if method in ("radau", "bdf", "lsoda"):
        settings["jac"] = lambda t, y: np.array(jacobian(t, y), dtype=float)
    solver = methods[method](counted, 0.0, np.array(y), np.inf, **settings) if method in ("bdf", "lsoda") else None
    t = 0.0
    for stop in stops:
        if method not in ("bdf", "lsoda"):
            solver = methods[method](counted, t, np.array(y), stop, first_step=None if h is None else min(h, stop - t), **settings)
        while solver.status == "running" and solver.t < stop:
            assert solver.step() is None
            steps += 1
            h = max(solver.h_abs, solver.step_size) if solver.status != "running" and method not in ("bdf", "lsoda") else \
                getattr(solver, "h_abs", None)
        t, y = stop, solver.dense_output()(stop) if solver.t > stop else solver.y
        states.append(y)
    return count[0], steps, states


held = 0
for case, (f, jacobian, y, names) in problems.items():
    exact = {}
    for t, component, value in truth(case):
        exact.setdefault(t, {})[int(component)] = value
    stops = {"lotka_volterra": [1, 2, 5, 10], "kepler_e06": [1, 3], "brusselator2": [1, 5, 10, 20], "oregonator": [120, 240, 360]}[case]
    for name in names:
        for tolerance in (1e-4, 1e-7):
            count, steps, states = solved(name, f, jacobian, y, stops, tolerance)
            row = kept[case, name, tolerance]
            error = max(abs(state[i] - value) for stop, state in zip(stops, states) for i, value in exact[stop].items())
            print(f"{case} {name} {tolerance:g}: {count} evaluations, {steps} steps, error {error:.6g}; kept {row['rhs_evaluations']}, "
                  f"{row['steps']}, {row['error_max']}")
            # The same steps, but for what the order of a sum rounds: a step more or less in a hundred.
            assert abs(count / int(row["rhs_evaluations"]) - 1) < 0.02 and abs(steps / int(row["steps"]) - 1) < 0.02, (case, name)
            held += 1
print(f"{held} runs of SciPy alone are those of the plug-in")
