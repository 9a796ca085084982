# SPDX-License-Identifier: BSD-3-Clause
"""The questions of the program as functions."""
from __future__ import annotations

import contextlib
import os
import pathlib
import tempfile
from dataclasses import dataclass, field
from typing import Any, Callable, Iterator, Mapping, Sequence, Union

import numpy as np

from ._program import OdeumError, said
from ._served import Called, served
from ._trace import NotTranslatable, Problem, problem as problem_of

Stated = Union[str, "os.PathLike[str]", Problem, Callable]


def rows_of(records: Sequence[Mapping[str, Any]]) -> np.ndarray:
    """Rows as a structured array: texts as texts, all else as float, of which what is not known is nan. Lists are
    left out."""
    names = list(dict.fromkeys(name for row in records for name, value in row.items() if not isinstance(value, (list, dict))))
    columns, types = [], []
    for name in names:
        values = [row.get(name) for row in records]
        if any(isinstance(value, str) for value in values):
            column = np.array(["" if value is None else str(value) for value in values])
        else:
            column = np.array([np.nan if value is None else float(value) for value in values])
        columns.append(column)
        types.append((name, column.dtype))
    rows = np.empty(len(records), dtype=types)
    for name, column in zip(names, columns):
        rows[name] = column
    return rows


def frame(rows: np.ndarray):
    """The rows as a DataFrame of pandas, which has to be installed."""
    import pandas  # noqa: PLC0415  (optional)
    return pandas.DataFrame({name: rows[name] for name in rows.dtype.names})


@dataclass(frozen=True)
class Word:
    """The words of the command line for a problem, a folder for files that ends with the call, what the program finds in its
    environment, and what was counted of a function that is called."""
    words: Sequence[str]
    folder: pathlib.Path
    environment: Mapping[str, str] = field(default_factory=dict)
    called: Callable[[], Union[Called, None]] = lambda: None

    def said(self, command: str, *words: str) -> Any:
        try:
            return said(command, *self.words, *words, environment=self.environment)
        except OdeumError as error:
            counted = self.called()
            if counted is None or not counted.raised:
                raise
            raise OdeumError(f"{error}; the function raised {counted.raised}") from None


@contextlib.contextmanager
def stated(problem: Stated, y0, span, args, names) -> Iterator[Word]:
    is_function = callable(problem) and not isinstance(problem, Problem)
    if is_function and (y0 is None or span is None):
        raise TypeError("a function needs its initial state y0 and its interval span = (start, end)")
    if not is_function and (y0 is not None or span is not None):
        raise TypeError("y0 and span belong to a function; a case, a file or a Problem has its own")
    with tempfile.TemporaryDirectory(prefix="odeum") as folder:
        where = pathlib.Path(folder)
        if is_function:
            try:
                problem = problem_of(problem, y0, span, args, names)
            except NotTranslatable as reason:
                with served(problem, y0, span, args, where, str(reason)) as (words, environment, called):
                    yield Word(words, where, environment, called)
                return
        if isinstance(problem, Problem):
            (where / "problem.yaml").write_text(problem.text, encoding="utf-8")
            yield Word([str(where / "problem.yaml")], where)
        else:
            yield Word([os.fspath(problem)], where)


def setting(step, tol, rtol, atol) -> list[str]:
    words = []
    for name, value in (("--step", step), ("--tol", tol), ("--rtol", rtol)):
        if value is not None:
            words += [name, repr(float(value))]
    if atol is not None:
        words += ["--atol", ",".join(repr(float(value)) for value in np.atleast_1d(atol))]
    return words


def replaced(parameters: Mapping[str, float] | None) -> list[str]:
    return [word for name, value in (parameters or {}).items() for word in ("--set", f"{name}={float(value)!r}")]


@dataclass(frozen=True)
class Runs:
    """Runs of solvers: a row each (status, error, evaluations, ...), the states of each at its outputs (time and components), and
    those of all with the truth's where `every` was given. `called`: of a function that no text can say."""
    rows: np.ndarray
    states: Sequence[np.ndarray]
    trajectory: np.ndarray | None = None
    called: Called | None = None


