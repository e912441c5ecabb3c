#!/usr/bin/env python3
"""Deliberate faults: is each small one caught by the tests?

usage: faults.py SOURCE BUILD [--only NAME]

SOURCE is a checkout of its own (its files are changed and put back), BUILD a configured build folder of it. For each fault of faults.txt:
the text is replaced, the test program built, the fast tests run, which are those of the library below the robots. Prints who caught it;
exit status 1 when more than a tenth is missed.
"""
import argparse
import re
import subprocess
import sys
import time
from pathlib import Path

FOLDERS = ["geometry", "roadmaps", "search", "verify", "oracles"]


class Fault:
    """`NAME FILE`, then lines `- old` and `+ new`: the old text stands exactly once in the file."""

    def __init__(self, paragraph):
        head, *lines = paragraph.strip().splitlines()
        self.name, self.file = head.split()
        self.old = "\n".join(line[2:] for line in lines if line.startswith("- "))
        self.new = "\n".join(line[2:] for line in lines if line.startswith("+ "))

    def put_into(self, source):
        path = source / self.file
        text = path.read_text()
        if text.count(self.old) != 1:
            sys.exit(f"{self.name}: {self.file} has {text.count(self.old)} places like `{self.old}`")
        path.write_text(text.replace(self.old, self.new))
        return path, text


def faults():
    paragraphs = (Path(__file__).parent / "faults.txt").read_text().split("\n\n")
    return [Fault(text) for text in paragraphs if text.strip() and not text.startswith("#")]


def fast_tests(source):
    """A filter with the suites of those folders, the small ones first in their files."""
    suites = set()
    for folder in FOLDERS:
        for path in (source / "tests" / folder).rglob("*_test.cpp"):
            suites |= set(re.findall(r"^(?:TEST|TEST_F|TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\((\w+),", path.read_text(), re.MULTILINE))
    return ":".join(f"{suite}.*:*/{suite}.*" for suite in sorted(suites))


def caught_by(build, tests):
    """The first test that fails; `build` where the compiler refuses, nothing when all pass."""
    made = subprocess.run(["ninja", "-C", build, "taut_tests", "taut_program"], capture_output=True, text=True)
    if made.returncode != 0:
        return "the compiler"
    try:
        run = subprocess.run([build / "tests/taut_tests", f"--gtest_filter={tests}", "--gtest_fail_fast", "--gtest_brief=1"],
                             capture_output=True, text=True, timeout=600, env={"RC_PARAMS": "seed=1 max_success=20", "PATH": "/usr/bin:/bin", "TAUT_RANDOM_WORLDS": "300"})
    except subprocess.TimeoutExpired:
        return "the limit of time"
    if run.returncode == 0:
        return ""
    failed = [line for line in run.stdout.splitlines() if line.startswith("[  FAILED  ]")]
    return failed[0].split("]")[1].split("(")[0].strip() if failed else f"exit {run.returncode}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source", type=Path)
    parser.add_argument("build", type=Path)
    parser.add_argument("--only")
    asked = parser.parse_args()
    chosen = [fault for fault in faults() if asked.only in (None, fault.name)]
    missed, tests = [], fast_tests(asked.source)
    for fault in chosen:
        begin = time.monotonic()
        path, text = fault.put_into(asked.source)
        try:
            who = caught_by(asked.build.resolve(), tests)
        finally:
            path.write_text(text)
        if not who:
            missed.append(fault.name)
        print(f"{fault.name:28} {who or 'MISSED'}  ({time.monotonic() - begin:.0f} s)", flush=True)
    print(f"{len(chosen) - len(missed)} of {len(chosen)} faults caught")
    sys.exit(1 if len(missed) * 10 > len(chosen) else 0)


if __name__ == "__main__":
    main()
