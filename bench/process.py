#!/usr/bin/env python3
"""The program from outside: CPU time and memory of whole runs, on mazes made here and on grid maps of others.

process.py TAUT [--filter REGEX] [--runs N] [--out RUN.json]

Of a `process` the time is that of the process less that of `taut --version`, medians of runs in turn; memory is the
peak resident set. Of a `query` it is what `taut batch` says of one, paths included; of a `graph` what `taut roadmap` says
of building it; of a `pair` what `taut matrix` says. Answers are checked: each by its exit code, and where lengths are
published by `taut batch`. Grid maps of others are those in $TAUT_SHARED_DATA/movingai, with their queries. The output
has the form of Google Benchmark's, for report.py.
"""
import argparse
import glob
import json
import os
import random
import re
import statistics
import subprocess
import sys
import tempfile


def cells_of_maze(width, wide, opened, seed=1):
    """Rows of a grid map: a perfect maze in about `width` cells, corridors `wide`, walls one; a part of its walls open."""
    draw = random.Random(seed)
    n = (width - 1) // (wide + 1)
    side = n * (wide + 1) + 1
    free = [bytearray(side) for _ in range(side)]

    def open_cell(x, y, w, h):
        for row in range(y, y + h):
            for column in range(x, x + w):
                free[row][column] = 1

    def corner(i):
        return i * (wide + 1) + 1

    def open_wall(a, b):
        (ax, ay), (bx, by) = sorted((a, b))
        if ay == by:
            open_cell(corner(bx) - 1, corner(ay), 1, wide)
        else:
            open_cell(corner(ax), corner(by) - 1, wide, 1)

    seen, stack = {(0, 0)}, [(0, 0)]
    open_cell(1, 1, wide, wide)
    while stack:
        x, y = stack[-1]
        ways = [(x + dx, y + dy) for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1))
                if 0 <= x + dx < n and 0 <= y + dy < n and (x + dx, y + dy) not in seen]
        if not ways:
            stack.pop()
            continue
        to = draw.choice(ways)
        open_wall((x, y), to)
        open_cell(corner(to[0]), corner(to[1]), wide, wide)
        seen.add(to)
        stack.append(to)
    for x in range(n):
        for y in range(n):
            for to in ((x + 1, y), (x, y + 1)):
                if max(to) < n and draw.random() < opened:
                    open_wall((x, y), to)
    return ["".join(".@"[1 - c] for c in row) for row in free]


def map_text(rows):
    return f"type octile\nheight {len(rows)}\nwidth {len(rows[0])}\nmap\n" + "\n".join(rows) + "\n"


def queries_text(rows, count, seed=2):
    draw = random.Random(seed)
    free = [(x + 0.5, y + 0.5) for y, row in enumerate(rows) for x, c in enumerate(row) if c == "."]
    return "".join("{} {} {} {}\n".format(*draw.choice(free), *draw.choice(free)) for _ in range(count))


class Program:
    def __init__(self, path, folder):
        self.path, self.folder = path, folder

    def file(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="ascii") as out:
            out.write(text)
        return path

    def run(self, *arguments):
        """CPU seconds and what it said on stderr. By a shell: what this process has in memory would count as theirs."""
        with open(os.devnull, "w", encoding="ascii") as nothing:
            child = subprocess.Popen(["sh", "-c", '"$@"; exit $?', "sh", self.path, *arguments], stdout=nothing,
                                     stderr=subprocess.PIPE)
            said = child.stderr.read().decode()
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode != 0:
            raise RuntimeError(f"taut {' '.join(arguments)} ended with {child.returncode}: {said.strip()}")
        return usage.ru_utime + usage.ru_stime, said


def peak_in(said):
    return float(re.search(r"peak memory ([\d.]+) MB", said).group(1)) * 1024 ** 2


