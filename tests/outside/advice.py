#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Asks `odeum advise` about models that other people published, makes the run that it prints, and holds it against SciPy.

tests/outside/advice.py [--program FILE] [--csv FILE] [NAME...]    default: the questions of questions/asked.txt

Each question is asked in an empty cache. The command of the answer is run with outputs at quarters of the span, and each
of them is compared with the states that SciPy computes, in the units that the answer took (its scale of each state). A
run keeps its error where the largest is at most 1.05 times the error asked for: two families of SciPy's agree to a
hundredth of it. An answer that says by its exit code that it has no run, or one for a part of the span, is `declined`,
where that run keeps its error. Needs SciPy and PyYAML."""
import csv, json, os, pathlib, re, resource, shlex, subprocess, sys, tempfile
import numpy as np
import ends
from model import Model

here = pathlib.Path(__file__).resolve().parent
columns = ["schema", "text", "asked", "seconds", "exit", "verdict", "error", "error_said", "solver", "setting_kind", "setting"]


def reference(path, times, wanted):
    """The states at the times, a row each, and the largest value of each state."""
    model = Model(path)
    breaks = ends.switches(model)
    for least in (1, 1e-20):
        _, _, largest, method, apart = ends.end_of(model, breaks, least)
        if apart < 1e-2 * wanted:
            break
    else:
        raise RuntimeError(f"two families of methods differ by {apart:.1e} of the largest")
    size = np.where(largest > 0, largest, 1)
    y, at, found = np.array(model.y0, float), model.start, []
    for t in times:
        if t > at:
            y, _ = ends.run(model, method, 1e-11 if method == "Radau" else 1e-12, least * size, at, t, y, breaks, most=3 * 10**6)
            at = t
        found.append(y)
    return np.array(found), size


def scale_of(text, size):
    """The units that the run says; after the eighth state it says none."""
    line = re.search(r"^scale +(.*?): ", text, re.M)
    said = [float(value) for value in re.findall(r" (\d+\.?\d*(?:e[-+]?\d+)?)", " " + line[1])] if line else [1.0] * len(size)
    return np.array(said) if len(said) == len(size) else np.array(size)


def asked(program, path, words):
    """A row, as far as it is known without SciPy, and the outputs of the run: times, states, units."""
    with tempfile.TemporaryDirectory() as place:
        environment = {**os.environ, "XDG_CACHE_HOME": place, "COLUMNS": "0", "NO_COLOR": "1"}
        call = lambda *more: subprocess.run([str(program), *more], capture_output=True, text=True, env=environment)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        done = call("advise", str(path), *words, "--format", "json")
        row = {"schema": 1, "text": path.stem, "asked": " ".join(words), "exit": done.returncode,
               "seconds": f"{resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before:.1f}"}
        answer = json.loads(done.stdout) if done.stdout.strip() else {}
        if not answer.get("command"):
            first = (done.stderr.strip().splitlines() or ["no word"])[0]
            return row | {"verdict": "declined" if done.returncode == 1 else f"no answer: {first}"}, None
        row |= {key: answer[key] for key in ("solver", "setting_kind", "setting")} | {"error_said": f"{answer['error']:.3g}"}
        run, folder = shlex.split(answer["command"])[1:], pathlib.Path(place) / "out"
        model = Model(path)
        quarter = (model.end - model.start) / 4
        text = call(*run, "--every", repr(quarter), "--out", str(folder)).stdout
        with open(folder / "trajectory.csv", encoding="utf-8") as file:
            rows = [each for each in csv.DictReader(file) if each["library"] != "truth"]
        names = [name for name in rows[0] if name not in ("schema", "case", "library", "solver", "time", "energy", "error")]
        return row, ([float(each["time"]) for each in rows], [[float(each[name]) for name in names] for each in rows], text)


def judged(program, path, words):
    row, run = asked(program, path, words)
    if not run:
        return row
    times, states, text = run
    wanted = float(words[words.index("--error") + 1])
    right, size = reference(path, times, wanted)
    error = float(np.max(np.abs(np.array(states) - right) / scale_of(text, size)))
    whole = times[-1] == Model(path).end
    verdict = "missed" if error > 1.05 * wanted else "declined" if row["exit"] == 1 else "kept" if whole else "missed"
    return row | {"error": f"{error:.3g}", "verdict": verdict}


def main():
    words, program, table = sys.argv[1:], here.parent.parent / "build/release/odeum", None
    while words and words[0].startswith("--"):
        name = words.pop(0)
        if name not in ("--program", "--csv") or not words:
            sys.exit(__doc__)
        if name == "--program":
            program = words.pop(0)
        else:
            table = words.pop(0)
    questions = [line.split() for line in (here / "questions/asked.txt").read_text(encoding="utf-8").splitlines()]
    rows = []
    for name, *question in questions:
        if not words or name in words:
            rows.append(judged(program, here / f"questions/{name}.yaml", question))
            print("  ".join(f"{rows[-1].get(key, '')}" for key in columns[1:]), flush=True, file=ends.said)
    if table:
        with open(table, "w", encoding="utf-8", newline="") as file:
            writer = csv.DictWriter(file, columns, lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
    count = lambda kind: sum(row["verdict"] == kind for row in rows)
    print(f"{len(rows)} questions: {count('kept')} kept, {count('declined')} declined, {count('missed')} missed", file=ends.said)
    sys.exit(0 if rows and count("kept") + count("declined") == len(rows) else 1)


main()
