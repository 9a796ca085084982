# SPDX-License-Identifier: BSD-3-Clause
"""Whether digits depend on how files are compiled together: contraction.py BUILD (a folder with compile_commands.json).

Only units of odeum_timed may join products and sums to one operation, each of these is one file, and no function with
such an operation in it is also in a unit of the other kind: the linker would keep one of the two.
"""
import json
import pathlib
import re
import subprocess
import sys

TIMED = re.compile(r"/adapters/odeint/|/inlined(_odeint)?/|/scene/springs/(?!grid_matrix)|_lanes\.cpp$")
FUSED = re.compile(r"\t(vfn?m|fn?m)(add|sub|la|ls)")


def functions_of(unit):
    """The functions of an object file that others may define too."""
    lines = subprocess.run(["nm", "--defined-only", unit], capture_output=True, text=True, check=True).stdout
    return {words[2] for words in map(str.split, lines.splitlines()) if len(words) == 3 and words[1] in "Wu"}


def fused_in(unit, functions):
    """Those of the functions that have an operation on three numbers."""
    code = subprocess.run(["objdump", "-d", "--no-show-raw-insn", unit], capture_output=True, text=True, check=True)
    found, name = set(), ""
    for line in code.stdout.splitlines():
        if line.endswith(">:"):
            name = line[line.index("<") + 1 : -2]
        elif name in functions and FUSED.search(line):
            found.add(name)
    return found


def main(build):
    faults, timed, judged = [], [], []
    for entry in json.loads((build / "compile_commands.json").read_text()):
        output, file = re.search(r" -o (\S+)", entry["command"])[1], entry["file"]
        unit = pathlib.Path(entry["directory"]) / output
        if output.startswith("tests/bench/") or output.endswith(".gch"):
            continue
        rule = re.findall(r"-ffp-contract=(\w+)", entry["command"])[-1:]
        if rule not in (["off"], ["fast"]) or (rule == ["fast"]) != bool(TIMED.search(file)):
            faults.append(f"{file}: compiled with contraction {rule}")
        if not output.startswith("tests/") and unit.exists():
            (timed if rule == ["fast"] else judged).append(unit)
    if not timed or not judged:
        faults.append(f"{len(timed)} timed units and {len(judged)} others are built")
    names = {}
    for unit in judged:
        for function in functions_of(unit):
            names.setdefault(function, unit)
    for unit in timed:
        for function in sorted(fused_in(unit, functions_of(unit) & names.keys())):
            faults.append(f"{unit.name} and {names[function].name} both have {function}")
    print("\n".join(faults) or f"{len(timed)} timed units share no fused operation with {len(judged)} others")
    return 1 if faults else 0


sys.exit(main(pathlib.Path(sys.argv[1])))
