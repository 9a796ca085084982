# SPDX-License-Identifier: BSD-3-Clause
"""Reads a problem file by a small evaluator of its own, so that ends.py shares nothing with Odeum.

A text becomes the source of one Python function of t and y, with an element of an indexed state as a variable of its
own. Within a comparison the time is `clock`, which ends.py keeps inside of the interval between two switches."""
import math, re
import yaml

TOKEN = re.compile(r"\s*(?:(\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+(?:[eE][-+]?\d+)?)|([A-Za-z_]\w*)|(<=|>=|==|!=|[-+*/^()<>,\[\]]))")
FUNCTIONS = {name: getattr(math, name) for name in
             "sin cos tan asin acos atan atan2 hypot sinh cosh tanh exp log log10 sqrt".split()}
FUNCTIONS |= {"abs": abs, "min": min, "max": max, "sign": lambda x: float((x > 0) - (x < 0)), "pi": math.pi, "e": math.e}


class Text:
    """One expression, translated to Python."""

    def __init__(self, model, text, index=None):
        self.model, self.index, self.at, self.tokens = model, dict(index or {}), 0, []
        place, text = 0, str(text).strip()
        while place < len(text):
            found = TOKEN.match(text, place)
            if not found:
                raise ValueError(f"not understood: {text[place:]}")
            self.tokens.append(found.groups())
            place = found.end()

    def peek(self):
        token = self.tokens[self.at] if self.at < len(self.tokens) else (None, None, None)
        return token[2]

    def take(self, mark):
        if self.peek() != mark:
            return False
        self.at += 1
        return True

    def expect(self, mark):
        if not self.take(mark):
            raise ValueError(f"expected {mark} at token {self.at} of {self.tokens}")

    def whole(self):
        code = self.sum()
        if self.at != len(self.tokens):
            raise ValueError(f"a rest at token {self.at} of {self.tokens}")
        return code

    def sum(self):
        code = self.product()
        while self.peek() in ("+", "-"):
            mark = self.peek()
            self.at += 1
            code = f"({code} {mark} {self.product()})"
        return code

    def product(self):
        code = self.signed()
        while self.peek() in ("*", "/"):
            mark = self.peek()
            self.at += 1
            code = f"({code} {mark} {self.signed()})"
        return code

    def signed(self):
        if self.take("-"):
            return f"(-{self.signed()})"
        if self.take("+"):
            return self.signed()
        code = self.factor()
        if self.take("^"):
            code = f"power({code}, {self.signed()})"
        return code

    def factor(self):
        if self.take("("):
            code = self.sum()
            self.expect(")")
            return code
        number, name, _ = self.tokens[self.at]
        self.at += 1
        if number:
            return repr(float(number))
        if self.take("["):
            place = round(self.model.value(self.sum(), self.index))
            self.expect("]")
            return self.model.element(name, place)
        if self.peek() == "(":
            return self.call(name)
        if name in self.index:
            return repr(float(self.index[name]))
        return name + "_" if name not in ("t", "pi", "e") else name

    def call(self, name):
        self.expect("(")
        if name == "sum":
            return self.total()
        if name == "if":
            left, mark = self.sum(), self.peek()
            self.at += 1
            right = self.sum()
            self.model.conditions.append((left, right))
            clock = re.compile(r"\bt\b")
            condition = f"{clock.sub('clock', left)} {mark} {clock.sub('clock', right)}"
            self.expect(",")
            first = self.sum()
            self.expect(",")
            second = self.sum()
            self.expect(")")
            return f"({first} if {condition} else {second})"
        arguments = [self.sum()]
        while self.take(","):
            arguments.append(self.sum())
        self.expect(")")
        if name in ("abs", "min", "max", "sign"):
            self.model.conditions.append((arguments[0], (arguments + ["0.0"])[1]))
        return f"{name}({', '.join(arguments)})"

    def total(self):
        name = self.tokens[self.at][1]
        self.at += 1
        self.expect(",")
        begin = self.at
        counted = [self.tokens[k][1] for k in range(begin, len(self.tokens) - 1)
                   if self.tokens[k][1] in self.model.ranges and self.tokens[k + 2][1] == name]
        first, last = self.model.ranges[counted[0]]
        terms = []
        for k in range(first, last + 1):
            self.at, self.index[name] = begin, k
            terms.append(self.sum())
        del self.index[name]
        self.expect(")")
        return "(" + " + ".join(terms) + ")"


def power(base, exponent):
    """As pow of C has it, where Python would make a complex number or raise."""
    if base == 0 and exponent < 0:
        return math.inf
    if base < 0 and exponent != int(exponent):
        return math.nan
    return base ** (int(exponent) if exponent == int(exponent) else exponent)


class Model:
    """`rhs(t, y)` is a list; `y0`, `start`, `end` are numbers, and `clock` is a list of two, the interval's ends."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            text = yaml.load(file, yaml.BaseLoader)  # all as written: NO is a species
        self.conditions, self.ranges, self.beyond, self.clock = [], {}, {}, [-math.inf, math.inf]
        self.known = dict(FUNCTIONS, power=power)
        for name, value in (text.get("parameters") or {}).items():
            self.known[name + "_"] = self.value(Text(self, value).whole())
        states = self.elements(text["states"], True)
        self.names = list(states)
        self.y0 = [float(self.value(Text(self, value, index).whole())) for value, index in states.values()]
        for key, value in (text.get("boundaries") or {}).items():
            name, place = re.fullmatch(r"(\w+)\[(.+)\]", key).groups()
            self.beyond[name, round(self.value(Text(self, place).whole()))] = Text(self, value).whole()
        lines = [f"    {name}_ = {Text(self, value).whole()}" for name, value in (text.get("definitions") or {}).items()]
        equations = self.elements(text["equations"], False)
        rates = [Text(self, *equations[name]).whole() for name in self.names]
        begin = ["def rhs(t, y):", "    clock = min(max(t, limits[0]), limits[1])",
                 f"    [{', '.join(self.names)}] = y", *lines]
        self.known["limits"] = self.clock
        exec("\n".join([*begin, f"    return [{', '.join(rates)}]"]), self.known)
        sides = [f"({left}) - ({right})" for left, right in self.conditions]
        exec("\n".join([*begin, f"    return [{', '.join(sides)}]"]).replace("rhs", "sides", 1), self.known)
        self.rhs, self.sides = self.known["rhs"], self.known["sides"]
        time = {key: self.value(Text(self, value).whole()) for key, value in text["time"].items() if key != "stops"}
        self.start, self.end = float(time.get("start", 0)), float(time["end"])

    def value(self, code, index=None):
        return eval(code, dict(self.known), {name + "_": k for name, k in (index or {}).items()})

    def element(self, name, place):
        first, last = self.ranges[name]
        return f"{name}_{place}_" if first <= place <= last else f"({self.beyond[name, place]})"

    def elements(self, mapping, declares):
        """Name of each element, its text and its index."""
        found = {}
        for key, value in mapping.items():
            many = re.fullmatch(r"(\w+)\[(.+)\.\.(.+)\]", key)
            one = re.fullmatch(r"(\w+)\[([^.]+)\]", key)
            if many or one:
                name = (many or one)[1]
                limits = (many[2], many[3]) if many else (one[2], one[2])
                first, last = (round(self.value(Text(self, each).whole())) for each in limits)
                if declares:
                    before = self.ranges.get(name, (first, last))
                    self.ranges[name] = (min(first, before[0]), max(last, before[1]))
                for k in range(first, last + 1):
                    found[f"{name}_{k}_"] = (value, {"i": k})
            else:
                found[key + "_"] = (value, None)
        return found
