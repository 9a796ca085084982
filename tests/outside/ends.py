#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Computes the right ends of the texts by SciPy, and writes them into texts/ends.csv. No solver of Odeum enters.

tests/outside/ends.py [NAME...]    default: the texts that ends.csv does not have

Columns: two_runs_differ_by is the absolute distance of two runs, by the same method at two tolerances; a method of
another family is to agree with them to 1e-6 of the state's largest value. largest: of the state along the run.
amplification: the largest of what the fundamental matrix makes of an error between any of 13 times and the end, in units
of `largest` (row sums), by finite differences of runs. by: the method; where it is not DOP853, the text is stiff. Needs SciPy and PyYAML."""
import csv, math, os, pathlib, sys, time, warnings
import numpy as np
from scipy.integrate import odeint, solve_ivp
from model import Model

folder = pathlib.Path(__file__).resolve().parent / "texts"
table = folder / "ends.csv"
columns = ["problem", "end", "component", "value", "two_runs_differ_by", "largest", "amplification", "by"]
PARTS = 12
warnings.simplefilter("ignore")
# ODEPACK prints its warnings by itself.
said = os.fdopen(os.dup(1), "w")
os.dup2(os.open(os.devnull, os.O_WRONLY), 1)


class Many(Exception):
    """More evaluations than a method is given."""


def switches(model):
    """Times within the span at which a condition of the time alone changes: sides without states, sampled and bisected."""
    span = model.end - model.start
    constant, first = [], model.sides(model.start, model.y0)
    other = [y + 1e-3 * (1 + abs(y)) for y in model.y0]
    for k in range(len(first)):
        try:
            alone = all(model.sides(model.start + f * span, model.y0)[k] == model.sides(model.start + f * span, other)[k]
                        for f in (0, 0.37, 0.91))
        except (ValueError, ZeroDivisionError, OverflowError):
            alone = False
        if alone:
            constant.append(k)
    found = set()
    # A side t - c, which a sample may pass by twice.
    for k in constant:
        side = lambda t: model.sides(t, model.y0)[k]
        slope = side(model.end) - side(model.start)
        if slope and abs(side(model.start + span / 3) - side(model.start) - slope / 3) < 1e-12 * abs(slope):
            at = model.start - side(model.start) * span / slope
            found.add(float(f"{at:.14g}"))
    if constant:
        grid = [model.start + span * i / 20000 for i in range(20001)]
        values = [model.sides(t, model.y0) for t in grid]
        for k in constant:
            for i in range(20000):
                if (values[i][k] > 0) != (values[i + 1][k] > 0):
                    low, high, up = grid[i], grid[i + 1], values[i + 1][k] > 0
                    for _ in range(80):
                        middle = (low + high) / 2
                        if (model.sides(middle, model.y0)[k] > 0) == up:
                            high = middle
                        else:
                            low = middle
                    if not any(abs(each - high) < 1e-11 * span for each in found):
                        found.add(high)
    apart = 1e-10 * span
    kept = []
    for each in sorted(found):
        if model.start + apart < each < model.end - apart and (not kept or each > kept[-1] + apart):
            kept.append(each)
    return kept


def guarded(model, most):
    count = [0]

    def rhs(t, y):
        count[0] += 1
        if count[0] > most:
            raise Many
        try:
            return model.rhs(t, y.tolist())
        except (ValueError, ZeroDivisionError, OverflowError):
            return [math.nan] * len(y)
    return rhs


def run(model, method, rtol, size, begin, end, y, breaks, most=3 * 10**5):
    """The end, and the largest of each state along the steps; the absolute tolerances are 1e-2 rtol times `size`. No step is
    longer than a fortieth, so that no day or pulse is stepped over."""
    y, largest = np.array(y, float), np.abs(np.array(y, float))
    times = [begin, *[each for each in breaks if begin < each < end], end]
    rhs, atol = guarded(model, most), 1e-2 * rtol * size
    for low, high in zip(times, times[1:]):
        model.clock[:] = [math.nextafter(low, math.inf), math.nextafter(high, -math.inf)]
        if method == "LSODA":  # that of ODEPACK alone, many times as fast as solve_ivp's
            states, report = odeint(rhs, y, np.linspace(low, high, 1001), rtol=rtol, atol=atol, tfirst=True, full_output=True,
                                  mxstep=10**6, h0=1e-6 * (high - low) if low == begin else 0, printmessg=False, hmax=(high - low) / 40)
            states = states.T
            failed = "" if "successful" in report["message"] else report["message"]
        else:
            got = solve_ivp(rhs, (low, high), y, method=method, rtol=rtol, atol=atol, max_step=(high - low) / 40)
            states, failed = got.y, "" if got.success else got.message
        if failed or not np.isfinite(states).all():
            raise RuntimeError(f"{method} between {low} and {high}: {failed}")
        y, largest = states[:, -1], np.maximum(largest, np.abs(states).max(axis=1))
    model.clock[:] = [-math.inf, math.inf]
    return y, largest


def robust(model, rtol, *rest):
    for method in ("LSODA", "Radau", "BDF"):
        try:
            return run(model, method, rtol, *rest)
        except (Many, RuntimeError):
            if method == "BDF":
                raise


def end_of(model, breaks, least):
    """`least`: absolute tolerances are less by this, where states come back from far below their largest value."""
    span = (model.start, model.end, model.y0, breaks)
    # Sizes first, of states as small as a trace too.
    size = np.full(len(model.y0), 1e-6 * max(map(abs, model.y0)) or 1e-6)
    for _ in range(2):
        largest = robust(model, 1e-7, least * size, *span)[1]
        size = np.where(largest > 0, largest, 1)
    # What is stiff shows at a coarse tolerance.
    for method, fine, coarse, most in [("DOP853", 2.5e-14, 1e-12, 5 * 10**5), ("Radau", 1e-11, 1e-10, 10**6),
                                       ("LSODA", 1e-12, 1e-11, 3 * 10**6)]:
        try:
            if method == "DOP853":
                run(model, method, 1e-6, least * size, *span, most=2 * 10**4)
            best, largest = run(model, method, fine, least * size, *span, most=most)
            again, _ = run(model, method, coarse, least * size, *span, most=most)
            break
        except (Many, RuntimeError) as error:
            if method == "LSODA":
                raise RuntimeError(f"no method ends: {error}") from error
    for another in ["LSODA", "BDF"] if method == "Radau" else ["Radau"]:
        try:
            other, _ = run(model, another, 1e-8, least * size, *span)
            break
        except RuntimeError:
            if another != "LSODA":
                raise
    apart = np.max(np.abs(other - best) / size)
    return best, np.abs(best - again), largest, method, apart


def amplification_of(model, breaks, largest, least):
    """Of the fundamental matrices between PARTS + 1 times, by differences; all in units of the largest."""
    size = np.where(largest > 0, largest, 1)
    n, y = len(size), np.array(model.y0, float)
    span = model.end - model.start
    times = [model.start + span * k / PARTS for k in range(PARTS)] + [model.end]
    times = [next((each for each in breaks if abs(each - t) < 1e-10 * span), t) for t in times]
    parts = []
    for low, high in zip(times, times[1:]):
        solve = lambda start: robust(model, 1e-8, least * size, low, high, start, breaks)[0]
        base, part = solve(y), np.empty((n, n))
        for j in range(n):
            shifted = y.copy()
            shifted[j] += 1e-5 * size[j]
            part[:, j] = (solve(shifted) - base) / (1e-5 * size)
        parts.append(part)
        y = base
    matrix, most = np.eye(n), 1.0
    for part in reversed(parts):
        matrix = matrix @ part
        most = max(most, np.abs(matrix).sum(axis=1).max())
    return most


def rows_of(name):
    begin, model = time.process_time(), Model(folder / f"{name}.yaml")
    breaks = switches(model)
    got = None
    for least in (1, 1e-20):
        try:
            found = end_of(model, breaks, least)
            found = (*found, amplification_of(model, breaks, found[2], least))
        except (Many, RuntimeError) as error:  # the other tolerances may do
            print(f"{name}: {error}", flush=True, file=said)
            if least < 1 and not got:
                raise
            continue
        apart = lambda each: max(each[4], max(each[1] / np.where(each[2] > 0, each[2], 1)))
        got = found if not got or apart(found) < apart(got) else got
        if apart(got) < 1e-7:
            break
    best, differ, largest, method, apart, most = got
    print(f"{name}: {method}, {len(breaks)} switches, two runs differ by {max(differ):.1e}, another family by "
          f"{apart:.1e} of the largest, amplification {most:.2g}, {time.process_time() - begin:.1f} s", flush=True, file=said)
    if apart > 1e-6 * max(1, most):
        print(f"{name}: NOT CERTAIN: a method of another family ends elsewhere", flush=True, file=said)
    return [[name, repr(model.end), i + 1, repr(float(best[i])), repr(float(differ[i])), f"{largest[i]:.6g}", f"{most:.3g}", method]
            for i in range(len(best))]


def main():
    rows = {}
    if table.exists():
        with open(table, encoding="utf-8") as file:
            for row in csv.reader(file):
                if row[0] != "problem":
                    rows.setdefault(row[0], []).append(row)
    names = sys.argv[1:] or sorted({path.stem for path in folder.glob("*.yaml")} - set(rows))
    for name in names:
        try:
            rows[name] = rows_of(name)
        except Exception as error:  # of one text; the others go on
            print(f"{name}: FAILED: {type(error).__name__}: {error}", flush=True, file=said)
            continue
        with open(table, "w", encoding="utf-8", newline="") as file:
            out = csv.writer(file, lineterminator="\n")
            out.writerow(columns)
            for each in sorted(rows):
                out.writerows(rows[each])


if __name__ == "__main__":
    main()
