"""The examples run and print what they promise."""

import pathlib
import re
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]

EXAMPLES = {
    "prm_homework.py": ([], r"\d+ milestones, \d+ edges\nlength [\d.]+, 1\.\d+ times the shortest"),
    "comparison.py": ([], r"planner,solved,ratio(.|\n)*polyanya,1/1,1\.0,(.|\n)*prm,5/5,1\.\d+"),
    "ros_map.py": ([], r"radius 0\.2 m\na robot of 15 cm drives [\d.]+ m"),
    "learning_labels.py": (["300"], r"90000 states, \d+ reach the goal, labels in"),
    "micromouse.py": ([], r"<taut.MouseRun Flooder: score [\d.]+(.|\n)*MouseRun score: score"),
}


def test_every_example_is_tested():
    assert {p.name for p in (ROOT / "python/examples").glob("*.py")} == set(EXAMPLES)


@pytest.mark.parametrize("name", EXAMPLES)
def test_it_runs(name):
    arguments, printed = EXAMPLES[name]
    script = [sys.executable, "-B", "-W", "error", ROOT / "python/examples" / name, *arguments]
    done = subprocess.run(script, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert re.search(printed, done.stdout), done.stdout
