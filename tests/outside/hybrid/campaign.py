#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A campaign of texts with events whose solutions are known in closed form, with random parameters: what the truth claims.

tests/outside/hybrid/campaign.py [--program FILE] [--csv FILE] [--seed N] [--keep DIR] [KIND...]

Ten kinds: resets, several within one step, simultaneous, tangential, at the start, on a stop, doses, tables, thousands, and
those without a solution beyond a time (chattering, sliding, infinitely many). Of each text `odeum run` says what it claims of the
truth at the last stop and half of the time before; a claim has to be within what it says, and 64 roundings of the value, of
the closed form to 40 digits. A truth that claims nothing is declined, with its reason. Where the solution ends or the motion
slides, all that is claimed beyond is wrong. dormand_prince54 and rodas4 run to 1e-8; `off` is the larger of their errors, of
the largest value; it is not judged. A row a text; the exit code is 1 where a claim is wrong. Needs mpmath."""
import csv, datetime, math, os, pathlib, re, subprocess, sys, tempfile
from mpmath import mp, mpf

from kinds import all_texts

root = pathlib.Path(__file__).resolve().parents[3]
solvers = ["odeum/dormand_prince54", "odeum/rodas4"]
columns = ["schema", "kind", "text", "events", "truth", "known_to", "claimed_off", "status", "off", "date"]


def claims(program, path, end, folder, environment):
    words = [str(program), "run", str(path), *(word for each in solvers for word in ("--solver", each)), "--tol", "1e-8",
             "--every", mp.nstr(end / 2, 15), "--out", str(folder)]
    done = subprocess.run(words, capture_output=True, text=True, env=environment, timeout=600)
    exact, got = {}, {}
    if (folder / "solution.csv").exists():
        with open(folder / "solution.csv", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                t = float(row["time"])
                if row["exact"] and not math.isnan(float(row["exact"])):
                    exact.setdefault(t, {})[row["name"]] = float(row["exact"])
                got.setdefault(t, []).append((row["name"], float(row["value"])))
    return done.stdout + done.stderr, exact, got


def judged(kind, k, made, program, place):
    body, at, count = made
    path = pathlib.Path(place) / f"{kind.replace(' ', '_')}_{k}.yaml"
    path.write_text(body, encoding="utf-8")
    end = mpf(re.search(r"end: ([\d.e+]+)", body)[1])
    environment = {**os.environ, "XDG_CACHE_HOME": str(place), "COLUMNS": "0", "NO_COLOR": "1"}
    said, exact, got = claims(program, path, end, path.with_suffix(".out"), environment)
    known = re.search(r"known to ([-\d.e+]+)", said)
    known = float(known[1]) if known else math.nan
    reason = re.search(r"^truth +(.*)$", said, re.M)
    verdict, worst, off = "right", 0.0, math.nan
    for t, states in exact.items():
        right = at(mpf(repr(t)))
        if t == 0:
            continue
        if right is None:
            verdict = f"wrong: a state is claimed at t = {t:g}, where there is none"
            break
        for name, value in states.items():
            size = max(1.0, abs(float(right[name])))
            apart = float(abs(mpf(value) - right[name]))
            worst = max(worst, apart / size)
            if not apart <= known * size + 64 * 2.0**-53 * size:
                verdict = f"wrong: {name} = {value!r} at t = {t:g}, known to {known:g}, right {mp.nstr(right[name], 18)}"
    if verdict == "right" and not any(math.isclose(t, float(end), rel_tol=1e-12) for t in exact):
        verdict = "declined: " + (reason[1] if reason else said.strip().splitlines()[-1])
    last = got.get(max(got, default=0), [])
    right = at(mpf(repr(max(got)))) if got else None
    if right:
        off = max(abs(value - float(right[name])) / max(1.0, abs(float(right[name]))) for name, value in last)
    status = ",".join(re.findall(r"^status +(\w+)", said, re.M)) or "none"
    return [1, kind, k, count, verdict, f"{known:.1e}", f"{worst:.1e}", status, f"{off:.1e}", datetime.date.today()], verdict


def main():
    words, program, out, seed, keep, kinds = sys.argv[1:], root / "build/release/odeum", None, 61, None, []
    while words:
        word = words.pop(0)
        if word == "--program":
            program = pathlib.Path(words.pop(0))
        elif word == "--csv":
            out = words.pop(0)
        elif word == "--seed":
            seed = int(words.pop(0))
        elif word == "--keep":
            keep = words.pop(0)
            os.makedirs(keep, exist_ok=True)
        elif word.startswith("-"):
            sys.exit(__doc__)
        else:
            kinds.append(word)
    rows, counts = [], {}
    with tempfile.TemporaryDirectory() as place:
        for k, (kind, made) in enumerate(all_texts(seed), 1):
            if kinds and kind not in kinds:
                continue
            row, verdict = judged(kind, k, made, program, keep or place)
            rows.append(row)
            counts[verdict.split(":")[0]] = counts.get(verdict.split(":")[0], 0) + 1
            print(f"{k:3} {kind:24} {row[3]:6} {row[5]:>8} {row[6]:>8} {row[7]:24} {row[8]:>8}  {verdict[:150]}", flush=True)
    if out:
        with open(out, "w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([columns, *rows])
    print(f"{len(rows)} texts: {counts}")
    sys.exit(1 if counts.get("wrong") else 0)


main()
