#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the references of the cases with events: NAME.csv of each, into its folder.

Taylor series of degree 40 in 50 digits, in pieces from event to event; an event is the first root of
its function's polynomial in a step, by Newton's iteration. The same to 30 digits with half the steps.
Needs mpmath.
"""
import pathlib
from mpmath import mp, mpf, nstr, cos, sin

mp.dps = 50
DEGREE = 40


def product(a, b, k):
    return sum(a[j] * b[k - j] for j in range(k + 1))


def ball(y, k, t):
    g = mpf("9.81")
    return [y[1][k], -g if k == 0 else mpf(0)]


def heater(y, k, t):
    return [-mpf("0.1") * y[0][k] + 5 * y[1][k], mpf(0)]


def relay(y, k, t):
    return [y[1][k], -y[0][k] - mpf("1.4") * y[1][k] + y[2][k], mpf(0)]


def forced(y, k, t):
    w = mpf("2.8")
    force = [cos(w * t), -sin(w * t), -cos(w * t), sin(w * t)][k % 4] * w**k / mp.factorial(k)
    return [y[1][k], force - y[0][k]]


class Belt:
    """A mass that slips under friction grip/(1 + delta (belt - v)), or rides on the belt."""

    def __call__(self, y, k, t):
        belt, delta = mpf("0.2"), 3
        if y[2][0] < 0.5:
            return [belt if k == 0 else mpf(0), mpf(0), mpf(0)]
        if k == 0:
            self.d, self.q = [], []
        self.d.append((1 + delta * belt if k == 0 else 0) - delta * y[1][k])
        known = sum(self.d[j] * self.q[k - j] for j in range(1, k + 1))
        self.q.append(((1 if k == 0 else 0) - known) / self.d[0])
        return [y[1][k], self.q[k] - y[0][k], mpf(0)]


def absorption(y, k, t):
    ka, ke = mpf("1.2"), mpf("0.15")
    return [-ka * y[0][k], ka * y[0][k] - ke * y[1][k]]


def series(f, y, t):
    s = [[c] for c in y]
    for k in range(DEGREE):
        for c, d in zip(s, f(s, k, t)):
            c.append(d / (k + 1))
    return [c[::-1] for c in s]


def root(polynomial, h):
    """The first time in (0, h] at which it comes to fall below zero; None: it does not."""
    pieces = 64
    before = mp.polyval(polynomial, h / 10**6)
    for j in range(1, pieces + 1):
        now = mp.polyval(polynomial, h * j / pieces)
        if before > 0 >= now:
            low, high = (h / 10**6 if j == 1 else h * (j - 1) / pieces), h * j / pieces
            for _ in range(12):
                middle = (low + high) / 2
                low, high = (middle, high) if mp.polyval(polynomial, middle) > 0 else (low, middle)
            x = (low + high) / 2
            for _ in range(8):
                value, slope = mp.polyval(polynomial, x, derivative=True)
                x -= value / slope
            return x
        before = now
    return None


def run(f, y, times, events, h, doses=()):
    """events: (coefficients of a linear function of the state, its constant, what is done)."""
    t, rows = mpf(0), []
    marks = sorted(set(times) | {at for at, _ in doses})
    for mark in marks:
        while t < mark:
            last = mark - t <= h
            step = mark - t if last else h
            s = series(f, y, t)
            first = None
            for weights, constant, reset in events:
                p = [sum(w * c[k] for w, c in zip(weights, s)) for k in range(DEGREE + 1)]
                p[-1] += constant
                at = root(p, step)
                if at is not None and (first is None or at < first[0]):
                    first = (at, reset)
            at = first[0] if first else step
            y = [mp.polyval(c, at) for c in s]
            t = t + at if first else mark if last else t + step
            if first:
                y = first[1](y)
        for at, reset in doses:
            if at == mark:
                y = reset(y)
        if mark in times:
            rows.append((mark, y))
    return rows


def numbers(*texts):
    return [mpf(text) for text in texts]


CASES = {
    "bouncing_ball": (ball, numbers(1, 0), numbers("0.5", 1, 2, 3),
                      [([1, 0], 0, lambda y: [mpf(0), -mpf("0.8") * y[1]])], ()),
    "thermostat": (heater, numbers(20, 1), numbers(6, 12, 18, 24),
                   [([-1, 0], 21, lambda y: [y[0], mpf(0)]), ([1, 0], -19, lambda y: [y[0], mpf(1)])], ()),
    "relay": (relay, numbers("0.3", 0, -1), numbers(5, 10, 20, 30),
              [([-1, 0, 0], mpf("0.1"), lambda y: [y[0], y[1], mpf(-1)]),
               ([1, 0, 0], mpf("0.1"), lambda y: [y[0], y[1], mpf(1)])], ()),
    "impact_oscillator": (forced, numbers("-0.5", 0), numbers(5, 10, 15, 20),
                          [([-1, 0], 0, lambda y: [mpf(0), -mpf("0.8") * y[1]])], ()),
    "stick_slip": (Belt(), numbers(0, "0.2", 0), numbers(4, 9, 15, 25),
                   [([-1, 0, 0], 1, lambda y: [y[0], y[1], mpf(1)]),
                    ([0, -1, 0], mpf("0.2"), lambda y: [y[0], mpf("0.2"), mpf(0)])], ()),
    "doses": (absorption, numbers(100, 0), numbers(10, 20, 44, 60), [],
              [(mpf(8 * k), lambda y: [y[0] + 80, y[1]]) for k in range(1, 6)]),
}

if __name__ == "__main__":
    for name, (f, y0, times, events, doses) in CASES.items():
        # An event at the very end of a step would be missed: one at t = 5, say.
        h = mpf("0.0213") if name == "stick_slip" else mpf("0.25")
        rows = run(f, y0, times, events, h, doses)
        finer = run(f, y0, times, events, h / 2, doses)
        apart = max(abs(a - b) for (_, y), (_, z) in zip(rows, finer) for a, b in zip(y, z))
        print(f"{name}: {nstr(apart, 2)} from half the step")
        with open(pathlib.Path(__file__).parent / f"{name}.csv", "w", encoding="ascii") as out:
            print("t,component,value", file=out)
            for t, y in rows:
                for i, value in enumerate(y):
                    print(f"{nstr(t, 17, strip_zeros=True).removesuffix('.0')},{i},{nstr(value, 34)}", file=out)
