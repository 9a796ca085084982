# SPDX-License-Identifier: BSD-3-Clause
"""A function of Python as a text: it is called once with symbols in place of numbers, which write down what is done with them.

The text is compared with the function at states around the initial one, so that a function that depends on more than its
arguments is refused. What the text has no word for raises NotTranslatable with the reason.
"""
from __future__ import annotations

import inspect
import math
import random
import types
from dataclasses import dataclass
from typing import Any, Callable, Sequence

import numpy as np


class NotTranslatable(ValueError):
    """The function does something that a text cannot say, or is another function of the same arguments when called again."""


# Levels of binding: a sum, a product, a sign, a power, an operand.
SUM, PRODUCT, SIGN, POWER, OPERAND = range(5)
LONGEST = 1_000_000

# The functions of a text, by their names in NumPy: the text's name, and the value.
FUNCTIONS: dict[str, tuple[str, Callable[..., float]]] = {
    "sin": ("sin", math.sin), "cos": ("cos", math.cos), "tan": ("tan", math.tan), "arcsin": ("asin", math.asin),
    "arccos": ("acos", math.acos), "arctan": ("atan", math.atan), "arctan2": ("atan2", math.atan2), "hypot": ("hypot", math.hypot),
    "sinh": ("sinh", math.sinh), "cosh": ("cosh", math.cosh), "tanh": ("tanh", math.tanh), "exp": ("exp", math.exp),
    "log": ("log", math.log), "log10": ("log10", math.log10), "sqrt": ("sqrt", math.sqrt), "absolute": ("abs", abs),
    "fabs": ("abs", abs), "sign": ("sign", lambda x: float(np.sign(x))), "minimum": ("min", min), "maximum": ("max", max),
    "floor": ("floor", math.floor), "ceil": ("ceil", math.ceil), "remainder": ("mod", lambda a, b: float(np.mod(a, b))),
}
# The names of the module math, where they are others.
OF_MATH = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2"}


def number(value: Any) -> str:
    value = float(value)
    if not math.isfinite(value):
        raise NotTranslatable(f"the function has the constant {value}, which a text cannot say")
    return str(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)


class Symbol:
    """An expression: its text, how tightly it binds, and its value where the symbols in it have values."""

    __slots__ = ("text", "level", "value")

    def __init__(self, text: str, level: int, value: Callable[[dict], float]):
        if len(text) > LONGEST:
            raise NotTranslatable(f"the text of one equation is longer than {LONGEST} letters")
        self.text, self.level, self.value = text, level, value

    def within(self, level: int) -> str:
        return self.text if self.level >= level else f"({self.text})"

    def __add__(self, other): return binary("+", SUM, self, other, lambda a, b: a + b)
    def __radd__(self, other): return binary("+", SUM, other, self, lambda a, b: a + b)
    def __sub__(self, other): return binary("-", SUM, self, other, lambda a, b: a - b)
    def __rsub__(self, other): return binary("-", SUM, other, self, lambda a, b: a - b)
    def __mul__(self, other): return binary("*", PRODUCT, self, other, lambda a, b: a * b)
    def __rmul__(self, other): return binary("*", PRODUCT, other, self, lambda a, b: a * b)
    def __truediv__(self, other): return binary("/", PRODUCT, self, other, lambda a, b: a / b)
    def __rtruediv__(self, other): return binary("/", PRODUCT, other, self, lambda a, b: a / b)
    def __pow__(self, other): return binary("^", POWER, self, other, lambda a, b: a ** b)
    def __rpow__(self, other): return binary("^", POWER, other, self, lambda a, b: a ** b)
    def __mod__(self, other): return call("remainder", self, other)
    def __rmod__(self, other): return call("remainder", other, self)
    def __neg__(self): return Symbol("-" + self.within(POWER), SIGN, lambda at, s=self: -s.value(at))
    def __pos__(self): return self
    def __abs__(self): return call("absolute", self)
    def __lt__(self, other): return Condition("<", self, other, lambda a, b: a < b)
    def __le__(self, other): return Condition("<=", self, other, lambda a, b: a <= b)
    def __gt__(self, other): return Condition(">", self, other, lambda a, b: a > b)
    def __ge__(self, other): return Condition(">=", self, other, lambda a, b: a >= b)

    def __float__(self):
        raise NotTranslatable("the function makes a number of a state, as float() or an array of numbers does")

    def __bool__(self):
        raise NotTranslatable("the function asks whether a state is zero; numpy.where(condition, a, b) can be translated")

    def __array_ufunc__(self, ufunc, method, *arguments, **_):
        if method != "__call__":
            return NotImplemented
        if any(isinstance(each, np.ndarray) and each.ndim > 0 for each in arguments):
            return ufunc(*(np.array(each, dtype=object) if isinstance(each, Symbol) else each.astype(object)
                           if isinstance(each, np.ndarray) else each for each in arguments))
        return of_ufunc(ufunc.__name__, *arguments)

    def __array_function__(self, function, _, arguments, __):
        if function is np.where and len(arguments) == 3:
            return where(*arguments)
        return NotImplemented

    def __getattr__(self, name):  # NumPy calls a method of its ufunc's name on elements of an array of objects
        if name in FUNCTIONS:
            return lambda *others: call(name, self, *others)
        raise AttributeError(name)


