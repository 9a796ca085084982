# SPDX-License-Identifier: BSD-3-Clause
"""Texts with events and random parameters, whose solutions are known in closed form: what campaign.py asks the truth about."""
import random
from mpmath import mp, mpf, exp, log, sqrt, sin, pi, floor

mp.dps = 40


def number(rng, low, high, digits=3):
    """A decimal, as a text has it and exactly."""
    word = f"{rng.uniform(low, high):.{digits}f}"
    return word, mpf(word)


def states_of(pieces, t):
    """The states at t of pieces (begin, function of t), of which the last that has begun holds."""
    return [piece for begin, piece in pieces if begin <= t][-1](t)


# Each returns the text, a function of t that gives the states by name (None: there are none), and how many events there are.
def thermostat(rng, end):
    (a, a_), (out, out_), (gain, gain_) = number(rng, 0.05, 0.4), number(rng, 5, 12), number(rng, 8, 15)
    low, high = "18.5", "21.25"
    pieces, t, x, on, count = [], mpf(0), mpf(20), 1, 0
    while t < end:
        rest = out_ + gain_ * 2 * on
        pieces.append((t, lambda s, t=t, x=x, rest=rest, on=on: {"x": rest + (x - rest) * exp(-a_ * (s - t)), "u": on}))
        to = mpf(high if on else low)
        t, x, on = t + log((rest - x) / (rest - to)) / a_, to, 1 - on
        count += t < end
    return f"""states: {{x: 20, u: 1}}
equations: {{x: -{a}*(x - {out} - {gain}*2*u), u: 0}}
time: {{end: {end}}}
events:
  - {{when: x - {high}, rising: true, set: {{u: 0}}}}
  - {{when: x - {low}, falling: true, set: {{u: 1}}}}
""", lambda s: states_of(pieces, s), count


def neuron(rng, end):
    (tau, tau_), (drive, drive_) = number(rng, 0.5, 2), number(rng, 1.2, 3)
    period = tau_ * log(drive_ / (drive_ - 1))
    count = int(floor(end / period))
    return f"""states: {{v: 0, n: 0}}
equations: {{v: ({drive} - v)/{tau}, n: 0}}
time: {{end: {end}}}
events:
  - {{when: v - 1, rising: true, set: {{v: 0, n: n + 1}}}}
""", lambda s: {"v": drive_ * (1 - exp(-(s - period * floor(s / period)) / tau_)), "n": floor(s / period)}, count


def ball(rng, bounces, after=0):
    (r, r_), (h, h_), g = number(rng, 0.5, 0.95), number(rng, 0.3, 2), mpf("9.81")
    hit, speed, pieces, hits = sqrt(2 * h_ / g), sqrt(2 * h_ * g), [(mpf(0), lambda s: {"h": h_ - g * s * s / 2, "v": -g * s})], []
    for _ in range(bounces + 1):
        hits.append(hit)
        speed *= r_
        pieces.append((hit, lambda s, t=hit, v=speed: {"h": v * (s - t) - g * (s - t) ** 2 / 2, "v": v - g * (s - t)}))
        hit += 2 * speed / g
    rest = hits[0] + 2 * r_ * hits[0] / (1 - r_)
    end = mpf(f"{float((hits[-2] + 2 * hits[-1]) / 3):.6f}") if not after else mpf(f"{float(after * rest):.6f}")
    return f"""states: {{h: {h}, v: 0}}
equations: {{h: v, v: -9.81}}
time: {{end: {mp.nstr(end, 12)}}}
events:
  - {{when: h, falling: true, set: {{h: 0, v: -{r}*v}}}}
""", (lambda s: states_of(pieces, s)) if not after else (lambda s: None if s >= rest else states_of(pieces, s)), bounces


def logistic(rng, end):
    (rate, rate_), (low, low_), (high, high_) = number(rng, 0.5, 2), number(rng, 0.1, 0.4), number(rng, 0.6, 0.9)
    logit = lambda x: log(x / (1 - x))
    first, period = (logit(high_) - logit(mpf("0.05"))) / rate_, (logit(high_) - logit(low_)) / rate_
    def at(s):
        z = logit(mpf("0.05")) + rate_ * s if s < first else logit(low_) + rate_ * ((s - first) - period * floor((s - first) / period))
        return {"x": 1 / (1 + exp(-z))}
    return f"""states: {{x: 0.05}}
equations: {{x: {rate}*x*(1 - x)}}
time: {{end: {end}}}
events:
  - {{when: x - {high}, rising: true, set: {{x: {low}}}}}
""", at, int(floor((end - first) / period)) + 1


def kicked(rng, end):
    kick, kick_ = number(rng, 0.1, 0.5)
    def at(s):
        # x = cos until x rises through 0 at 3 pi/2, then v grows by the kick each turn
        n = floor((s - 3 * pi / 2) / (2 * pi)) + 1
        size, phase = 1 + n * kick_, s - 3 * pi / 2
        return {"x": size * sin(phase), "v": size * mp.cos(phase)}
    return f"""states: {{x: 1, v: 0}}
equations: {{x: v, v: -x}}
time: {{end: {end}}}
events:
  - {{when: x, rising: true, set: {{v: v + {kick}}}}}
""", at, int(floor((end - 3 * pi / 2) / (2 * pi))) + 1


