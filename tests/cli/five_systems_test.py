#!/usr/bin/env python3
"""Runs every command of docs/five-systems.md: each ends well and writes what it promises.

usage: five_systems_test.py TAUT ROOT
"""
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path


def commands(page):
    """The commands in the last column of each table, options that stand alone joined to the command before them."""
    for row in re.findall(r"^\| .* \| (.*) \|$", page, re.MULTILINE):
        whole = None
        for code in re.findall(r"`([^`]*)`", row):
            if code == "taut solve -":
                continue  # the other end of a pipe, run with it
            if code.startswith("taut "):
                whole = code
                yield code
            else:
                yield f"{without_last_option(whole)} {code}"


def without_last_option(command):
    """The command without the last option and its value: another value, or another option, takes its place."""
    words = shlex.split(command)
    options = [i for i, word in enumerate(words) if word.startswith("--")]
    return shlex.join(words[: options[-1]]) if options else command


def run(taut, command, root, folder):
    words = shlex.split(command)
    assert words[0] == "taut", command
    words = [str(root / word) if word.startswith("data/") else word for word in words[1:]]
    words = [word.replace("examples/", f"{root}/examples/") if "examples/" in word else word for word in words]
    if command.startswith("taut generate"):
        maze = subprocess.run([taut, *words], capture_output=True, cwd=folder, check=True).stdout
        words = ["solve", "-"]
    else:
        maze = None
    done = subprocess.run([taut, *words], input=maze, capture_output=True, cwd=folder, timeout=300)
    # Where all samples are driven some have no way, which is an answer.
    if done.returncode not in ((0, 1) if "--all" in words else (0,)):
        sys.exit(f"{command}: exit {done.returncode}\n{done.stderr.decode()}")
    if not done.stdout:
        sys.exit(f"{command}: says nothing")
    for name in re.findall(r"\b[a-z]+\.(?:svg|json)\b", command):
        if not (folder / name).stat().st_size:
            sys.exit(f"{command}: writes no {name}")


def main():
    taut, root = sys.argv[1], Path(sys.argv[2]).resolve()
    page = (root / "docs/five-systems.md").read_text()
    all_of_them = list(commands(page))
    if len(all_of_them) < 35:
        sys.exit(f"only {len(all_of_them)} commands found")
    with tempfile.TemporaryDirectory() as folder:
        for command in all_of_them:
            run(os.path.abspath(taut), command, root, Path(folder))
    print(f"{len(all_of_them)} commands")


if __name__ == "__main__":
    main()
