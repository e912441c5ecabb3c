#!/usr/bin/env python3
"""Certificates of all worlds of folders, judged by both judges: what each takes, and what is refused.

usage: certificates_of_all.py TAUT FOLDER [...] [--queries N] [--python SECONDS]
       --queries N         of a world without start or goal: so many pairs of ends (default: 3), those of FILE.queries
                           beside it (`x y x y`, a line each) or random ones
       --python SECONDS    CPU seconds that the judge in Python may take for one (default: 60; 0 leaves it out)

Files may be gzipped. Prints a line for each certificate; exit status 1 where one that was written is not proven.
"""

import argparse
import gzip
import os
import random
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

JUDGE = Path(__file__).with_name("certificate_of_room.py")  # judges points, too
NO_WORLDS = (".queries", ".scen")
TRIES = 200  # of random ends, most of which may lie in walls


def cpu_of_children():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Cases:
    def __init__(self, options, folder):
        self.options, self.folder = options, folder
        self.proven = self.without = self.late = 0
        self.refused = []

    def run(self, *command, seconds=600):
        """Exit status (None: ended by a signal, as when its time is over), CPU seconds, what was said."""
        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds)))

        before = cpu_of_children()
        done = subprocess.run(command, capture_output=True, text=True, preexec_fn=limit, check=False)
        status = None if done.returncode < 0 else done.returncode
        return status, cpu_of_children() - before, (done.stdout + done.stderr).strip()

    def taut(self, *words):
        return self.run(self.options.taut, *words)

    def pairs_of(self, name, world):
        """Options that give the world ends: those of the file beside it, else random ones."""
        beside = name.with_name(name.name.removesuffix(".gz").removesuffix(".map") + ".queries")
        if beside.exists():
            rows = [line.split() for line in beside.read_text().splitlines() if not line.startswith("#")]
            pairs = [row[:4] for row in rows]
        else:
            text = self.integers(world)
            if text is None:
                return
            unit = next(float(line.split()[1].split("/")[0]) / float((line + "/1").split("/")[1])
                        for line in text.splitlines() if line.startswith("unit "))
            rows = [line.split()[1:] for line in text.splitlines() if line.startswith("area ")]
            rows = rows or [line.split()[1:] for line in text.splitlines() if line.startswith(("wall ", "solid "))]
            xs = [int(v) for row in rows for v in row[::2]]
            ys = [int(v) for row in rows for v in row[1::2]]
            rng = random.Random(name.name)
            number = lambda all_of: str(round(rng.uniform(min(all_of), max(all_of)) * unit * 4) / 4)  # noqa: E731
            pairs = [[number(xs), number(ys), number(xs), number(ys)] for _ in range(TRIES)]
        for x, y, to_x, to_y in pairs:
            yield [f"--from={x},{y}", f"--to={to_x},{to_y}"]

    def integers(self, world):
        path = self.folder / "integers"
        status, _, _ = self.taut("convert", world, path, "--as", "integers", "-q")
        return path.read_text() if status == 0 else None

    def file(self, name):
        world = self.folder / name.name.removesuffix(".gz")
        world.write_bytes(gzip.decompress(name.read_bytes()) if name.suffix == ".gz" else name.read_bytes())
        if self.taut("check", world, "-q")[0] not in (0, 1):
            return  # no world
        status, _, words = self.taut("solve", world, "-q")
        if status in (0, 1):
            self.certificate(name, world, [])
            return
        done = 0
        for ends in self.pairs_of(name, world):
            if done < self.options.queries and self.taut("solve", world, *ends, "-q")[0] in (0, 1):
                done += 1
                self.certificate(name, world, ends)
        if done == 0:
            self.without += 1
            print(f"{name.name:32} no ends: {words.splitlines()[0] if words else ''}"[:150], flush=True)

    def certificate(self, name, world, ends):
        proof, integers = self.folder / "proof", self.folder / "integers"
        proof.unlink(missing_ok=True)
        status, searching, _ = self.taut("solve", world, *ends, "--no-verify", "-q")
        status, writing, words = self.taut("solve", world, *ends, "--certificate", proof, "--no-verify", "-q")
        if not proof.exists():
            self.without += 1
            print(f"{name.name:32} no certificate (exit {status}): {words}"[:150], flush=True)
            return
        status, judging, words = self.taut("verify", world, proof, "--integers", integers)
        line = (f"{name.name:32} search {searching:6.3f}  with certificate {writing:6.3f}  verify {judging:6.3f}  "
                f"{proof.stat().st_size / 1000:7.1f} kB")
        if status == 0 and self.options.python > 0:
            second, seconds, said = self.run(sys.executable, JUDGE, integers, proof, seconds=self.options.python)
            line += f"  python {seconds:6.1f}" if second is not None else "  python stopped"
            self.late += second is None
            status, words = (status, words) if second in (0, None) else (second, said)
        self.proven += status == 0
        if status != 0:
            self.refused.append(f"{name} {' '.join(ends)}: {words}")
        print(line + (f"  REFUSED {words}" if status != 0 else ""), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("taut")
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--queries", type=int, default=3)
    parser.add_argument("--python", type=float, default=60)
    options = parser.parse_args()
    os.environ["LC_ALL"] = "C"
    with tempfile.TemporaryDirectory() as folder:
        cases = Cases(options, Path(folder))
        for name in sorted(path for root in options.folders for path in root.rglob("*") if path.is_file()):
            if name.suffix not in NO_WORLDS:
                cases.file(name)
    print(f"{cases.proven} proven, {len(cases.refused)} refused, {cases.without} files or ends without a certificate, "
          f"{cases.late} left undecided by the judge in Python", *cases.refused, sep="\n")
    return cases.refused != [] or cases.proven == 0


if __name__ == "__main__":
    sys.exit(main())