def counted(rng, end, zero, zeros, slow=0):
    """Zeros of a function of the time, along a slow solution, whose steps are long: their number and sum."""
    def at(s):
        past = [z for z in zeros if z <= s]
        return {"y": exp(-mpf(slow) * s), "n": mpf(len(past)), "sum": sum(past, mpf(0))}
    return f"""states: {{y: 1, n: 0, sum: 0}}
equations: {{y: -{slow}*y, n: 0, sum: 0}}
time: {{end: {end}}}
events:
  - {{when: "{zero}", set: {{n: n + 1, sum: sum + t}}}}
""", at, len(zeros)


def two_at_once(rng, order):
    (x, x_), (rate, rate_) = number(rng, 0.1, 0.9), number(rng, 0.5, 2)
    hit = (1 - x_) / rate_
    def at(s):
        if s < hit:
            return {"x": x_ + rate_ * s, "y": 2 * x_ + 2 * rate_ * s, "z": mpf(1)}
        z = mpf(1 * 3 + 1) if order == "first" else mpf((1 + 1) * 3)
        return {"x": rate_ * (s - hit), "y": 2 * rate_ * (s - hit), "z": z}
    one, two = (1, 2) if order == "first" else (2, 1)
    return f"""states: {{x: {x}, y: {2 * x_}, z: 1}}
equations: {{x: {rate}, y: 2*{rate}, z: 0}}
time: {{end: {mp.nstr(hit * mpf('1.5'), 8)}}}
events:
  - {{when: x - 1, rising: true, order: {one}, set: {{x: 0, z: 3*z}}}}
  - {{when: y - 2, rising: true, order: {two}, set: {{y: 0, z: z + 1}}}}
""", at, 2


def touching(rng, above):
    (t0, t0_), end = number(rng, 0.7, 1.4), 3
    gap = mpf(above)
    zeros = [] if gap > 0 else [t0_] if gap == 0 else [t0_ - sqrt(-gap), t0_ + sqrt(-gap)]
    def at(s):
        return {"x": (s - t0_) ** 2 + gap, "n": mpf(len([z for z in zeros if z <= s]))}
    return f"""states: {{x: {mp.nstr(t0_ ** 2 + gap, 30)}, n: 0}}
equations: {{x: 2*(t - {t0}), n: 0}}
time: {{end: {end}}}
events:
  - {{when: x, set: {{n: n + 1}}}}
""", at, len(zeros)


def at_start(rng, sign, sense):
    rate, rate_ = number(rng, 0.5, 2)
    back = log(mpf(2))  # x = 1 - e^-t goes up, and below 0 never
    return f"""states: {{x: 0, n: 0}}
equations: {{x: {sign}{rate}*exp(-t), n: 0}}
time: {{end: 3}}
events:
  - {{when: x, {sense}set: {{n: n + 1}}}}
  - {{when: x - {sign}{rate}/2, set: {{n: n + 10}}}}
""", lambda s: {"x": mpf(f"{sign}1") * rate_ * (1 - exp(-s)), "n": mpf(10 if s >= back else 0)}, 1


def on_stop(rng, rate, level, stop):
    """x reaches a level at a stop, exactly; the state there is that after the event."""
    return f"""states: {{x: 0, u: 1}}
equations: {{x: {rate}*u, u: 0}}
time: {{end: {2 * stop}, stops: [{stop}, {2 * stop}]}}
events:
  - {{when: x - {level}, rising: true, set: {{u: -1, x: x + 1}}}}
""", lambda s: {"x": mpf(rate) * s, "u": mpf(1)} if s < stop else {"x": mpf(level) + 1 - mpf(rate) * (s - stop), "u": mpf(-1)}, 1


def doses(rng, end, every):
    (k, k_), (first, first_), (dose, dose_), (apart, apart_) = (number(rng, 0.05, 0.5), number(rng, 0.5, 3), number(rng, 1, 9),
                                                                number(rng, every, 1.5 * every))
    times = []
    while not times or times[-1] + apart_ <= end:
        times.append(first_ + apart_ * len(times))
    return f"""states: {{c: 0, area: 0}}
equations: {{c: -{k}*c, area: c}}
time: {{end: {end}}}
events:
  - {{at: {first}, every: {apart}, set: {{c: c + {dose}}}}}
""", lambda s: {"c": sum((dose_ * exp(-k_ * (s - t)) for t in times if t <= s), mpf(0)),
                "area": sum((dose_ * (1 - exp(-k_ * (s - t))) / k_ for t in times if t <= s), mpf(0))}, len(times)


