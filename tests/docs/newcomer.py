#!/usr/bin/env python3
"""What the tasks of docs/newcomer.md cost from a fresh clone: commands typed, CPU and wall time of each.

usage: newcomer.py ROOT [PYTHONPATH]     the program is built anew, without ccache: minutes. Blocks of Python run where a
                                         package is named
"""
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from blocks import Page, commands


def cpu():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main():
    root = Path(sys.argv[1]).resolve()
    environment = dict(os.environ, CCACHE_DISABLE="1")
    if len(sys.argv) > 2:
        environment["PYTHONPATH"] = os.path.abspath(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["git", "clone", "-q", root, folder], check=True)
        for block in Page(root / "docs/newcomer.md").blocks:
            if block.language == "python" and len(sys.argv) <= 2:
                continue
            words = [["python3", "-c", block.text]] if block.language == "python" else [
                ["bash", "-c", command] for command in commands(block.text)]
            before, begin = cpu(), time.monotonic()
            for command in words:
                subprocess.run(command, cwd=folder, env=environment, check=True, stdout=subprocess.DEVNULL)
            print(f"{block.line}: {len(words)} typed, {cpu() - before:.1f} s CPU, {time.monotonic() - begin:.1f} s wall")


if __name__ == "__main__":
    main()
