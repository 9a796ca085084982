#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Gives the program damaged files of every kind that it reads, and asks that it ends well.

tests/fuzz/campaign.py [--minutes M | --seconds S] [--seed N] [--program FILE] [--kind KIND]... [--keep DIR]

An hour by `tests/fuzz/campaign.py --minutes 60`; the test `fuzz` takes 60 s. Kinds: text, table (of a text), scene, mesh, members,
tableau, model (an FMU), species (SBML), network, brought (trajectories that `judge` reads), folder and archive (that `compare` reads), plan, part,
cache, signal. A file of each is damaged (bytes, spans, lines, numbers, words), and commands read it. Each
has to end with an exit code of the contract, by itself or within 5 s of a SIGTERM that comes after 10 s, with at most 4 GB of
memory, without a word of an abort, and with nothing left in its working folder, its temporary folder, and, of what is
unfinished, in its cache. A damaged plan or part is refused, or gives the same rows; a damaged cache gives the same output. By
`signal` commands that read no damaged file are ended at a random time. The input of a failure is kept in DIR (fuzz-failures).
Exit code 1 where something failed. Needs the standard library alone."""
import argparse, gzip, io, os, pathlib, random, re, resource, shutil, signal, subprocess, sys, tarfile, tempfile, time, zipfile

from damage import damaged, decay, files_of_kinds, root

patience, heard, memory = 10, 5, 4 << 20  # seconds, seconds, kB
words = re.compile(r"terminate called|Assertion|runtime error|AddressSanitizer|out of memory|stack smashing|free\(\)|malloc\(\)")
signalled = [
    "run stiff.yaml --solver rk4 --step 1e-6", "run stiff.yaml --solver radau_iia5 --tol 1e-9", "run hanging_cloth", "converge",
    "run cloth_on_sphere --film 20",
    "why robertson_40 --solver heun --tol 1e-6", "advise pleiades --error 1e-6", "report --quick",
    "precision --case kepler_e06", "stability", "drift", "limits", "reduction", "material", "cloth", "cost", "mesh", "elements",
    "evolution", "proof", "sweep stiff.yaml --over k=1..2:100000 --solver rk4 --step 1e-4", "plan converge --shards 3",
    "plan sweep stiff.yaml --over k=1..2:100000 --solver rk4 --step 1e-4 --shards 3",
    "sweep stiff.yaml --over k=1..2:50 --study converge --solver rk4"]


class Failure(Exception):
    pass


class Campaign:
    def __init__(self, program, seed, keep):
        self.program, self.rng, self.keep = str(pathlib.Path(program).resolve()), random.Random(seed), pathlib.Path(keep)
        self.base = pathlib.Path(tempfile.mkdtemp(prefix="odeum-fuzz-"))
        self.place, self.temporary, self.cache = (self.base / name for name in ("place", "tmp", "cache"))
        self.count, self.failures, self.peak, self.longest = 0, 0, 0, 0.0
        self.seeds = files_of_kinds()
        for folder in (self.place, self.temporary, self.cache):
            folder.mkdir()

    def run(self, arguments, codes=(0, 1, 2, 3, 4, 130), compiler=True, patience=patience):
        """Its exit code and standard output; a Failure where it does not end well."""
        environment = {"PATH": os.environ["PATH"], "HOME": str(self.base), "TMPDIR": str(self.temporary),
                       "XDG_CACHE_HOME": str(self.cache), "LC_ALL": "C", "ODEUM_FOREIGN_GIGABYTES": "1"}
        if not compiler:
            environment["CC"] = "/bin/false"
        before = {path for folder in (self.place, self.temporary) for path in folder.rglob("*")}
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            start = time.monotonic()
            child = subprocess.Popen([self.program, *arguments], cwd=self.place, env=environment, stdin=subprocess.DEVNULL,
                                     stdout=out, stderr=err,
                                     preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_DATA, (5 << 30,) * 2))
            asked, state, usage = None, None, None
            while state is None:
                pid, status, used = os.wait4(child.pid, os.WNOHANG)
                if pid:
                    state, usage = status, used
                elif asked is None and time.monotonic() - start > patience:
                    asked = time.monotonic()
                    child.send_signal(signal.SIGTERM)
                elif asked is not None and time.monotonic() - asked > heard:
                    child.kill()
                    os.wait4(child.pid, 0)
                    child.returncode = -9
                    raise Failure(f"did not hear SIGTERM: odeum {' '.join(arguments)}")
                else:
                    time.sleep(0.002)
            child.returncode = os.waitstatus_to_exitcode(state)
            for stream in (out, err):
                stream.seek(0)
            said, remarks = out.read(), err.read().decode(errors="replace")
        self.count += 1
        what = f"odeum {' '.join(arguments)}: exit code {child.returncode}: {remarks[-300:]}"
        spent = usage.ru_utime + usage.ru_stime
        self.peak, self.longest = max(self.peak, usage.ru_maxrss), max(self.longest, spent)
        started = child.returncode != -signal.SIGTERM or spent > 0.1  # what listens to it is not yet there
        if (started and child.returncode not in codes) or words.search(remarks):
            raise Failure(what)
        if usage.ru_maxrss > memory:
            raise Failure(f"{usage.ru_maxrss >> 10} MB: {what}")
        left = {path for folder in (self.place, self.temporary) for path in folder.rglob("*")} - before
        if "--out" not in arguments and arguments[0] not in ("shard", "merge") and left:
            raise Failure(f"left {sorted(left)[:3]}: {what}")
        unfinished = [path for path in self.cache.rglob("*") if path.name.startswith("work-") or path.suffix == ".part"]
        if unfinished or any(self.temporary.iterdir()):
            raise Failure(f"left {unfinished or list(self.temporary.iterdir())}: {what}")
        return child.returncode, said

    def file(self, kind, name):
        path = self.place / name
        seeds = self.seeds[kind]
        data = self.rng.choice(seeds)
        if kind == "model" and self.rng.random() < 0.6:  # of the description in a whole archive
            archive = zipfile.ZipFile(io.BytesIO(data))
            to = io.BytesIO()
            with zipfile.ZipFile(to, "w") as zipped:
                for entry in archive.namelist():
                    content = archive.read(entry)
                    zipped.writestr(entry, damaged(content, self.rng, seeds) if entry.endswith(".xml") else content)
            path.write_bytes(to.getvalue())
        else:
            path.write_bytes(damaged(data, self.rng, seeds))
        return str(path)

    def text(self):
        file = self.file("text", "problem.yaml")
        self.run(["run", file, "--solver", "heun", "--step", "0.1", "--until", "0.5", "--no-truth"],
                 compiler=self.rng.random() < 0.3)

    def table(self):
        self.file("table", "wind.csv")
        between, outside = self.rng.choice(["linear", "cubic", "constant"]), self.rng.choice(["error", "hold", "extrapolate"])
        (self.place / "driven.yaml").write_text(
            f"tables: {{wind: {{file: wind.csv, columns: [time, speed], between: {between}, outside: {outside}}}}}\n"
            "states: {x: 1}\nequations: {x: wind(t) - x}\ntime: {end: 1.5}\n")
        self.run(["run", "driven.yaml", "--solver", "heun", "--step", "0.1", "--no-truth"], compiler=False)

    def scene(self):
        self.run(["run", self.file("scene", "scene.yaml"), "--until", "0.01"])

    def mesh(self):
        self.run(["poisson", self.file("mesh", "mesh.msh"), "--load", "1"])

    def members(self):
        (self.place / "decay.yaml").write_text(decay)
        self.run(["sweep", "decay.yaml", "--over-file", self.file("members", "members.csv"), "--solver", "rk4", "--step", "0.1",
                  "--check", "0"])

    def tableau(self):
        self.run(["verify", self.file("tableau", "tableau.yaml")])

    def model_file(self):
        self.run(["list", "solvers", self.file("model", "model.fmu")])

    def species(self):
        self.run(["run", self.file("species", "model.xml"), "--solver", "heun", "--step", "0.1", "--until", "0.5", "--no-truth"],
                 compiler=False)

    def network(self):
        self.run(["run", self.file("network", "model.net"), "--solver", "heun", "--step", "0.1", "--until", "0.5", "--no-truth"],
                 compiler=False)

    def brought(self):
        (self.place / "decay.yaml").write_text(decay)
        name = self.rng.choice(["euler_h0.5.csv", "a.npy", "b.txt"])
        self.run(["judge", "decay.yaml", self.file("brought", name), *self.rng.choice([[], ["--claims", "heun"], ["--map", "x=1"]])])

    def make_before(self):
        if not (self.base / "before").exists():
            self.run(["converge", "--case", "free_fall", "--solver", "heun", "--quick", "--out", "out"], codes=(0,))
            shutil.move(self.place / "out", self.base / "before")

    def archive(self):
        """The archive of results: damaged, or with damaged tables, or with what none has; the last is refused."""
        self.make_before()
        shutil.copytree(self.base / "before", self.place / "before")
        paths = [path for path in (self.place / "before").iterdir() if path.suffix in (".csv", ".json")]
        files = {path.name: path.read_bytes() for path in paths}
        how, packed = self.rng.choice(["bytes", "tar", "table", "hostile"]), io.BytesIO()
        if how == "table":
            name = self.rng.choice(sorted(files))
            files[name] = damaged(files[name], self.rng, list(files.values()))
        with tarfile.open(fileobj=packed, mode="w", format=tarfile.USTAR_FORMAT) as tar:
            for name, content in files.items():
                entry = tarfile.TarInfo(name)
                entry.size = len(content)
                tar.addfile(entry, io.BytesIO(content))
            if how == "hostile":
                entry = tarfile.TarInfo(self.rng.choice(["../out.csv", "/tmp/out.csv", "a/../../out.csv", "out", "orders.csv", "a.csv/"]))
                entry.type = self.rng.choice([tarfile.REGTYPE, tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.DIRTYPE, tarfile.FIFOTYPE])
                entry.linkname = "/etc/passwd"
                tar.addfile(entry)
        tar = packed.getvalue()
        if how == "hostile" and self.rng.random() < 0.1:
            tar = bytes(600 << 20)  # what unpacks to far more than it is
        data = gzip.compress(damaged(tar, self.rng, [tar]) if how == "tar" else tar, compresslevel=1)
        (self.place / "results.tar.gz").write_bytes(damaged(data, self.rng, [data]) if how == "bytes" else data)
        self.run(["compare", "results.tar.gz", "before", *self.rng.choice([[], ["--within", "0.02"], ["--overlay"]])],
                 codes=(2,) if how == "hostile" else (0, 1, 2))

    def folder(self):
        """Two folders of one study, of which a file of the second is damaged."""
        self.make_before()
        for name in ("before", "after"):
            shutil.copytree(self.base / "before", self.place / name)
        file = self.rng.choice([path for path in (self.place / "after").iterdir() if path.suffix in (".csv", ".json")])
        file.write_bytes(damaged(file.read_bytes(), self.rng, [file.read_bytes()]))
        self.run(["compare", "before", "after", *self.rng.choice([[], ["--within", "0.02"], ["--format", "json"]])])

    def sweep_words(self):
        return ["sweep", "decay.yaml", "--over", "k=0.1..3:6", "--solver", "rk4", "--step", "0.1", "--check", "0"]

    def planned(self):
        """The folder of a plan whose shards are done, made once, and what its merge prints."""
        if not (self.base / "planned").exists():
            (self.place / "decay.yaml").write_text(decay)
            self.run(["plan", *self.sweep_words(), "--shards", "2", "--out", "run"], codes=(0,))
            for shard in "01":
                self.run(["shard", "run", shard], codes=(0,))
            self.run(["merge", "run", "--out", "whole"], codes=(0,))
            self.rows = (self.place / "whole/members.csv").read_bytes()
            shutil.rmtree(self.place / "whole")
            shutil.move(self.place / "run", self.base / "planned")
        (self.place / "decay.yaml").write_text(decay)
        shutil.copytree(self.base / "planned", self.place / "run")
        return self.place / "run"

    def plan(self):
        file = self.planned() / "plan.json"
        file.write_bytes(damaged(file.read_bytes(), self.rng, [file.read_bytes()]))
        self.merged(self.rng.choice([["status", "run"], ["shard", "run", "0"], ["shard", "run", "1"]]))

    def part(self):
        shard = self.planned() / "shards" / self.rng.choice("01")
        file = self.rng.choice([shard / "shard.json", *(shard / "results").iterdir()])
        file.write_bytes(damaged(file.read_bytes(), self.rng, [file.read_bytes()]))
        self.merged(["status", "run"])

    def merged(self, first):
        self.run(first)
        code, _ = self.run(["merge", "run", "--out", "whole"])
        rows = self.place / "whole/members.csv"
        if code == 0 and rows.read_bytes() != self.rows:
            raise Failure("a merge of damaged files gave other rows with exit code 0")

    def cached(self):
        (self.place / "decay.yaml").write_text(decay.replace("-k*x", "-k*x + sin(t)"))
        command = ["run", "decay.yaml", "--solver", "rk4", "--step", "0.1", "--format", "json"]
        _, said = self.run(command, codes=(0,))
        study = ["converge", "--case", "free_fall", "--solver", "heun", "--quick", "--format", "csv", "--out", "out"]
        _, rows = self.run(study, codes=(0,))
        kept = [path for path in self.cache.rglob("*") if path.is_file() and path.stat().st_size > 0]
        for file in self.rng.sample(kept, min(2, len(kept))):
            file.write_bytes(damaged(file.read_bytes(), self.rng, [file.read_bytes()]))
        if self.run(command, codes=(0,))[1] != said or self.run(study, codes=(0,))[1] != rows:
            raise Failure("a damaged cache changed what is printed")

    def signal(self):
        factors = "*(1 + x*sin(x))" * self.rng.randrange(400)
        (self.place / "stiff.yaml").write_text(decay.replace("-k*x", "-k*x + sin(t)*exp(-x*x)" + factors))
        self.run(self.rng.choice(signalled).split() + ["--out", "out"], patience=10 ** self.rng.uniform(-2, 0.5))

    def once(self, kind):
        try:
            {"model": self.model_file, "cache": self.cached}.get(kind, getattr(self, kind, None))()
        except Failure as failure:
            self.failures += 1
            kept = self.keep / f"{kind}-{self.count}"
            shutil.copytree(self.place, kept, dirs_exist_ok=True)
            if kind == "cache":
                shutil.copytree(self.cache, kept / "cache", dirs_exist_ok=True)
            print(f"FAILED {kind}, kept in {kept}: {failure}", flush=True)
            shutil.rmtree(self.temporary)
            self.temporary.mkdir()
        shutil.rmtree(self.place)
        self.place.mkdir()
        if kind == "cache":
            shutil.rmtree(self.cache)
            self.cache.mkdir()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=0)
    parser.add_argument("--seconds", type=float, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--program", default=root / "build/release/odeum")
    parser.add_argument("--kind", action="append")
    parser.add_argument("--keep", default="fuzz-failures")
    given = parser.parse_args()
    kinds = given.kind or ["text", "table", "scene", "mesh", "members", "tableau", "model", "species", "network", "brought", "folder",
                           "archive", "plan", "part", "cache", "signal"]
    campaign = Campaign(given.program, given.seed, given.keep)
    end = time.monotonic() + (60 * given.minutes + given.seconds or 60)
    rounds = 0
    try:
        while time.monotonic() < end and campaign.failures < 20:
            campaign.once(kinds[rounds % len(kinds)])
            rounds += 1
    finally:
        shutil.rmtree(campaign.base, ignore_errors=True)
    print(f"{rounds} damaged files, {campaign.count} commands, {campaign.failures} failures; at most "
          f"{campaign.peak >> 10} MB and {campaign.longest:.1f} s of the processor (seed {given.seed})")
    return 1 if campaign.failures else 0


if __name__ == "__main__":
    sys.exit(main())