def table(rng):
    """x' = w(t), linear between points; x is reset where it reaches 1."""
    words = [number(rng, 0.2, 2, 2) for _ in range(6)]
    def area(a, b):
        total = mpf(0)
        for k in range(5):
            low, high = max(a, mpf(k)), min(b, mpf(k + 1))
            if low < high:
                w = lambda t: words[k][1] + (words[k + 1][1] - words[k][1]) * (t - k)
                total += (high - low) * (w(low) + w(high)) / 2
        return total
    hits, begin = [], mpf(0)
    while area(begin, mpf(5)) > 1:
        low, high = begin, mpf(5)
        for _ in range(140):
            middle = (low + high) / 2
            low, high = (middle, high) if area(begin, middle) < 1 else (low, middle)
        begin = high
        hits.append(begin)
    at = lambda s: {"x": area(max([h for h in hits if h <= s], default=mpf(0)), s), "n": mpf(len([h for h in hits if h <= s]))}
    points = ", ".join(f"[{k}, {word}]" for k, (word, _) in enumerate(words))
    return f"""tables: {{w: {{points: [{points}], between: linear}}}}
states: {{x: 0, n: 0}}
equations: {{x: w(t), n: 0}}
time: {{end: 4.9}}
events:
  - {{when: x - 1, rising: true, set: {{x: 0, n: n + 1}}}}
""", at, len([h for h in hits if h < mpf("4.9")])


def delayed(rng):
    (rate, rate_), (delay, delay_) = number(rng, 0.5, 2), number(rng, 0.1, 0.6)
    rest = 1 / rate_ + delay_
    return f"""states: {{x: 0, n: 0}}
equations: {{x: {rate}, n: 0}}
time: {{end: {mp.nstr(rest * mpf('1.7'), 8)}}}
events:
  - {{when: x > 1 and t < 100, delay: {delay}, set: {{x: x - 5, n: n + t}}}}
""", lambda s: {"x": rate_ * s - (5 if s >= rest else 0), "n": rest if s >= rest else mpf(0)}, 1


def sliding(rng, form):
    """A relay without hysteresis: from the first zero on the motion slides along it, and no event text has that solution."""
    rate, rate_ = number(rng, 0.5, 2)
    hit = 1 / rate_
    if form == "events":
        body = f"""states: {{x: 1, u: -1}}
equations: {{x: {rate}*u, u: 0}}
time: {{end: 5}}
events:
  - {{when: x, falling: true, set: {{u: 1}}}}
  - {{when: x, rising: true, set: {{u: -1}}}}
"""
        return body, lambda s: {"x": 1 - rate_ * s, "u": mpf(-1)} if s < hit else None, 1
    return f"""states: {{x: 1, n: 0}}
equations: {{x: "if(x > 0, -{rate}, {rate})", n: 0}}
time: {{end: 5}}
events:
  - {{when: x + 3, falling: true, set: {{n: 1}}}}
""", lambda s: {"x": 1 - rate_ * s, "n": mpf(0)} if s < hit else None, 0


def several(rng, kind):
    if kind == "fast":
        w, w_ = number(rng, 20, 60)
        return counted(rng, 3, f"sin({w}*t + 1)", [(k * pi - 1) / w_ for k in range(1, int(3 * w_ / pi) + 2) if (k * pi - 1) / w_ <= 3])
    a, a_ = number(rng, 0.4, 2.2)
    gap = {"near": "0.01", "nearer": "1e-5", "nearest": "1e-8"}[kind]
    return counted(rng, 3, f"(t - {a})*(t - {a} - {gap})*(t - 2.9)", [a_, a_ + mpf(gap), mpf("2.9")])


def all_texts(seed):
    rng = random.Random(seed)
    for k in range(4):
        yield "resets", thermostat(rng, 30)
        yield "resets", neuron(rng, 12)
        yield "resets", logistic(rng, 25)
    for k in range(3):
        yield "resets", kicked(rng, 40)
    for bounces in (3, 6, 9):
        yield "resets", ball(rng, bounces)
    for kind in ("fast", "fast", "near", "near", "nearer", "nearest"):
        yield "several within one step", several(rng, kind)
    for order in ("first", "second", "first", "second"):
        yield "simultaneous", two_at_once(rng, order)
    for above in ("0.01", "1e-6", "0", "-1e-6", "-0.01", "1e-12", "-1e-12"):
        yield "tangential", touching(rng, above)
    for sign, sense in (("", ""), ("-", ""), ("", "rising: true, "), ("-", "falling: true, ")):
        yield "at the start", at_start(rng, sign, sense)
    for rate, level, stop in ((1, 2, 2), (0.5, 1, 2), (0.1, 0.3, 3), (0.7, 2.1, 3)):
        yield "on a stop", on_stop(rng, rate, level, stop)
    for end, every in ((30, 4), (30, 0.7), (12, 3), (50, 6)):
        yield "doses", doses(rng, end, every)
    yield "doses", delayed(rng)
    yield "doses", delayed(rng)
    for _ in range(4):
        yield "tables", table(rng)
    yield "thousands", neuron(rng, 2500)
    yield "thousands", kicked(rng, 9000)
    yield "thousands", doses(rng, 900, 0.4)
    for after in (1.02, 1.5):
        yield "without end", ball(rng, 200, after)
    for form in ("events", "events", "condition", "condition"):
        yield "without end", sliding(rng, form)
