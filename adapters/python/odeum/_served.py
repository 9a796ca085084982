# SPDX-License-Identifier: BSD-3-Clause
"""A function of Python that no text can say, as a problem of the program: it is called in processes of its own, copies of this
one, to which the program's plug-in connects (function_plugin.c). Its calls are counted and timed apart."""
from __future__ import annotations

import contextlib
import mmap
import os
import pathlib
import re
import secrets
import signal
import socket
import struct
import time
from dataclasses import dataclass
from typing import Callable, Iterator, Sequence

import numpy as np

from ._program import OdeumError, program

SLOTS = 4096
SAID = 2000  # bytes of the first error
PATIENCE = 6  # seconds of a call, somewhat more than the program waits for a sign of work


@dataclass(frozen=True)
class Called:
    """How often a function was called that no text can say, for which reason, and at what cost: `call_ns` is the function's own
    share of a call, `passing_ns` that of handing numbers to it and back, which no compiled function has."""
    reason: str
    calls: int
    call_ns: float
    passing_ns: float
    raised: str


class Counts:
    """Counters in memory that the processes share: for each calls, seconds in the function and seconds of whole calls."""

    def __init__(self):
        self.memory = mmap.mmap(-1, SLOTS * 24 + SAID)
        self.numbers = np.frombuffer(self.memory, dtype=float, count=3 * SLOTS).reshape(SLOTS, 3)

    def say(self, text: str) -> None:
        if not self.memory[3 * 8 * SLOTS]:
            words = text.encode()[:SAID - 1]
            self.memory[3 * 8 * SLOTS:3 * 8 * SLOTS + len(words)] = words

    def said(self) -> str:
        return self.memory[3 * 8 * SLOTS:].split(b"\0", 1)[0].decode(errors="replace")

    def result(self, reason: str) -> Called:
        calls, inside, whole = self.numbers.sum(axis=0)
        each = max(calls, 1)
        return Called(reason, int(calls), 1e9 * inside / each, 1e9 * max(whole - inside, 0) / each, self.said())


def rates_of(f: Callable, t: float, y: np.ndarray, args: Sequence) -> np.ndarray:
    rates = np.ravel(np.asarray(f(t, y, *args), dtype=float))
    if rates.size != y.size:
        raise ValueError(f"the function gives {rates.size} rates for {y.size} states")
    return rates


def answer(connection: socket.socket, f: Callable, n: int, args: Sequence, counts: Counts, slot: int) -> None:
    """Calls the function until the other side is closed. A call that hangs ends the process."""
    message, reply, own = np.empty(n + 2), np.zeros(n + 1), counts.numbers[slot]
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    while connection.recv_into(message, message.nbytes, socket.MSG_WAITALL) == message.nbytes:
        own[2] += message[0]
        signal.setitimer(signal.ITIMER_REAL, PATIENCE)
        begun = time.perf_counter()
        try:
            reply[1:] = rates_of(f, float(message[1]), message[2:].copy(), args)
            reply[0] = 0
        except Exception as error:  # noqa: BLE001  (whatever the function raises)
            counts.say(f"{type(error).__name__}: {error}, at t = {float(message[1])!r}")
            reply[0] = 1
        own[1] += time.perf_counter() - begun
        signal.setitimer(signal.ITIMER_REAL, 0)
        own[0] += 1
        connection.sendall(reply)


def serve(listening: socket.socket, description: bytes, f: Callable, n: int, args: Sequence, counts: Counts, lifeline: int) -> None:
    """Accepts connections, each for a process of its own, until the other end of `lifeline` is closed."""
    import select  # noqa: PLC0415
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    slot = 0
    while lifeline not in select.select([listening, lifeline], [], [])[0]:
        connection, _ = listening.accept()
        if os.fork() == 0:
            listening.close()
            os.close(lifeline)
            try:
                connection.sendall(description)
                answer(connection, f, n, args, counts, slot % SLOTS)
            finally:
                os._exit(0)
        connection.close()
        slot += 1
    os.killpg(0, signal.SIGKILL)  # this process, and those that still call


def plugin() -> pathlib.Path | None:
    """The plug-in beside the program, of an installation or of a build."""
    where = pathlib.Path(program()).resolve().parent
    for each in (where.parent / "lib/odeum/libodeum_python.so", where / "adapters/python/libodeum_python.so"):
        if each.is_file():
            return each
    return None


def word_of(name: str) -> str:
    """A name as a plug-in's problems have it."""
    return re.sub("[^a-z0-9_]", "_", name.lower()).strip("_")[:60] or "function"


@contextlib.contextmanager
def served(f: Callable, y0: Sequence[float], span: tuple[float, float], args: Sequence, folder: pathlib.Path,
           reason: str) -> Iterator[tuple[list[str], dict[str, str], Callable[[], Called]]]:
    """The words of the command line for the function as a problem, what they need in the environment, and what was counted."""
    library = plugin()
    if library is None or not hasattr(os, "fork"):
        raise OdeumError(f"{reason}; the plug-in libodeum_python.so, which would call it, is not beside the program")
    y = np.atleast_1d(np.asarray(y0, dtype=float))
    rates_of(f, float(span[0]), y.copy(), args)  # what it raises is the caller's to see
    name = word_of(getattr(f, "__name__", "function"))
    stops = [span[0] + (span[1] - span[0]) * k / 4 for k in (1, 2, 3)] + [span[1]]
    description = struct.pack("=qq64s", y.size, len(stops), name.encode()) + np.array([span[0], *y, *stops], dtype=float).tobytes()
    # Results of a plug-in are kept under the sum of its bytes, and another function is another plug-in.
    own = folder / "function.so"
    own.write_bytes(library.read_bytes() + secrets.token_bytes(16))
    counts = Counts()
    path = str(folder / "function.socket")
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as listening:
        listening.bind(path)
        listening.listen(64)
        closed, held = os.pipe()
        process = os.fork()
        if process == 0:
            try:
                os.close(held)
                os.setpgid(0, 0)
                serve(listening, description, f, y.size, args, counts, closed)
            finally:
                os._exit(0)
        os.close(closed)
        with contextlib.suppress(OSError):
            os.setpgid(process, process)  # whichever is first
    try:
        environment = {"ODEUM_PYTHON_FUNCTION": path, "XDG_CACHE_HOME": str(folder)}
        yield ["python_" + name, "--plugin", str(own)], environment, lambda: counts.result(reason)
    finally:
        os.close(held)
        os.waitpid(process, 0)