class Condition:
    """A comparison; its text has `and`, `or` and `not`."""

    def __init__(self, sign: str, a, b, holds: Callable[[float, float], bool]):
        left, right = as_symbol(a), as_symbol(b)
        self.text = f"{left.text} {sign} {right.text}"
        self.holds: Callable[[dict], bool] = lambda at: holds(left.value(at), right.value(at))

    def joined(self, word: str, other: "Condition", holds) -> "Condition":
        made = object.__new__(Condition)
        made.text = f"({self.text}) {word} ({other.text})"
        made.holds = holds
        return made

    def __and__(self, other): return self.joined("and", other, lambda at: self.holds(at) and other.holds(at))
    def __or__(self, other): return self.joined("or", other, lambda at: self.holds(at) or other.holds(at))

    def __bool__(self):
        raise NotTranslatable("the function branches on a state, as `if` does; numpy.where(condition, a, b) can be translated")

    def __array_function__(self, function, _, arguments, __):
        return where(*arguments) if function is np.where and len(arguments) == 3 else NotImplemented


def as_symbol(value: Any) -> Symbol:
    if isinstance(value, Symbol):
        return value
    if isinstance(value, np.ndarray) and value.ndim == 0:
        return as_symbol(value.item())
    text = number(value)
    return Symbol(text, SIGN if text.startswith("-") else OPERAND, lambda _, x=float(value): x)


def binary(sign: str, level: int, a, b, value) -> Any:
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        return NotImplemented
    left, right = as_symbol(a), as_symbol(b)
    # The zeros and ones of matrices would hide which entries of the Jacobian are zero.
    if sign == "*" and "0" in (left.text, right.text):
        return as_symbol(0)
    if (sign, left.text) in (("+", "0"), ("*", "1")):
        return right
    if (sign, right.text) in (("+", "0"), ("-", "0"), ("*", "1"), ("/", "1")):
        return left
    # A power binds to the right; of a difference and a quotient the right operand stands in brackets.
    stronger = level + 1
    text = left.within(stronger if sign == "^" else level) + ("^" if sign == "^" else f" {sign} ") + right.within(stronger)
    return Symbol(text, level, lambda at: value(left.value(at), right.value(at)))


def call(name: str, *arguments) -> Symbol:
    word, function = FUNCTIONS[name]
    given = [as_symbol(each) for each in arguments]
    return Symbol(f"{word}({', '.join(each.text for each in given)})", OPERAND, lambda at: function(*(each.value(at) for each in given)))


def where(condition, a, b) -> Symbol:
    if not isinstance(condition, Condition):
        return a if condition else b
    yes, no = as_symbol(a), as_symbol(b)
    return Symbol(f"if({condition.text}, {yes.text}, {no.text})", OPERAND, lambda at: (yes if condition.holds(at) else no).value(at))


def of_ufunc(name: str, *arguments):
    operators = {"add": "__add__", "subtract": "__sub__", "multiply": "__mul__", "divide": "__truediv__", "true_divide": "__truediv__",
                 "power": "__pow__", "float_power": "__pow__", "less": "__lt__", "less_equal": "__le__", "greater": "__gt__",
                 "greater_equal": "__ge__"}
    if name in operators:
        return getattr(as_symbol(arguments[0]), operators[name])(arguments[1])
    if name == "negative":
        return -as_symbol(arguments[0])
    if name == "square":
        return as_symbol(arguments[0]) * arguments[0]
    if name not in FUNCTIONS:
        raise NotTranslatable(f"the function calls numpy.{name}, which a text has no word for")
    return call(name, *arguments)


def with_symbolic_math(f: Callable) -> Callable:
    """The function with a module math that takes symbols, where it is written in Python."""
    if not isinstance(f, types.FunctionType):
        return f

    def of_math(name):
        numpy_name = OF_MATH.get(name, {"fabs": "absolute"}.get(name, name))
        if numpy_name not in FUNCTIONS:
            return getattr(math, name)
        return lambda *given: call(numpy_name, *given) if any(isinstance(g, Symbol) for g in given) else getattr(math, name)(*given)

    module = types.SimpleNamespace(**{name: of_math(name) if callable(getattr(math, name)) else getattr(math, name)
                                      for name in dir(math) if not name.startswith("_")})
    taken = {id(getattr(math, name)): getattr(module, name) for name in vars(module) if callable(getattr(math, name))}
    scope = {name: module if value is math else taken.get(id(value), value) for name, value in f.__globals__.items()}
    made = types.FunctionType(f.__code__, scope, f.__name__, f.__defaults__, f.__closure__)
    made.__kwdefaults__ = f.__kwdefaults__
    return made