class Figures:
    def __init__(self, program, runs, wanted):
        self.program, self.runs, self.wanted, self.list = program, runs, wanted, []

    def wants(self, name):
        return re.search(self.wanted, name) is not None

    def add(self, name, seconds, memory):
        print(f"{name:<44} {seconds * 1e3:12.4f} ms {memory / 1e6:8.1f} MB", file=sys.stderr)
        self.list.append({"name": name, "run_name": name, "cpu_time": seconds * 1e9, "time_unit": "ns",
                          "memory_bytes": memory})

    def process(self, name, *arguments):
        if not self.wants(f"process/{name}"):
            return
        with_it, without, memory = [], [], 0
        for _ in range(self.runs):
            seconds, said = self.program.run(*arguments, "--stats")
            with_it.append(seconds)
            memory = max(memory, peak_in(said))
            without.append(self.program.run("--version")[0])
        self.add(f"process/{name}", max(0, statistics.median(with_it) - statistics.median(without)), memory)

    def said(self, kind, name, pattern, unit, *arguments):
        """A number that the program says of itself, in units of so many CPU seconds; the median."""
        if not self.wants(f"{kind}/{name}"):
            return
        values, memory = [], 0
        for _ in range(max(1, self.runs // 2)):
            _, said = self.program.run(*arguments, "--stats")
            values.append(float(re.search(pattern, said, re.MULTILINE).group(1)) * unit)
            memory = max(memory, peak_in(said))
        self.add(f"{kind}/{name}", statistics.median(values), memory)

    def on_map(self, name, file, queries, ends):
        self.process(name, "solve", file, *ends)
        self.said("query", name, r"([\d.]+) us CPU a query", 1e-6, "batch", file, queries, "--path")
        self.said("graph", name, r"^roadmap +cpu ([\d.]+) s", 1, "roadmap", file, "--kind", "full")


def ends_in(queries):
    """Of the first query, as options."""
    with open(queries, encoding="ascii") as file:
        line = next(line for line in file if line.strip() and not line.startswith("#"))
    a, b, c, d = line.split()[:4]
    return "--from", f"{a},{b}", "--to", f"{c},{d}"


def measure(figures):
    program = figures.program
    for wide in (1, 4, 8):
        for opened in (0, 0.2):
            name = f"maze512-{wide}" + ("-20%-open" if opened else "")
            if not any(figures.wants(f"{kind}/{name}") for kind in ("process", "query", "graph", "pair")):
                continue
            rows = cells_of_maze(512, wide, opened)
            file = program.file("maze.map", map_text(rows))
            queries = program.file("maze.queries", queries_text(rows, 2000))
            corner = len(rows) - 1.5
            figures.on_map(name, file, queries, ("--from", "1.5,1.5", "--to", f"{corner},{corner}"))
            if figures.wants(f"pair/{name}"):
                points = program.file("points.txt", "".join(
                    " ".join(line.split()[:2]) + "\n" for line in queries_text(rows, 2000).splitlines()))
                figures.said("pair", name, r"^search +cpu ([\d.]+) s", 1 / 2000 ** 2, "matrix", file, points, "-o",
                             os.path.join(program.folder, "lengths.f64"))
    for size in (100, 1000):
        if figures.wants(f"process/thin{size}"):
            maze = os.path.join(program.folder, f"thin{size}.txt")
            program.run("generate", "--size", str(size), "--seed", "1", "-o", maze)
            figures.process(f"thin{size}", "solve", maze)
    others = os.path.join(os.environ.get("TAUT_SHARED_DATA", ""), "movingai")
    for file in sorted(glob.glob(os.path.join(others, "*.map.gz"))):
        queries = file.removesuffix(".map.gz") + ".queries"
        if os.path.exists(queries):
            figures.on_map(os.path.basename(file).removesuffix(".map.gz"), file, queries, ends_in(queries))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("taut", help="the program")
    parser.add_argument("--filter", default=".", metavar="REGEX", help="of names such as process/maze512-1")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--out", metavar="RUN.json")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        figures = Figures(Program(os.path.abspath(options.taut), folder), options.runs, options.filter)
        measure(figures)
    if options.out:
        with open(options.out, "w", encoding="utf-8") as file:
            json.dump({"context": {"executable": "process"}, "benchmarks": figures.list}, file, indent=1)


if __name__ == "__main__":
    main()
