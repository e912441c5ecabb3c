#!/usr/bin/env python3
"""Both judges of certificates say the same: of what `taut solve` writes, and of what was done to it.

usage: certificate_test.py TAUT DATA [WORLDS]
"""

import copy
import json
import os
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from certificate import Judge, Refused  # noqa: E402
from certificate_cases import CASES  # noqa: E402
from certificate_of_room import RoomJudge  # noqa: E402

FILES = ["maze_5x7.txt", "maze_25x25.txt", "islands.wkt"]


def any_world(rng):
    """Walls that cross, touch and overlap, and now and then a wall all across."""
    side = rng.choice([5, 8])
    number = lambda: rng.randrange(side + 1)  # noqa: E731
    walls = [[number() for _ in range(4)] for _ in range(rng.randrange(1, 14))]
    if rng.random() < 0.3:
        at = rng.randrange(1, side)
        walls.append([at, 0, at, side])
    ends = [f"{word} {rng.randrange(4 * side + 1) / 4} {rng.randrange(4 * side + 1) / 4}" for word in ("start", "goal")]
    if rng.random() < 0.4:  # a room
        x, y = rng.randrange(2 * side - 1) / 2, rng.randrange(2 * side - 1) / 2
        ends[1] = f"goal {x} {y} {x + rng.choice([0.5, 1])} {y + rng.choice([0.5, 1])}"
    lines = [f"boundary 0 0 {side} {side}", *ends, *(" ".join(map(str, w)) for w in walls)]
    return "\n".join(lines) + "\n"


def tampered(claim, rng):
    claim = copy.deepcopy(claim)
    if "chain" in claim:
        return tampered_chain(claim, rng)
    rows, path, unit = claim["potentials"], claim["path"], 2 ** claim["fraction_bits"]
    what = rng.randrange(7)
    if what == 5 and "reach" in claim:
        claim["reach"] += rng.choice([-1, 1]) * rng.randrange(1, 3 * unit)
    elif what == 6:
        rng.choice(claim["goal"])[rng.randrange(2)] += rng.choice([-1, 1]) * claim["scale"]
    elif what == 0:
        rng.choice(rows)[2] += rng.choice([-1, 1]) * rng.randrange(1, 3 * unit)
    elif what == 1:
        rng.choice(path)[rng.randrange(2)] += rng.choice([-1, 1])
    elif what == 2 and len(path) > 2:
        path.pop(rng.randrange(1, len(path) - 1))
    elif what == 3:
        rows.pop(rng.randrange(len(rows)))
    else:
        claim["horizon"] += rng.randrange(-3 * unit, 3 * unit)
    return claim


def tampered_chain(claim, rng):
    chain, unit = claim["chain"], claim["scale"]
    what = rng.randrange(4)
    if what == 0:
        chain.pop(rng.randrange(len(chain)))
    elif what == 1:
        rng.choice(chain)[rng.randrange(2)] += rng.choice([-unit, unit])
    elif what == 2:
        claim["width"] = max(0, claim["width"] - rng.randrange(1, 2 * unit))
    elif "keeps" in claim:
        claim["keeps"] += rng.randrange(1, unit)
    return claim


def judged(text, claim):
    """The exit code of the judge in Python, and what it says."""
    judge = Judge if claim["goal"][0] == claim["goal"][-1] else RoomJudge
    try:
        return 0, judge(text, json.dumps(claim)).verdict()
    except Refused as refused:
        return 1, refused
    except (ValueError, TypeError, LookupError, ArithmeticError) as error:
        return 3, error


class Case:
    def __init__(self, taut, folder):
        self.taut, self.folder = taut, folder
        self.proven = self.refused = 0
        self.faults = []

    def run(self, *words):
        return subprocess.run([self.taut, *words], capture_output=True, text=True, timeout=60, check=False)

    def file(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as out:
            out.write(text)
        return path

    def certificate(self, world, *more):
        path = os.path.join(self.folder, "proof")
        if os.path.exists(path):
            os.remove(path)
        self.run("solve", world, "--certificate", path, "-q", *more)
        if not os.path.exists(path):
            return None
        with open(path, encoding="utf-8") as text:
            return json.load(text)

    def integers(self, world):
        """The text that the certificate just written is about."""
        path, proof = os.path.join(self.folder, "integers"), os.path.join(self.folder, "proof")
        self.run("verify", world, proof, "--integers", path, "-q")
        with open(path, encoding="utf-8") as text:
            return text.read()

    def compare(self, world, text, claim):
        """Does our program judge as this file does?"""
        answer = self.run("verify", world, self.file("claim", json.dumps(claim)))
        ours, _ = judged(text, claim)
        self.proven += ours == 0
        self.refused += ours == 1
        if ours != answer.returncode and 3 not in (ours, answer.returncode):
            self.faults.append(f"{answer.returncode}, not {ours}: {answer.stdout}{answer.stderr}\n{text}\n{claim}")

    def world(self, world, rng, changes, discs=True):
        asked = ((), ("--widest",), ("--robot", f"disc:{rng.choice([0.25, 0.5, 0.75])}"))
        for more in asked if discs else asked[:1]:
            claim = self.certificate(world, *more)
            if claim is None:
                continue
            text = self.integers(world)
            code, words = judged(text, claim)
            if code != 0:
                self.faults.append(f"not proven: {world} {more}: {words}")
            self.compare(world, text, claim)
            for _ in range(changes):
                self.compare(world, text, tampered(claim, rng))


def main():
    taut, data = sys.argv[1:3]
    rng = random.Random(1)
    with tempfile.TemporaryDirectory() as folder:
        case = Case(taut, folder)
        for expected, name, text, claim in CASES:
            code, words = judged(text, claim)
            if code != expected:
                case.faults.append(f"{name}: {code}, not {expected}: {words}")
        for name in FILES:
            case.world(os.path.join(data, name), rng, 1, discs=name == FILES[0])
        for _ in range(int(sys.argv[3]) if len(sys.argv) > 3 else 30):
            case.world(case.file("world.txt", any_world(rng)), rng, 3)
    for fault in case.faults[:5]:
        print(fault)
    print(f"{case.proven} proven, {case.refused} not, {len(case.faults)} judged differently")
    return case.faults != [] or case.proven < 20 or case.refused < 20


if __name__ == "__main__":
    sys.exit(main())