@dataclass(frozen=True)
class Problem:
    """A problem as a text of the program, with the names of its states in their order."""
    text: str
    names: tuple[str, ...]


def parameters_of(f: Callable, args: Sequence, states: Sequence[str]) -> list[str]:
    """Names for the numbers among the further arguments, from the function's signature."""
    try:
        names = list(inspect.signature(f).parameters)[2:]
    except (TypeError, ValueError):
        names = []
    names += [f"p{k}" for k in range(len(names), len(args))]
    taken = {"t", "e", "pi", "if", "and", "or", "not", *(word for word, _ in FUNCTIONS.values()), *states}
    return [name if isinstance(value, (int, float, np.integer, np.floating)) and name not in taken and name.isascii() and
            not name.startswith("_") else "" for name, value in zip(names, args)]


def problem(f: Callable, y0: Sequence[float], span: tuple[float, float], args: Sequence = (), names: Sequence[str] | None = None,
            title: str | None = None) -> Problem:
    """f(t, y, *args), as SciPy's solve_ivp takes it, from y0 over span = (start, end), as a text. Numbers among args become
    parameters of their names; `names` are those of the states, y0, y1, ... by default. Raises NotTranslatable."""
    start = [float(value) for value in np.atleast_1d(np.asarray(y0, dtype=float))]
    states = tuple(names) if names is not None else tuple(f"y{k}" for k in range(len(start)))
    if len(states) != len(start):
        raise ValueError(f"names: got {len(states)}, expected one for each of {len(start)} states")
    symbols = {name: Symbol(name, OPERAND, lambda at, name=name: at[name]) for name in ("t", *states)}
    given = parameters_of(f, args, states)
    further = [Symbol(name, OPERAND, lambda at, name=name: at[name]) if name else value for name, value in zip(given, args)]
    y = np.empty(len(states), dtype=object)
    y[:] = [symbols[name] for name in states]
    try:
        rates = with_symbolic_math(f)(symbols["t"], y, *further)
    except NotTranslatable:
        raise
    except Exception as error:
        raise NotTranslatable(f"the function cannot be called with symbols: {error}") from error
    rates = [as_symbol(rate) for rate in np.ravel(np.asarray(rates, dtype=object))]
    if len(rates) != len(states):
        raise ValueError(f"the function gives {len(rates)} rates for {len(states)} states")
    values = {name: float(value) for name, value in zip(given, args) if name}
    compare(f, rates, states, start, span, args, values)
    lines = [f"name: {title or getattr(f, '__name__', 'problem').strip('<>')}"]
    if values:
        lines.append("parameters: {" + ", ".join(f"{name}: {number(value)}" for name, value in values.items()) + "}")
    lines.append("states: {" + ", ".join(f"{name}: {number(value)}" for name, value in zip(states, start)) + "}")
    lines.append("equations:")
    lines += [f'  {name}: "{rate.text}"' for name, rate in zip(states, rates)]
    lines.append(f"time: {{start: {number(span[0])}, end: {number(span[1])}}}")
    return Problem("\n".join(lines) + "\n", states)


def compare(f, rates, states, start, span, args, values) -> None:
    """Raises NotTranslatable where the text is not the function at states around the initial one."""
    draw = random.Random(1)
    for k in range(8):
        t = span[0] + (span[1] - span[0]) * k / 8
        y = [value + (abs(value) + 0.1) * 0.1 * k / 8 * draw.uniform(-1, 1) for value in start]
        try:
            theirs = np.ravel(np.asarray(f(t, np.array(y), *args), dtype=float))
            ours = [rate.value({"t": t, **values, **dict(zip(states, y))}) for rate in rates]
        except (ArithmeticError, ValueError):
            continue
        for name, a, b in zip(states, theirs, ours):
            # The same operations, of which NumPy may round some otherwise.
            if not abs(a - b) <= 1e-12 * (abs(a) + abs(b)) + 1e-300 and math.isfinite(a):
                raise NotTranslatable(f"the rate of {name} at t = {t} is {a} when the function is called and {b} by its text: "
                                      "it depends on more than its arguments")


def text_of(f: Callable, y0: Sequence[float], span: tuple[float, float], args: Sequence = (), names: Sequence[str] | None = None) -> str:
    """The text of a problem, to be kept in a file for the program's own commands."""
    return problem(f, y0, span, args, names).text
