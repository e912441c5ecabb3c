#!/usr/bin/env python3
"""Damaged files and random options against the program: each run ends as promised, whatever it is given.

usage: attack.py TAUT DATA [--runs N] [--seed S] [--only K] [--seconds T] [--keep FOLDER]

Run K of a seed is always the same, so that a finding is repeated by `--only K`. Exit status 1 when anything was found.
"""
import argparse
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import commands
import judge
import mutate
import surroundings

LIMIT = 20  # seconds of CPU; each run is told to stop after one by itself
MEMORY = 3 << 30
WORTH_LEARNING = 1000  # runs: before so many it is found out which file each subcommand takes
OUTPUTS = ["out.svg", "out.json", "out.png", "out.txt", "-"]


def limits():
    resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT + 1))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def seeds(taut, data, folder):
    """Good files to be damaged: the examples, and what the program writes about one of them."""
    for path in sorted(data.rglob("*")):
        if path.is_file() and path.stat().st_size < 60000 and path.suffix != ".md":
            shutil.copy(path, folder / path.name)
    maze = folder / "maze_25x25.txt"
    made = {"saved.taut": ["solve", maze, "--roadmap", "visibility", "--save"], "proof": ["solve", maze, "--certificate"],
            "path.csv": ["solve", maze, "--csv"], "path.json": ["solve", maze, "--json"], "path.geojson": ["solve", maze, "--geojson"],
            "proof.json": ["mouse", "run", folder / "mouse_12.cells", "--explorer", "prove", "--certificate"]}
    for name, words in made.items():
        subprocess.run([taut, *words, folder / name], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    (folder / "queries").write_text("0.5 0.5 3.5 6.5\n1 1 2 2 1.414214\n0.5 0.5 9 9 none\n# a comment\n")
    (folder / "points").write_text("0.5 0.5\n1.5 2.5\n3.5 3.5\n")
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


def one(taut, choice, good, known, folder):
    """One run in a folder of its own: its command line and its findings."""
    subcommand = choice.choice(known)
    every = sorted(good)
    first = choice.choice(subcommand.reads if subcommand.reads and choice.random() < 0.9 else every)
    names = [first, choice.choice(commands.SECOND.get(subcommand.words[-1], every)), choice.choice(every)]
    harmed = choice.choice([names, names[:1], names[1:]])
    for name in names:
        (folder / name).write_bytes(mutate.damaged(good[name], choice) if name in harmed else good[name])
    inputs = [*names, "-", "absent", "."]
    before = set(names)
    for name in OUTPUTS[:-1]:
        if choice.random() < 0.5:
            (folder / name).write_bytes(judge.OLD)
    words = subcommand.line(choice, inputs, OUTPUTS)
    words += ["--max-seconds", "1"] if "generate" not in words or choice.random() < 0.8 else []
    words = [word.replace("\0", "") for word in words]
    begin = children_seconds()
    with open(folder / names[0], "rb") as stdin:
        done = subprocess.run([taut, *words], stdin=stdin, capture_output=True, cwd=folder, preexec_fn=limits, timeout=600)
    seconds = children_seconds() - begin
    outputs = [name for name in OUTPUTS if name != "-" and name not in before]
    return words, done, judge.broken_promises(done, words, seconds, LIMIT / 2, outputs, before, folder)


def children_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("taut")
    parser.add_argument("data", type=Path)
    parser.add_argument("--runs", type=int, default=20000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, help="this run alone, and what it says")
    parser.add_argument("--keep", type=Path, help="copy the files of findings here")
    return parser.parse_args()


def main():
    asked = arguments()
    taut = os.path.abspath(asked.taut)
    known = commands.subcommands(taut)
    codes, findings, begin = Counter(), 0, time.monotonic()
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place) / "seeds"
        folder.mkdir()
        good = seeds(taut, asked.data.resolve(), folder)
        for subcommand in known if asked.runs >= WORTH_LEARNING else []:
            subcommand.learn(taut, sorted(good), folder)
        runs = range(asked.runs) if asked.only is None else [asked.only]
        for k in runs:
            folder = Path(place) / str(k)
            folder.mkdir()
            words, done, broken = one(taut, random.Random(f"{asked.seed} {k}"), good, known, folder)
            codes[done.returncode] += 1
            if broken or asked.only is not None:
                findings += bool(broken)
                print(f"{k}: {'; '.join(broken) or 'as promised'}: taut {' '.join(map(repr, words))}"[:700], flush=True)
                if asked.only is not None:
                    print(f"exit {done.returncode}\n{done.stdout.decode('utf-8', 'replace')}{done.stderr.decode('utf-8', 'replace')}")
                if asked.keep:
                    shutil.copytree(folder, asked.keep / str(k), dirs_exist_ok=True)
            shutil.rmtree(folder)
        if asked.only is None:
            for finding in surroundings.findings(taut, good, Path(place)):
                findings += 1
                print(finding, flush=True)
    told = ", ".join(f"{count} x exit {code}" for code, count in sorted(codes.items()))
    print(f"{sum(codes.values())} runs of {len(known)} subcommands on {len(good)} damaged files in {time.monotonic() - begin:.0f} s: {told}; "
          f"{surroundings.COUNT} surroundings; {findings} findings")
    sys.exit(1 if findings else 0)


if __name__ == "__main__":
    main()