def run(problem: Stated, y0=None, span=None, *, solver: str | Sequence[str], step: float | None = None, tol: float | None = None,
        rtol: float | None = None, atol=None, every: float | None = None, until: float | None = None,
        parameters: Mapping[str, float] | None = None, args: Sequence = (), names: Sequence[str] | None = None) -> Runs:
    """Runs solvers ("rk4", "cvode/bdf", ...) at a step or to a tolerance. The error is the largest against the problem's truth."""
    solvers = [solver] if isinstance(solver, str) else list(solver)
    with stated(problem, y0, span, args, names) as word:
        words = [*(w for each in solvers for w in ("--solver", each)), *setting(step, tol, rtol, atol), *replaced(parameters)]
        if until is not None:
            words += ["--until", repr(float(until))]
        if every is not None:
            words += ["--every", repr(float(every)), "--out", str(word.folder / "out")]
        runs = word.said("run", *words)["runs"]
        trajectory = None
        if every is not None:
            trajectory = np.genfromtxt(word.folder / "out" / "trajectory.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
        states = [rows_of([{"time": state["time"], **state["y"]} for state in run.get("states", [])]) for run in runs]
        return Runs(rows_of(runs), states, trajectory, word.called())


@dataclass(frozen=True)
class Advice:
    """The solver and setting of least measured time that keep the error; `runners_up` has a row each. `called`: of a function
    that no text can say."""
    solver: str
    setting_kind: str
    setting: float
    error: float
    time_ns: float
    limited_by: str
    runners_up: np.ndarray
    all: Mapping[str, Any] = field(repr=False)
    called: Called | None = None


def advise(problem: Stated, y0=None, span=None, *, error: float | None = None, time: float | None = None, seconds: float | None = None,
           parameters: Mapping[str, float] | None = None, args: Sequence = (), names: Sequence[str] | None = None) -> Advice:
    """The answer of `odeum advise` to an error that is asked for, or to a time in seconds; `seconds` bounds the search. Raises
    OdeumError where no solver reaches it."""
    if (error is None) == (time is None):
        raise TypeError("one of error and time is asked for")
    with stated(problem, y0, span, args, names) as word:
        goal = ["--error", repr(float(error))] if error is not None else ["--time", repr(float(time or 0))]
        bound = [] if seconds is None else ["--seconds", repr(float(seconds))]
        answer = word.said("advise", *goal, *bound, *replaced(parameters))
        called = word.called()
    known = {name: answer.get(name) for name in ("solver", "setting_kind", "setting", "error", "time_ns", "limited_by")}
    return Advice(**known, runners_up=rows_of(answer.get("runners_up", [])), all=answer, called=called)


def why(problem: Stated, y0=None, span=None, *, solver: str, step: float | None = None, tol: float | None = None,
        rtol: float | None = None, atol=None, parameters: Mapping[str, float] | None = None, args: Sequence = (),
        names: Sequence[str] | None = None) -> Mapping[str, Any]:
    """What a run spends its steps on, why it failed, and what does better: `summary`, `causes`, `others`, as `odeum why` prints
    them."""
    with stated(problem, y0, span, args, names) as word:
        return word.said("why", "--solver", solver, *setting(step, tol, rtol, atol), *replaced(parameters))


@dataclass(frozen=True)
class Judgement:
    """The verdict on numbers that were made elsewhere; `files` has a row for each solution, with its error."""
    verdict: str
    measured_order: float
    likeliest: str
    mistake: str
    reason: str
    files: np.ndarray

    @property
    def error(self) -> float:
        """The largest error of the last solution."""
        return float(self.files["error"][-1])


def table_of(solution) -> np.ndarray:
    """Rows of t and states, of SciPy's result or of (t, states) with a row or a column a time."""
    t, y = (solution.t, solution.y) if hasattr(solution, "t") and hasattr(solution, "y") else solution
    t, y = np.asarray(t, dtype=float), np.atleast_2d(np.asarray(y, dtype=float))
    if hasattr(solution, "y") or y.shape[0] != t.size:
        y = y.T
    if y.shape[0] != t.size:
        raise ValueError(f"got {t.size} times and states of the shape {y.T.shape}, expected a row or a column a time")
    return np.column_stack([t, y])


def judge(problem: Stated, solution, y0=None, span=None, *, claims: str | None = None, order: float | None = None,
          parameters: Mapping[str, float] | None = None, args: Sequence = (), names: Sequence[str] | None = None) -> Judgement:
    """Numbers of another program against the truth of a problem. `solution` is a result of SciPy's solve_ivp, or (t, states); a
    mapping from steps to these, of which the order is measured; or the path of a file. `claims`: the method that they are said
    to be, such as "rk4". What is wrong in them is named where it is visible."""
    with stated(problem, y0, span, args, names) as word:
        if isinstance(solution, (str, os.PathLike)):
            files = [os.fspath(solution)]
        else:
            files = []
            several = solution if isinstance(solution, Mapping) and not hasattr(solution, "t") else {None: solution}
            for step, each in several.items():
                path = word.folder / ("solution.npy" if step is None else f"solution_h{float(step)!r}.npy")
                np.save(path, table_of(each))
                files.append(str(path))
        words = [] if claims is None else ["--claims", claims]
        words += [] if order is None else ["--order", repr(float(order))]
        answer = word.said("judge", *files, *words, *replaced(parameters))
    judged = answer["judged.csv"][0]
    measured = judged["measured_order"]
    return Judgement(judged["verdict"], float("nan") if measured is None else measured, judged["likeliest"], judged["mistake"],
                     judged["reason"], rows_of(answer["files.csv"]))
