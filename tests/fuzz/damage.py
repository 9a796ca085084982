# SPDX-License-Identifier: BSD-3-Clause
"""What the campaign damages: a file of each kind that the program reads, and how it is damaged."""
import io, pathlib, re, struct, zipfile

root = pathlib.Path(__file__).resolve().parent.parent.parent
decay = "parameters: {k: 1}\nstates: {x: 1}\nequations: {x: -k*x}\ntime: {end: 2}\n"
tokens = [b"nan", b"-inf", b"1e999", b"1e18", b"-1", b"0", b"1e-320", b"18446744073709551616", b"\x00", b"\xff\xfe", b"\x1b[2J",
          "\u202e".encode(), b"[" * 200, b"{" * 200, b"(" * 3000, b"&a [*a]",
          b"*a", b"\n---\n", b"\t", b"\r", b"'", b'"', b"%n%s",
          b"../../x", b"/dev/zero", b"!!binary ", b"|", b": ", b"- ", b"<!DOCTYPE x [<!ENTITY e SYSTEM 'file:///etc/passwd'>]>"]
square = re.search(r'R"\((.*?)\)"', (root / "tests/support/gmsh_text.hpp").read_text(), re.S).group(1)


def texts(*patterns):
    return [path.read_bytes() for pattern in patterns for path in sorted(root.glob(pattern))]


def damaged(data, rng, others):
    """Bytes with one to four changes; many keep the form of the text."""
    data = bytearray(data)
    for _ in range(rng.choice([1, 1, 2, 4])):
        at, to = sorted(rng.randrange(len(data) + 1) for _ in range(2))
        to = min(to, at + 200)
        change = rng.randrange(9)
        numbers = [m.span() for m in re.finditer(rb"\d+\.?\d*(?:e[-+]?\d+)?", bytes(data))]
        if change == 0 and data:
            data[min(at, len(data) - 1)] ^= 1 << rng.randrange(8)
        elif change == 1:
            del data[at:to]
        elif change == 2:
            data[at:at] = bytes(data[at:to]) * rng.choice([1, 2, 50])
        elif change == 3:
            data[at:at] = rng.choice(tokens)
        elif change in (4, 5) and numbers:
            begin, end = rng.choice(numbers)
            data[begin:end] = rng.choice(tokens[:8] + [b"2", b"3.5", b"7"])
        elif change == 6:
            del data[at:]
        elif change == 7:
            lines = bytes(data).split(b"\n")
            a, b = rng.randrange(len(lines)), rng.randrange(len(lines))
            lines[a], lines[b] = lines[b], lines[a]
            data = bytearray(b"\n".join(lines))
        else:
            other = rng.choice(others)
            cut = rng.randrange(len(other) + 1)
            data[at:to] = other[cut:cut + rng.randrange(200)]
    return bytes(data)


def model(version):
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as zipped:
        zipped.writestr("modelDescription.xml", (root / f"tests/package/fmi/fmi{version}.xml").read_text())
        platform = "linux64" if version == 2 else "x86_64-linux"
        zipped.writestr(f"binaries/{platform}/oscillator.so", b"\x7fELF")
    return archive.getvalue()


def array():
    """Three rows of t and x in NumPy's format."""
    head = b"{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }".ljust(117) + b"\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head + struct.pack("<6d", 0, 1, 1, 0.4, 2, 0.1)


def files_of_kinds():
    return {
        "text": texts("tests/outside/texts/*.yaml", "tests/outside/hybrid/*.yaml", "cases/problems/*.yaml", "cases/*.yaml") +
                [decay.encode()],
        "table": [b"time,speed\n0,1\n0.5,2\n1,1.5\n2,0\n", b"# wind\ntime; speed; gusts\n0; 1; 2\n1; +2e-1; 3\n"],
        "scene": texts("cases/scenes/*.yaml"),
        "mesh": [square.encode()],
        "members": [b"k\n1\n2\n0.5\n", b"k, x0\n1,2\n3,4\n"],
        "tableau": texts("cases/tableaus/*.yaml"),
        "model": [model(version) for version in (2, 3)],
        "species": texts("tests/outside/sbml/*.xml"),
        "network": texts("tests/outside/networks/*.net"),
        "brought": [b"t,x\n0,1\n0.5,0.6\n1,0.37\n2,0.14\n", b"# t x\n0 1\n1 0.4\n2 0.1\n", array()],
    }
