# SPDX-License-Identifier: BSD-3-Clause
"""Runs the examples of the Python package, and tests what it translates, from an installed package alone.
    examples.py PREFIX EXAMPLES"""
import json, math, os, pathlib, subprocess, sys

prefix, examples = map(pathlib.Path, sys.argv[1:3])
try:
    import numpy as np
    import scipy  # noqa: F401
except ImportError as error:
    sys.exit(f"not checked: {error} (python3-numpy, python3-scipy)")
package = prefix / "lib/python3/dist-packages"
os.environ["ODEUM_PROGRAM"] = str(prefix / "bin/odeum")
os.environ["PYTHONPATH"] = str(package)
sys.path.insert(0, str(package))
import odeum

assert pathlib.Path(odeum.__file__).is_relative_to(package), odeum.__file__


def refused(f, words, error=odeum.NotTranslatable):
    try:
        odeum.text_of(f, [1.0, 0.5], (0, 1))
    except error as why:
        assert words in str(why), why
        return
    raise AssertionError(f"not refused: {words}")


# What is translated is what the program runs: the state at the end by a method of order 8, and by the function in Python.
def of_all_kinds(t, y, rate):
    matrix = np.array([[0.0, 1.0], [-2.0, 0.0]])
    drift = matrix @ y - -rate * y**2 / (1 + abs(y[0])) ** 0.5
    return drift + np.array([math.sin(t), np.where(y[0] > 0, math.exp(-t), 2.0) - (3 - t) ** 2 / 10 + -t**2 / 50])


from scipy.integrate import solve_ivp

theirs = solve_ivp(of_all_kinds, (0, 1), [1.0, 0.5], args=(0.3,), rtol=1e-12, atol=1e-12, method="DOP853").y[:, -1]
ours = odeum.run(of_all_kinds, [1.0, 0.5], (0, 1), args=(0.3,), solver="dormand_prince853", tol=1e-12, every=0.5)
end = ours.trajectory[(ours.trajectory["solver"] == "dormand_prince853") & (ours.trajectory["time"] == 1)][0]
assert ours.rows["status"][0] == "ok" and ours.rows.dtype.names
# Both runs are at 1e-12 over one unit of time.
assert abs(end["y0"] - theirs[0]) < 1e-10 and abs(end["y1"] - theirs[1]) < 1e-10, (end, theirs)
assert ours.states[0]["time"][-1] == 1 and ours.states[0]["y1"][-1] == end["y1"], ours.states

# What no text can say is called: the same end, counted and timed apart, from a closure with a branch and a loop.
def brakes(stiffness):
    def pull(t, y, drag):
        force = 0.0
        for _ in range(4):
            force -= stiffness / 4 * y[0]
        return np.array([y[1], force - (drag if y[1] > 0 else 2 * drag) * y[1]])
    return pull


theirs = solve_ivp(brakes(3.0), (0, 2), [1.0, 0.5], args=(0.3,), rtol=1e-11, atol=1e-11, method="DOP853").y[:, -1]
ours = odeum.run(brakes(3.0), [1.0, 0.5], (0, 2), args=(0.3,), solver=["dormand_prince54", "cvode/bdf"], tol=1e-9)
end = [float(ours.states[0][name][-1]) for name in ours.states[0].dtype.names[1:]]
# The slope jumps where the velocity changes its sign, which costs both some digits of the tolerance.
assert np.max(np.abs(end - theirs)) < 1e-6, (end, theirs)
assert list(ours.rows["status"]) == ["ok", "ok"] and ours.rows["error_max"].max() < 1e-5, ours.rows
assert "branches on a state" in ours.called.reason and ours.called.calls > ours.rows["rhs_evaluations"].sum() > 100, ours.called
assert ours.called.call_ns > 0 and ours.called.passing_ns > 0 and not ours.called.raised, ours.called
assert odeum.run("kepler_e06", solver="rk4", step=0.01).called is None
advice = odeum.advise(brakes(3.0), [1.0, 0.5], (0, 2), args=(0.3,), error=1e-4, seconds=5)
# A busy machine may find none in the time.
assert (advice.error is None or advice.error <= 1e-4) and advice.called.calls > 100, advice


def breaks_down(t, y):
    if t > 1:
        raise RuntimeError("no data after t = 1")
    return [y[0] if y[0] > 0 else 0.0]


ours = odeum.run(breaks_down, [1.0], (0, 2), solver="rk4", step=0.01)
assert ours.rows["status"][0] != "ok" and "no data after t = 1, at t = 1.00" in ours.called.raised, ours
try:
    odeum.run(lambda t, y: [1.0, 2.0] if y[0] > 0 else [0.0, 0.0], [1.0], (0, 2), solver="rk4", step=0.01)
    raise AssertionError("two rates were taken for one state")
except ValueError as why:
    assert "2 rates for 1 states" in str(why), why

calls = iter(range(10**6))
refused(lambda t, y: [1.0 if y[0] > 0 else 2.0, 0.0], "numpy.where")
refused(lambda t, y: [float(y[0]), 0.0], "makes a number of a state")
refused(lambda t, y: [y[0] * next(calls), 0.0], "depends on more than its arguments")
refused(lambda t, y: [np.interp(y[0], [0, 1], [0, 1]), 0.0], "cannot be called with symbols")
refused(lambda t, y: [y[0] + math.inf, 0.0], "constant inf")
refused(lambda t, y: [y[0]], "1 rates for 2 states", ValueError)
try:
    odeum.run("no_such_case", solver="rk4", step=0.1)
    raise AssertionError("not refused: no_such_case")
except odeum.OdeumError as why:
    assert "no_such_case" in str(why), why

# SciPy's solvers as a plug-in: RK45 is the pair of Dormand and Prince, with the same errors to a percent.
if (plugin := prefix / "lib/odeum/libodeum_scipy.so").exists():
    solvers = ["scipy/rk45", "dormand_prince54", "scipy/rk23", "scipy/dop853", "scipy/radau", "scipy/bdf", "scipy/lsoda", "scipy/odeint"]
    command = [os.environ["ODEUM_PROGRAM"], "run", "kepler_e06", "--plugin", plugin, "--tol", "1e-6", "--format", "json"]
    answer = json.loads(subprocess.run(command + [word for each in solvers for word in ("--solver", each)], check=True,
                                       capture_output=True, text=True).stdout)["runs"]
    assert [row["status"] for row in answer] == ["ok"] * len(solvers), answer
    assert abs(answer[0]["error_max"] / answer[1]["error_max"] - 1) < 0.01, answer[:2]
    assert all(row["error_max"] < 1e-2 and row["rhs_evaluations"] > 50 for row in answer), answer

for example in sorted(examples.glob("*.py")):
    done = subprocess.run([sys.executable, example], capture_output=True, text=True)
    print(f"{example.name}:\n{done.stdout}")
    if done.returncode != 0:
        sys.exit(f"{example.name} ended with {done.returncode}: {done.stderr}")
