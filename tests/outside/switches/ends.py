#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Computes the right ends of the texts beside it with SciPy, and writes them into ends.csv. No solver of Odeum enters.

tests/outside/switches/ends.py [NAME...]    default: the texts that ends.csv does not have

Each condition (a comparison, abs, sign, min or max) keeps its side while SciPy integrates a smooth system to the time at
which one of them changes, which its events locate; the next piece begins there. two_runs_differ_by: two such runs, by
DOP853 at 1e-13 and 1e-12, of stiff texts by Radau at 1e-12 and 1e-11. amplification: the largest of what an error of a
state at any of eight times becomes at the end, in units of 1 + |y|, by finite differences of runs."""
import ast, csv, math, pathlib, re, sys
import numpy as np
import yaml
from scipy.integrate import solve_ivp

folder = pathlib.Path(__file__).resolve().parent
table = folder / "ends.csv"
columns = ["schema", "problem", "end", "component", "value", "two_runs_differ_by", "amplification"]
stiff = {"fast_rectifier", "niles", "late_switch"}


class Sides:
    """The values of the conditions of one evaluation in their order, and the sides that they are held on."""
    held, values = None, []

    def side(self, value):
        k = len(self.values)
        self.values.append(value)
        return (value > 0) - (value < 0) if self.held is None else self.held[k]


sides = Sides()


def compared(a, how, b):
    side = sides.side(b - a)
    return {"Lt": side > 0, "LtE": side >= 0, "Gt": side < 0, "GtE": side <= 0}[how]


def largest(a, *others):
    for b in others:
        a = b if sides.side(b - a) >= 0 else a
    return a


def smallest(a, *others):
    for b in others:
        a = a if sides.side(b - a) >= 0 else b
    return a


names = {name: getattr(math, name) for name in ("sin", "cos", "tan", "atan", "tanh", "pi", "e", "log")}
# Beyond their domain as far as an integrator tries a step before it finds the event.
names |= {"exp": lambda x: math.exp(min(x, 700)), "sqrt": lambda x: math.copysign(math.sqrt(abs(x)), x),
          "if_": lambda condition, a, b: a if condition else b, "max_": largest, "min_": smallest,
          "abs_": lambda x: x if sides.side(x) >= 0 else -x, "sign_": lambda x: sides.side(x), "compared": compared}


class Comparisons(ast.NodeTransformer):
    def visit_Compare(self, node):
        self.generic_visit(node)
        call = ast.Call(ast.Name("compared", ast.Load()),
                        [node.left, ast.Constant(type(node.ops[0]).__name__), node.comparators[0]], [])
        return ast.copy_location(call, node)


def compiled(text):
    text = re.sub(r"\b(if|max|min|abs|sign)\(", r"\1_(", re.sub(r"\bfrom\b", "from_", text.replace("^", "**")))
    return compile(ast.fix_missing_locations(Comparisons().visit(ast.parse(text, mode="eval"))), text, "eval")


class Problem:
    def __init__(self, name):
        text = yaml.load((folder / f"{name}.yaml").read_text(encoding="utf-8"), Loader=yaml.BaseLoader)
        self.parameters = dict(names)
        for key, value in text.get("parameters", {}).items():
            self.parameters["from_" if key == "from" else key] = float(value)
        self.states = list(text["states"])
        self.y0 = np.array([float(value) for value in text["states"].values()])
        self.definitions = [(key, compiled(value)) for key, value in text.get("definitions", {}).items()]
        self.equations = [compiled(text["equations"][state]) for state in self.states]
        self.start, self.end = float(text["time"].get("start", 0)), float(text["time"]["end"])

    def __call__(self, t, y, held):
        """The right-hand side, and the values of the conditions."""
        sides.held, sides.values = held, []
        known = self.parameters | {"t": t} | dict(zip(self.states, map(float, y)))
        for key, value in self.definitions:
            known[key] = eval(value, known)
        return np.array([eval(equation, known) for equation in self.equations]), sides.values

    def sides(self, t, y):
        return [(value > 0) - (value < 0) for value in self(t, y, None)[1]]


def run(p, t, y, end, method, tolerance, parts):
    y, held, pieces = np.array(y, float), p.sides(t, y), 0
    span = p.end - p.start
    if 0 in held:  # a condition that is zero at the start: its side a few short steps later
        later, at = y.copy(), t
        for _ in range(3):
            later, at = later + 1e-7 * span * p(at, later, None)[0], at + 1e-7 * span
        held = [a or b for a, b in zip(held, p.sides(at, later))]
    while True:
        def event(k):
            def value(time, state):
                return p(time, state, held)[1][k]
            value.terminal, value.direction = True, -held[k]
            return value
        watched = [k for k in range(len(held)) if held[k]]
        done = solve_ivp(lambda time, state: p(time, state, held)[0], (t, end), y, method=method, rtol=tolerance,
                         atol=0.1 * tolerance, events=[event(k) for k in watched], max_step=span / parts,
                         first_step=min(1e-6 * span, end - t) if pieces else None)
        t, y, pieces = done.t[-1], done.y[:, -1], pieces + 1
        if done.status == 0:
            return y
        if done.status < 0 or pieces > 5000:
            raise RuntimeError(done.message)
        turned = {k for k, times in zip(watched, done.t_events) if len(times)}
        held = [-side if k in turned else side for k, side in enumerate(held)]
        # Conditions that have the same zero turn together.
        for _ in range(4):
            slope, here = p(t, y, held)
            _, later = p(t + 1e-9 * span, y + 1e-9 * span * slope, held)
            near = 1e-9 * (1 + np.abs(y).max())
            more = {k for k in watched if k not in turned and later[k] * held[k] < 0 and abs(here[k]) <= near}
            held = [-side if k in more else side for k, side in enumerate(held)]
            turned |= more
            if not more:
                break


def rows_of(name):
    p = Problem(name)
    method, fine, coarse = ("Radau", 1e-12, 1e-11) if name in stiff else ("DOP853", 1e-13, 1e-12)
    end = run(p, p.start, p.y0, p.end, method, fine, 400)
    other = run(p, p.start, p.y0, p.end, method, coarse, 577)
    amplification, t, y = 1.0, p.start, p.y0
    for k in range(8):
        later = p.start + (p.end - p.start) * (k + 0.37 * (k > 0)) / 8
        if later > t:
            y, t = run(p, t, y, later, method, 10 * fine, 400), later
        for j in range(len(y)):
            step = np.zeros(len(y))
            step[j] = (1e-5 if name in stiff else 1e-6) * (1 + abs(y[j]))
            moved = run(p, t, y + step, p.end, method, 1e-10, 400) - run(p, t, y - step, p.end, method, 1e-10, 400)
            grown = np.abs(moved) / (2 * step[j]) * (1 + abs(y[j])) / (1 + np.abs(end))
            amplification = max(amplification, grown.max())
    return [[1, name, f"{p.end:g}", state, repr(float(value)), f"{abs(value - again):.1e}", f"{amplification:.3g}"]
            for state, value, again in zip(p.states, end, other)]


def main():
    known = {}
    with open(table, encoding="utf-8") as file:
        for row in csv.reader(file):
            known.setdefault(row[1], []).append(row)
    known.pop("problem")
    for name in sys.argv[1:] or sorted({path.stem for path in folder.glob("*.yaml")} - set(known)):
        known[name] = rows_of(name)
        print(name, *known[name], sep="\n  ")
    with open(table, "w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([columns, *(row for name in sorted(known) for row in known[name])])


if __name__ == "__main__":
    main()
