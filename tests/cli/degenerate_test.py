#!/usr/bin/env python3
"""Worlds full of coincidences, each with the answer that one finds by hand: taut gives it, there and back, by all planners.

usage: degenerate_test.py TAUT FOLDER

A file says in its second line what is right: a length, as a formula, `none` or `refused`.
"""
import json
import math
import re
import subprocess
import sys
from pathlib import Path

PLANNERS = ["polyanya", "visibility", "full", "visibility-brute"]


def solve(taut, *words):
    done = subprocess.run([taut, "solve", *words, "--json", "-"], capture_output=True, text=True, timeout=60)
    return done.returncode, json.loads(done.stdout)


def swapped(text):
    """Start and goal exchanged; nothing where the goal is a room."""
    if re.search(r"^goal( \S+){4}", text, re.MULTILINE):
        return None
    if text.count("POINT (") == 2:
        body, start, goal, _ = re.split(r"(POINT \(.*\)\n)(POINT \(.*\)\n)", text)
        return body + goal + start
    return re.sub("^(start|goal) ", lambda word: {"start": "goal ", "goal": "start "}[word[1]], text, flags=re.MULTILINE)


def judged(answer, code, result):
    """What is wrong; empty when nothing is."""
    if answer == "refused":
        return "" if code == 3 else f"exit {code}"
    if answer == "none":
        return "" if code == 1 and result["status"] == "none" else f"exit {code}, {result['status']}"
    length = eval(answer, {"sqrt": math.sqrt})  # of our own files
    if code != 0:
        return f"exit {code}, {result.get('reason')}"
    found = result["result"]["length"]
    return "" if abs(found - length) <= 1e-9 * length else f"{found} long"


def findings(taut, path):
    text = path.read_text()
    answer = re.search(r"^# answer: (.*)$", text, re.MULTILINE)[1]
    for planner in PLANNERS:
        yield planner, judged(answer, *solve(taut, str(path), "--roadmap", planner))
    other_way = swapped(text)
    if other_way and answer != "refused":
        done = subprocess.run([taut, "solve", "-", "--json", "-"], input=other_way, capture_output=True, text=True, timeout=60)
        yield "back", judged(answer, done.returncode, json.loads(done.stdout))


def main():
    taut, folder = sys.argv[1], Path(sys.argv[2])
    worlds = sorted(path for path in folder.iterdir() if path.suffix in (".txt", ".wkt"))
    wrong = [f"{path.name}, {who}: {what}" for path in worlds for who, what in findings(taut, path) if what]
    print("\n".join(wrong))
    if len(worlds) < 60:
        sys.exit(f"only {len(worlds)} worlds")
    sys.exit(f"{len(wrong)} wrong" if wrong else 0)


if __name__ == "__main__":
    main()
