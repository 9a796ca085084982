# SPDX-License-Identifier: BSD-3-Clause
"""The program: where it is, and what it prints as JSON."""
from __future__ import annotations

import json
import os
import shutil
import subprocess
from typing import Any, Mapping


class OdeumError(RuntimeError):
    """What the program said where it refused, or why it could not be run."""


def program() -> str:
    """The path of the program."""
    found = os.environ.get("ODEUM_PROGRAM") or shutil.which("odeum")
    if not found:
        raise OdeumError("the program odeum is not on the path; set ODEUM_PROGRAM to where it is")
    return found


def said(*words: str, environment: Mapping[str, str] | None = None) -> Any:
    """What a command prints as JSON. Its exit code 1 is an answer (a claim that is denied, an error that is not reached)."""
    done = subprocess.run([program(), *words, "--format", "json"], capture_output=True, text=True, check=False,
                          env={**os.environ, **(environment or {})})
    try:
        return json.loads(done.stdout)
    except json.JSONDecodeError:
        lines = [line for line in done.stderr.splitlines() if line.startswith("odeum: ")]
        raise OdeumError(lines[-1][len("odeum: "):] if lines else
                         f"odeum {words[0]} ended with {done.returncode}: {done.stderr.strip()[-500:]}") from None
