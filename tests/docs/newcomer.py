#!/usr/bin/env python3
"""What the tasks of docs/newcomer.md cost from a fresh clone: commands typed, CPU and wall time of each.

usage: newcomer.py ROOT [--ccache]     ROOT's HEAD is cloned, and what the page says is typed there, in its order. The
                                       program is built anew: minutes, and without ccache unless it is asked for
"""
import os
import re
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from blocks import Page, commands

SCRIPT = "path.py"  # what the page calls its block of Python


def cpu():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def tasks(page):
    """[(title, blocks)] of the page's sections."""
    starts = [(number, line[3:]) for number, line in page.prose if line.startswith("## ")]
    ends = [number for number, _ in starts[1:]] + [float("inf")]
    for (begin, title), end in zip(starts, ends):
        yield title, [block for block in page.blocks if begin < block.line < end]


def typed(command):
    """As it is typed, but for what waits for somebody who ends it."""
    return f"{command} --for 1" if re.search(r"--serve$", command) else command


def main():
    root = Path(sys.argv[1]).resolve()
    environment = dict(os.environ)
    if "--ccache" not in sys.argv:
        environment["CCACHE_DISABLE"] = "1"
    print("| task | commands | CPU | wall |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["git", "clone", "-q", root, folder], check=True)
        for title, blocks in tasks(Page(Path(folder) / "docs/newcomer.md")):
            count, before, begin = 0, cpu(), time.monotonic()
            for block in blocks:
                if block.language == "python":
                    (Path(folder) / SCRIPT).write_text(block.text, encoding="utf-8")
                for command in commands(block.text) if block.language == "sh" else ():
                    count += 1
                    subprocess.run(["bash", "-c", typed(command)], cwd=folder, env=environment, check=True,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
            print(f"| {title} | {count} | {cpu() - before:.1f} s | {time.monotonic() - begin:.1f} s |", flush=True)


if __name__ == "__main__":
    main()
