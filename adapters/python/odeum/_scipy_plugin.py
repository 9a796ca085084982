# SPDX-License-Identifier: BSD-3-Clause
"""SciPy's solvers as a plug-in of the program, by ctypes (odeum/plugin.h, version 2). Not to be imported by users.

Evaluations and errors are exact; times are those of Python, with a compiled right-hand side.
"""
import ctypes as c
import gc
import warnings

import numpy as np
import scipy
from scipy import integrate

warnings.simplefilter("ignore")
np.seterr(all="ignore")

CALLBACK = c.CFUNCTYPE(c.c_int, c.c_void_p, c.c_double, c.c_void_p, c.c_void_p)
ACCELERATION = c.CFUNCTYPE(c.c_int, c.c_void_p, c.c_double, c.c_void_p, c.c_void_p, c.c_void_p)


class System(c.Structure):
    _fields_ = [("dimension", c.c_size_t), ("data", c.c_void_p), ("rhs", CALLBACK), ("jacobian", CALLBACK),
                ("time_derivative", CALLBACK), ("degrees_of_freedom", c.c_size_t), ("velocity_dependent", c.c_int),
                ("acceleration", ACCELERATION), ("absolute_tolerances", c.POINTER(c.c_double))]


CREATE = c.CFUNCTYPE(c.c_void_p, c.POINTER(System), c.c_double, c.POINTER(c.c_double))
STEP = c.CFUNCTYPE(c.c_int, c.c_void_p, c.c_double, c.c_double, c.POINTER(c.c_double))
SOLVE = c.CFUNCTYPE(c.c_int, c.c_void_p, c.POINTER(c.c_double), c.c_double, c.c_double, c.POINTER(c.c_double))
STEPS = c.CFUNCTYPE(c.c_uint64, c.c_void_p)
DESTROY = c.CFUNCTYPE(None, c.c_void_p)


class Solver(c.Structure):
    _fields_ = [("name", c.c_char_p), ("family", c.c_char_p), ("source", c.c_char_p), ("order", c.c_double), ("needs", c.c_uint32),
                ("create", CREATE), ("step", STEP), ("solve", SOLVE), ("steps", STEPS), ("destroy", DESTROY)]


class Plugin(c.Structure):
    _fields_ = [("version", c.c_uint32), ("name", c.c_char_p), ("solver_count", c.c_size_t), ("solvers", c.POINTER(Solver)),
                ("problem_count", c.c_size_t), ("problems", c.c_void_p)]


class Stopped(Exception):
    """The budget is spent."""


class Run:
    """A solve. The right-hand side is reached by its pointer."""

    def __init__(self, system, implicit):
        self.system, self.n, self.steps, self.solver, self.h = system, system.dimension, 0, None, None
        self.jac = {"jac": self.jacobian} if implicit else {}
        self.absolute = np.array(system.absolute_tolerances[:self.n]) if system.absolute_tolerances else None

    def called(self, function, t, y, size):
        y, out = np.ascontiguousarray(y, dtype=float), np.empty(size)
        if function(self.system.data, t, y.ctypes.data, out.ctypes.data) != 0:
            raise Stopped
        return out

    def rhs(self, t, y):
        return self.called(self.system.rhs, t, y, self.n)

    def jacobian(self, t, y):
        return self.called(self.system.jacobian, t, y, self.n * self.n).reshape(self.n, self.n)


def one_step_solve(method):
    """To each stop with steps that end there; the next begins with the step that the last one proposed."""
    def solve(run, t, stop, tolerance, y):
        first = None if run.h is None else min(run.h, stop - t)
        solver = method(run.rhs, t, y, stop, rtol=tolerance, atol=run.absolute, first_step=first, **run.jac)
        while solver.status == "running":
            if solver.step() is not None:
                return None
            run.steps += 1
            run.h = max(solver.h_abs, solver.step_size) if solver.status != "running" else solver.h_abs
        return solver.y if solver.status == "finished" else None
    return solve


def multistep_solve(method):
    """One run over all stops, where its polynomial is evaluated."""
    def solve(run, t, stop, tolerance, y):
        if run.solver is None:
            run.solver = method(run.rhs, t, y, np.inf, rtol=tolerance, atol=run.absolute, **run.jac)
        while run.solver.t < stop:
            if run.solver.step() is not None or run.solver.status == "failed":
                return None
            run.steps += 1
        return run.solver.dense_output()(stop) if run.solver.t > stop else run.solver.y
    return solve


def by_odeint(run, t, stop, tolerance, y):
    states, said = integrate.odeint(run.rhs, y, [t, stop], Dfun=run.jacobian, tfirst=True, full_output=True, rtol=tolerance,
                                    atol=run.absolute, mxstep=10**7, tcrit=[stop])
    run.steps += int(said["nst"][-1])
    return states[-1] if said["message"] == "Integration successful." else None


def fixed_step(method):
    def step(run, t, h, y):
        solver = method(run.rhs, t, y, t + h, rtol=1e10, atol=1e300, first_step=min(h, t + h - t))
        solver.step()
        return solver.y if solver.status == "finished" else None
    return step


def described(name, family, order, solve, step=None, implicit=False, note=""):
    runs = {}

    def guarded(call):
        """The callback's answer: 0 where it gave a state, which is put into y."""
        def answer(handle, y, *arguments):
            try:
                state = call(runs[handle], *arguments, np.array(y[:runs[handle].n]))
                if state is None:
                    return 1
                c.memmove(y, np.ascontiguousarray(state, dtype=float).ctypes.data, 8 * runs[handle].n)
                return 0
            except BaseException:  # nothing may pass through C
                return 1
        return answer

    def create(system, *_):
        handle = len(runs) + 1
        runs[handle] = Run(system.contents, implicit)
        return handle

    def solve_to(handle, t, stop, tolerance, y):
        answer = guarded(solve)(handle, y, t[0], stop, tolerance)
        if answer == 0:
            t[0] = stop
        return answer

    in_order = lambda run, t, h, y: step(run, t, h, y)  # noqa: E731
    return Solver(name.lower().encode(), family.encode(), f"SciPy {scipy.__version__}, {note or 'solve_ivp: ' + name}".encode(), order, 0,
                  CREATE(create), STEP((lambda handle, t, h, y: guarded(in_order)(handle, y, t, h)) if step else 0),
                  SOLVE(solve_to), STEPS(lambda handle: runs[handle].steps), DESTROY(lambda handle: runs.pop(handle, None) and None))


VARIES = float("nan")
SOLVERS = [
    described("RK23", "explicit_rk", 3, one_step_solve(integrate.RK23), fixed_step(integrate.RK23)),
    described("RK45", "explicit_rk", 5, one_step_solve(integrate.RK45), fixed_step(integrate.RK45)),
    described("DOP853", "explicit_rk", 8, one_step_solve(integrate.DOP853), fixed_step(integrate.DOP853)),
    described("Radau", "implicit_rk", 5, one_step_solve(integrate.Radau), implicit=True),
    described("BDF", "multistep", VARIES, multistep_solve(integrate.BDF), implicit=True),
    described("LSODA", "multistep", VARIES, multistep_solve(integrate.LSODA), implicit=True),
    described("odeint", "multistep", VARIES, by_odeint, implicit=True, note="odeint, which begins anew at each stop"),
]
LISTED = (Solver * len(SOLVERS))(*SOLVERS)
PLUGIN = Plugin(2, b"scipy", len(SOLVERS), LISTED, 0, None)
gc.freeze()  # solves are made in copies of this process, whose memory the collector would touch
