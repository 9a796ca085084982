# SPDX-License-Identifier: BSD-3-Clause
"""Odeum from Python: advice, diagnosis, runs and judgement of initial value problems, measured by the program odeum.

    >>> import numpy as np, odeum
    >>> def pendulum(t, y):
    ...     return [y[1], -np.sin(y[0])]
    >>> odeum.advise(pendulum, [1.0, 0.0], (0, 10), error=1e-6).solver      # doctest: +SKIP
    'odeum/dormand_prince853'

A problem is a function of Python with its initial state and interval, which is translated into a text that Odeum
differentiates and compiles (see `text_of`) or, where no text can say it, called in processes of its own (see `Called`); or the
id of a case, or the path of a file that the program reads. The program
is found in ODEUM_PROGRAM, or on the path. Functions raise OdeumError where the program refuses, with its own sentence.
"""
from ._calls import Advice, Judgement, Runs, advise, frame, judge, run, why
from ._program import OdeumError
from ._served import Called
from ._trace import NotTranslatable, Problem, problem, text_of

__all__ = ["Advice", "Called", "Judgement", "NotTranslatable", "OdeumError", "Problem", "Runs", "advise", "frame", "judge", "problem",
           "run", "text_of", "why"]
__version__ = "0.1.0"
