#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Computes the right ends of the texts with events by SciPy, and writes them into ends.csv. No solver of Odeum enters.

tests/outside/hybrid/ends.py [NAME...]    default: all that have events

Step by step by DOP853 (stiff: Radau); each function is looked at in 33 places of a step's dense output, and where it changes
its sign since it last had one, Brent's rule finds its zero; the state there is that of a run up to it. A function that is
zero but for rounding has no sign. two_runs_differ_by: runs at 1e-12 and 1e-11 (stiff: 1e-11, 1e-10) relative, by the largest
of each state. amplification: by differences of the start. printed.csv has what sources print. Needs SciPy and PyYAML."""
import csv, math, pathlib, re, sys
import numpy as np
import yaml
from scipy.integrate import DOP853, Radau
from scipy.optimize import brentq

folder = pathlib.Path(__file__).resolve().parent
columns = ["schema", "problem", "end", "component", "name", "value", "two_runs_differ_by", "largest", "amplification", "events", "by"]
names = {name: getattr(math, name) for name in ("sin", "cos", "tan", "exp", "log", "sqrt", "hypot", "pi", "e")}
names |= {"abs": abs, "if_": lambda condition, a, b: a if condition else b}
# An integrator tries states beyond a threshold.
names["sqrt"] = lambda x: math.copysign(math.sqrt(abs(x)), x)
names["exp"] = lambda x: math.exp(min(x, 700))
stiff = {"robertson_thresholds", "lsodar_van_der_pol"}


class Model:
    def __init__(self, path):
        text = yaml.load(path.read_text(encoding="utf-8"), yaml.BaseLoader)
        self.states, self.known = list(text["states"]), dict(names)
        for name, each in text.get("parameters", {}).items():
            self.known[name] = float(self.value(each))
        self.definitions = text.get("definitions", {})
        self.y0 = np.array([float(self.value(each)) for each in text["states"].values()])
        self.end = float(text["time"]["end"])
        self.rhs = [self.function(text["equations"][name]) for name in self.states]
        self.found, self.clock = [], []
        for event in text["events"]:
            event["do"] = [(self.states.index(name), self.function(each)) for name, each in event.get("set", {}).items()]
            event["rank"] = int(event.get("order", 0))
            if "when" in event:
                comparison = re.split(r"\band\b", event["when"])
                condition = any(mark in event["when"] for mark in "<>") and "if(" not in event["when"]
                sides = [re.split(r"[<>]", each) for each in comparison] if condition else []
                event["g"] = [self.function(f"({a}) - ({b})" if ">" in each else f"({b}) - ({a})")
                              for each, (a, b) in zip(comparison, sides)] or [self.function(event["when"])]
                event["sense"] = 1 if condition or "rising" in event else -1 if "falling" in event else 0
                self.found.append(event)
            else:
                first, last = self.value(event["at"]), self.value(event.get("until", self.end))
                apart = self.value(event["every"]) if "every" in event else math.inf
                count = 0 if math.isinf(apart) else int((last - first) / apart * (1 + 1e-12))
                self.clock += [(first + k * apart if k else first, event) for k in range(count + 1)]
        self.clock.sort(key=lambda each: each[0])

    def value(self, text):
        return eval(self.python(text), dict(self.known))

    @staticmethod
    def python(text):
        return re.sub(r"\bif\(", "if_(", str(text)).replace("^", "**")

    def function(self, text):
        body = str(text)
        for name, each in reversed(self.definitions.items()):
            body = re.sub(rf"\b{name}\b", f"({each})", body)
        code = compile(self.python(body), body, "eval")
        return lambda t, y: eval(code, self.known, dict(zip(self.states, map(float, y)), t=t))

    def g(self, event, t, y):
        """The least of the sides of a condition is positive where it holds."""
        return min(each(t, y) for each in event["g"])

    @staticmethod
    def jacobian(rhs, t, y, size):
        """By central differences, which are exact but for rounding where the equations are quadratic."""
        steps = 1e-3 * np.maximum(np.abs(y), 1e-3 * size)
        moved = [np.eye(len(y))[j] * step for j, step in enumerate(steps)]
        return np.array([(np.array(rhs(t, y + d)) - rhs(t, y - d)) / (2 * step) for d, step in zip(moved, steps)]).T

    def run(self, tolerance, y0, size, method, parts):
        y, t, count = np.array(y0), 0.0, 0
        largest, sides = np.abs(y), [0.0] * len(self.found)
        clock, delayed = list(self.clock), []
        scales = [abs(self.g(event, 0, y)) for event in self.found]

        def do(events, t):
            nonlocal y
            for event in sorted(events, key=lambda each: each["rank"]):
                values = [(i, each(t, y)) for i, each in event["do"]]
                for i, each in values:
                    y[i] = each
            return any("stop" in event for event in events)

        def look(t, y):
            for k, event in enumerate(self.found):
                value = self.g(event, t, y)
                scales[k] = max(scales[k], abs(value))
                yield k, value if abs(value) > 1e-10 * scales[k] else 0.0

        while t < self.end:
            for k, value in look(t, y):
                sides[k] = value
            next_time = min([at for at, _ in clock + delayed] + [self.end])
            rhs = lambda t, y: [each(t, y) for each in self.rhs]
            more = {"jac": lambda t, y: self.jacobian(rhs, t, y, size)} if method is Radau else {}
            make = lambda t, y, end: method(rhs, t, y, end, rtol=tolerance, atol=1e-2 * tolerance * size,
                                            first_step=min(1e-7 * self.end, end - t), max_step=self.end / parts, **more)
            solver = make(t, y, next_time)
            zero = None
            while solver.status == "running" and zero is None:
                assert solver.step() != "failed", "a step failed"
                states, begin = solver.dense_output(), solver.t_old
                places = np.linspace(begin, solver.t, 33)
                zeros, before = [], begin
                for at in places[1:]:
                    for k, value in look(at, states(at)):
                        event = self.found[k]
                        if value and sides[k] and value * sides[k] < 0 and event["sense"] * value >= 0:
                            g = lambda t: self.g(event, t, states(t))
                            zeros.append((brentq(g, before, at, xtol=1e-15, rtol=1e-15) if g(before) * g(at) < 0 else at, k))
                        sides[k] = value or sides[k]
                    before = at
                    if zeros:
                        zero = min(zeros)[0]
                        break
                largest = np.maximum(largest, np.abs(states(places[places <= (zero or solver.t)])).max(axis=1))
            if zero is None:
                t, y = solver.t, solver.y.copy()
                if t < self.end or any(at == t for at, _ in clock + delayed):
                    called = [event for at, event in clock + delayed if at <= t * (1 + 1e-14)]
                    clock, delayed = ([each for each in which if each[0] > t * (1 + 1e-14)] for which in (clock, delayed))
                    count += len(called)
                    if do(called, t):
                        break
                continue
            if zero > t:
                solver = make(t, y, zero)
                while solver.status == "running":
                    solver.step()
                t, y = solver.t, solver.y.copy()
            called = [self.found[k] for at, k in zeros if at - zero <= 1e-10 * self.end]
            delayed += [(t + self.value(event["delay"]), event) for event in called if "delay" in event]
            called = [event for event in called if "delay" not in event]
            count += len(called)
            stops = do(called, t)
            largest = np.maximum(largest, np.abs(y))
            if stops:
                break
        return y, np.maximum(largest, np.abs(y)), count


def rows_of(name):
    model = Model(folder / f"{name}.yaml")
    method, fine = (Radau, 1e-11) if name in stiff else (DOP853, 1e-12)
    size = np.where(model.y0 != 0, np.abs(model.y0), 1e-6 if name in stiff else 1)
    size = model.run(1e-7, model.y0, size, method, 100)[1]
    size = np.where(size > 0, size, 1)
    best, largest, count = model.run(fine, model.y0, size, method, 400)
    again, _, _ = model.run(10 * fine, model.y0, size, method, 277)
    amplification = 1.0
    for j in range(len(best)):
        moved = model.y0.copy()
        moved[j] += 1e-7 * size[j]
        there, _, other = model.run(10 * fine, moved, size, method, 277)
        if other == count:
            amplification = max(amplification, float(np.max(np.abs(there - again) / size)) / 1e-7)
    print(name, count, "events", best, f"{np.max(np.abs(best - again) / size):.1e}", f"{amplification:.3g}", flush=True)
    return [[1, name, f"{model.end:g}", i + 1, model.states[i], repr(float(value)), f"{abs(again[i] - value):.2g}", f"{largest[i]:.6g}",
             f"{amplification:.3g}", count, method.__name__] for i, value in enumerate(best)]


def main():
    table, known = folder / "ends.csv", {}
    if table.exists():
        with open(table, encoding="utf-8") as file:
            for row in csv.reader(file):
                known.setdefault(row[1], []).append(row)
        known.pop("problem")
    for name in sys.argv[1:] or sorted(path.stem for path in folder.glob("*.yaml") if "\nevents:" in path.read_text()):
        known[name] = rows_of(name)
        with open(table, "w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([columns, *(row for each in sorted(known) for row in known[each])])


if __name__ == "__main__":
    main()
