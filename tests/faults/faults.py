#!/usr/bin/env python3
"""Deliberate faults: is each small one caught by the tests?

usage: faults.py SOURCE BUILD [--only NAME ...] [--jobs N]

For each fault of faults.txt: a copy of the file with the text replaced is compiled as BUILD (configured, its taut_tests built and up to
date) compiles the file, and stands before the library when the tests of geometry, roadmaps, search and verify are linked anew; all of
it in a folder of its own, SOURCE and BUILD stay as they are. Prints which test saw the fault; exit status 1 when more than a tenth is
missed.
"""
import argparse
import concurrent.futures
import json
import re
import shlex
import subprocess
import sys
import tempfile
import time
from pathlib import Path

FOLDERS = ["geometry", "roadmaps", "search", "verify", "oracles"]
SETTINGS = {"RC_PARAMS": "seed=1", "TAUT_RANDOM_WORLDS": "300", "PATH": "/usr/bin:/bin"}


class Fault:
    """`NAME FILE`, then lines `- old` and `+ new`: the old text stands exactly once in the file."""

    def __init__(self, paragraph):
        head, *lines = paragraph.strip().splitlines()
        self.name, self.file = head.split()
        self.old = "\n".join(line[2:] for line in lines if line.startswith("- "))
        self.new = "\n".join(line[2:] for line in lines if line.startswith("+ "))

    def text(self, source):
        text = (source / self.file).read_text()
        if text.count(self.old) != 1:
            sys.exit(f"{self.name}: {self.file} has {text.count(self.old)} places like `{self.old}`")
        return text.replace(self.old, self.new)


class Build:
    def __init__(self, source, folder):
        self.source, self.folder = source, folder
        commands = json.loads((folder / "compile_commands.json").read_text())
        self.compile_commands = {Path(c["file"]): shlex.split(c["command"]) for c in commands}
        link = subprocess.run(["ninja", "-C", folder, "-t", "commands", "-s", "tests/taut_tests"], capture_output=True, text=True, check=True)
        words = next(line for line in link.stdout.splitlines() if " -o tests/taut_tests" in line).split("&&")[1]
        self.link_command = [word for word in shlex.split(words) if self.is_wanted(word)]

    def is_wanted(self, word):
        """Other folders' tests are not linked, which makes a second of ten."""
        part = re.match(r"tests/CMakeFiles/taut_tests\.dir/(\w+)/.*\.o$", word)
        return not part or part[1] in FOLDERS + ["support"]

    def compile(self, fault, folder):
        """An object with the fault; nothing where the compiler refuses."""
        copy, made = folder / Path(fault.file).name, folder / "fault.o"
        copy.write_text(fault.text(self.source))
        command = list(self.compile_commands[self.source / fault.file])
        command[command.index("-o") + 1] = str(made)
        command[command.index("-c") + 1] = str(copy)
        return made if subprocess.run(command, cwd=self.folder, capture_output=True).returncode == 0 else None

    def link(self, made, folder):
        command, program = list(self.link_command), folder / "tests"
        command[command.index("-o") + 1] = str(program)
        if made:
            command.insert(command.index("-o"), str(made))
        subprocess.run(command, cwd=self.folder, check=True)
        return program


def who_sees(fault, build):
    """The first test that fails; nothing when all pass. Without a fault none may."""
    with tempfile.TemporaryDirectory() as name:
        made = build.compile(fault, Path(name)) if fault else None
        if fault and not made:
            return "the compiler"
        program = build.link(made, Path(name))
        try:
            run = subprocess.run([program, "--gtest_fail_fast", "--gtest_brief=1"], capture_output=True, text=True, timeout=300, env=SETTINGS)
        except subprocess.TimeoutExpired:
            return "the limit of time"
    if run.returncode == 0:
        return ""
    failed = re.search(r"^\[  FAILED  \] (\S+)", run.stdout, re.MULTILINE)
    return failed[1].rstrip(",") if failed else f"a test that ends with signal {-run.returncode}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source", type=Path)
    parser.add_argument("build", type=Path)
    parser.add_argument("--only", nargs="+")
    parser.add_argument("--jobs", type=int, default=1)
    asked = parser.parse_args()
    paragraphs = (Path(__file__).parent / "faults.txt").read_text().split("\n\n")
    faults = [Fault(text) for text in paragraphs if text.strip() and not text.startswith("#")]
    faults = [fault for fault in faults if asked.only is None or fault.name in asked.only]
    build = Build(asked.source.resolve(), asked.build.resolve())
    if who := who_sees(None, build):
        sys.exit(f"{who} fails without a fault")

    def tell(fault):
        begin = time.monotonic()
        who = who_sees(fault, build)
        print(f"{fault.name:28} {who or 'MISSED'}  ({time.monotonic() - begin:.0f} s)", flush=True)
        return bool(who)

    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        caught = sum(pool.map(tell, faults))
    print(f"{caught} of {len(faults)} faults caught")
    sys.exit(1 if (len(faults) - caught) * 10 > len(faults) else 0)


if __name__ == "__main__":
    main()
