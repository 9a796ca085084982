#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes lorenz_dense.csv: Lorenz's attractor at every half unit of time up to 40.

The horizons of `odeum drift` need the truth more often than lorenz_kehlet_logg.csv has it. Taylor
series of degree 45 in 45 digits, 30 steps a half unit: the same to 24 digits with 25 steps, and the
same as that reference at t = 10 and 20. Needs mpmath.
"""
from mpmath import mp, mpf, nstr

mp.dps = 45
DEGREE, STEPS, PIECES = 45, 30, 80
S, R, B = mpf(10), mpf(28), mpf(8) / 3


def advance(state, h):
    x, y, z = ([value] for value in state)
    for k in range(DEGREE):
        xy = sum(x[j] * y[k - j] for j in range(k + 1))
        xz = sum(x[j] * z[k - j] for j in range(k + 1))
        x.append(S * (y[k] - x[k]) / (k + 1))
        y.append((R * x[k] - xz - y[k]) / (k + 1))
        z.append((xy - B * z[k]) / (k + 1))
    return [mp.polyval(series[::-1], h) for series in (x, y, z)]


state = [mpf(1), mpf(0), mpf(0)]
print("t,component,value")
for piece in range(1, PIECES + 1):
    for _ in range(STEPS):
        state = advance(state, mpf(1) / 2 / STEPS)
    time = piece // 2 if piece % 2 == 0 else nstr(mpf(piece) / 2, 6)
    for component, value in enumerate(state):
        print(f"{time},{component},{nstr(value, 26)}")
