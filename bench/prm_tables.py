#!/usr/bin/env python3
"""Tables of probabilistic roadmaps, made by the program as anybody would call it.

prm_tables.py homework TAUT [--sizes 5x7,41,45,61,80,160] [--runs N]
    The numbers of the course's homework (500 samples kept at 0.1 from the walls, 8 nearest; the lattice), the same
    grown until it solves, ours and the shortest path, beside the times that others published.
prm_tables.py samplers TAUT [--runs N] [--samples N]
    Each sampler on mazes and on plans with narrow passages: how often it solves within so many samples, how many it
    drew for that, and CPU seconds.

Each run has a seed of its own. Times are user CPU of the whole process, reading the maze and building free space
counted, generating the maze not; of runs that found a path the median. Lengths are over the shortest path's.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile

# Seconds on the laptops of others, in MATLAB; generation not counted.
PUBLISHED = {
    "41x41": "11.6 and 13.8",
    "45x45": "16.5",
    "61x61": "18.9",
    "80x80": "2.55 (cell centres)",
    "160x160": "37.1 (cell centres)",
}
HOMEWORK = {
    "500 samples": ["--roadmap", "prm-fixed"],
    "as many as it takes": ["--roadmap", "prm", "--prm-clearance", "0.1", "--connection", "nearest:8"],
    "the same, lazy": ["--roadmap", "prm", "--prm-clearance", "0.1", "--connection", "nearest:8", "--lazy"],
    "lattice": ["--roadmap", "prm-lattice", "--connection", "nearest:8"],
    "prm, as it comes": ["--roadmap", "prm"],
    "the shortest path": [],
}
SAMPLERS = ["sobol", "uniform", "lattice", "gaussian", "bridge", "medial-axis", "corners"]


def solve(taut, file, options, seconds):
    """(answer, user CPU seconds) of one process."""
    command = [taut, "solve", file, *options, "--json", "-", "--quiet", "--max-seconds", str(seconds)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    out = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in (0, 4):
        raise SystemExit(f"{' '.join(command)}: exit code {process.returncode}")
    return json.loads(out), usage.ru_utime


def runs_of(taut, file, options, seconds, runs):
    """What became of runs with the seeds 1, 2, ...: times, lengths and samples of those that found a path."""
    times, lengths, samples = [], [], []
    for seed in range(1, runs + 1):
        answer, time = solve(taut, file, [*options, "--seed", str(seed)], seconds)
        if answer["status"] == "found":
            times.append(time)
            lengths.append(answer["result"]["length"])
            samples.append(answer["result"].get("prm", {}).get("samples", 0))
    return times, lengths, samples


def middle(values, form):
    return form.format(statistics.median(values)) if values else "-"


def homework(options):
    print("| maze | roadmap | solved | CPU s | length | published, s |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as scratch:
        for size in options.sizes.split(","):
            size = size if "x" in size else f"{size}x{size}"
            rows, columns = size.split("x")
            file = os.path.join(scratch, "maze.txt")
            make = [options.taut, "generate", "--size", f"{columns}x{rows}", "--seed", "1", "-o", file]
            subprocess.run(make, check=True)
            shortest = solve(options.taut, file, [], options.seconds)[0]["result"]["length"]
            for name, words in HOMEWORK.items():
                runs = 1 if name in ("lattice", "the shortest path") else options.runs
                times, lengths, _ = runs_of(options.taut, file, words, options.seconds, runs)
                print(f"| {size} | {name} | {len(times)} of {runs} | {middle(times, '{:.3f}')} | "
                      f"{middle([n / shortest for n in lengths], '{:.3f}')} | {PUBLISHED.get(size, '')} |", flush=True)


def rooms_in_a_row(rooms, width, depth):
    """Rooms of 10 x 10, their walls `depth` thick, through each a passage `width` wide, alternately low and high."""
    lines, x = [], 0.0
    for k in range(rooms):
        lines += [f"{x} 0 {x + 10} 0", f"{x} 10 {x + 10} 10"]
        if k in (0, rooms - 1):
            end = x if k == 0 else x + 10
            lines.append(f"{end} 0 {end} 10")
        if k + 1 == rooms:
            break
        y = 2 if k % 2 == 0 else 8
        for side in (x + 10, x + 10 + depth):
            lines += [f"{side} 0 {side} {y}", f"{side} {y + width} {side} 10"]
        lines += [f"{x + 10} {v} {x + 10 + depth} {v}" for v in (y, y + width)]
        x += 10 + depth
    return "\n".join(lines) + "\n", f"{x + 9},5"


def worlds_of(taut, scratch):
    """(name, file, options that ask the query)."""
    worlds = []
    for name, words in (("maze 25 x 25", ["--size", "25"]), ("maze 61 x 61", ["--size", "61"]),
                        ("maze 41 x 41, a fifth of its walls down", ["--size", "41", "--loops", "0.2"])):
        file = os.path.join(scratch, f"{len(worlds)}.txt")
        subprocess.run([taut, "generate", *words, "--seed", "1", "-o", file], check=True)
        worlds.append((name, file, []))
    worlds.append(("maze 25 x 25 as a disc of 0.4", worlds[0][1], ["--robot", "disc:0.4"]))
    for width in (1, 0.2, 0.05):
        file = os.path.join(scratch, f"{len(worlds)}.txt")
        text, goal = rooms_in_a_row(6, width, 1)
        with open(file, "w") as out:
            out.write(text)
        worlds.append((f"6 rooms, 5 passages {width} wide", file, ["--from", "1,5", "--to", goal]))
    return worlds


def samplers(options):
    print("| world | " + " | ".join(SAMPLERS) + " |\n|---|" + "---|" * len(SAMPLERS))
    with tempfile.TemporaryDirectory() as scratch:
        for name, file, query in worlds_of(options.taut, scratch):
            cells = []
            for sampler in SAMPLERS:
                runs = 1 if sampler == "lattice" else options.runs
                words = [*query, "--roadmap", "prm", "--sampler", sampler, "--samples", str(options.samples)]
                times, _, samples = runs_of(options.taut, file, words, options.seconds, runs)
                cells.append(f"{len(times)} of {runs}, {middle(samples, '{:.0f}')}, {middle(times, '{:.2f}')}")
            print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", choices=("homework", "samplers"))
    parser.add_argument("taut")
    parser.add_argument("--sizes", default="5x7,41,45,61,80,160")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--samples", type=int, default=30000)
    parser.add_argument("--seconds", type=float, default=300)
    options = parser.parse_args()
    (homework if options.table == "homework" else samplers)(options)
    return 0


if __name__ == "__main__":
    sys.exit(main())
