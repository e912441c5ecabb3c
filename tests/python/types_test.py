"""The stubs say what the module has, and mypy accepts a program that uses it rightly, and only such."""

import ast
import importlib.util
import inspect
import os
import pathlib
import re
import subprocess
import sys

import pytest

import taut

PACKAGE = pathlib.Path(taut.__file__).parent

USER = '''
import numpy as np
from numpy.typing import NDArray
import taut

world = taut.read_world_file("maze.txt", polygons="free", start=(1, 2))
space = taut.FreeSpace(world, taut.Footprint.disc(0.2), places=[(1, 2)])
path = taut.shortest_path(space, np.array([1.0, 2.0]), goal=(3, 4))
points: NDArray[np.float64] = path.points if path else np.empty((0, 2))
found = taut.Polyanya(space, landmarks=8).find((0, 0), (1, 1))
length: float = 0.0 if found is None else found.length
rows = taut.compare(space, ["prm"], runs=3, seed=1)
roadmap = taut.roadmap(space, "prm", samples=100, connection="nearest:8")
distances, following = roadmap.distances_to((1, 2))
cell = taut.Grid(np.zeros((3, 3), bool), moves="octile").find((0, 0), (2, 2)).path
error: ValueError = taut.InputError("wrong")
'''

WRONG = '''
import taut

path = taut.shortest_path(taut.World([[0, 0, 1, 1]]))
print(path.length)  # it may be None
taut.Polyanya("space")
taut.read_world("", polygon="free")
taut.Grid([[0]]).find((0, 0), (0, 0), algorythm="bfs")
'''


def mypy(arguments, cwd):
    folder = PACKAGE.parent
    cache = {"MYPYPATH": str(folder), "MYPY_CACHE_DIR": str(folder / "mypy"), "PYTHONPATH": str(folder)}
    command = [sys.executable, "-B", "-m", *arguments]
    return subprocess.run(command, env={**os.environ, **cache}, capture_output=True, text=True, cwd=cwd)


@pytest.mark.skipif(importlib.util.find_spec("mypy") is None, reason="no mypy")
def test_a_program_that_uses_it_rightly_is_accepted(tmp_path):
    (tmp_path / "user.py").write_text(USER)
    done = mypy(["mypy", "--strict", "user.py"], tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.skipif(importlib.util.find_spec("mypy") is None, reason="no mypy")
def test_one_that_does_not_is_refused(tmp_path):
    (tmp_path / "wrong.py").write_text(WRONG)
    done = mypy(["mypy", "--strict", "wrong.py"], tmp_path)
    lines = {int(line.split(":")[1]) for line in done.stdout.splitlines() if ": error:" in line}
    assert lines == {5, 6, 7, 8}, done.stdout + done.stderr


# ---- the stubs beside the module itself ------------------------------------------------------------------------------

STUB = ast.parse((PACKAGE / "_taut.pyi").read_text(encoding="utf-8"))
ONLY_TYPES = {"HasXY", "HasGeo", "Mouse", "Point", "PointLike", "GoalLike", "Polygon", "PolygonLike"}


def public(name):
    return not name.startswith("_")


def parameters(node):
    return [a.arg for a in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs) if a.arg != "self"]


def bound_parameters(thing):
    """As pybind11 writes them above the docstring; None where there are several, or free keywords."""
    line = thing.__doc__.splitlines()[0]
    if "**" in line or "*args" in line:
        return None
    inside = line[line.index("(") + 1 : line.rindex(") ->")]
    without_types = re.sub(r"\[[^\]]*\]|<[^>]*>|\([^()]*\)", "", inside)
    names = [part.split(":")[0].strip() for part in without_types.split(",")]
    return [name for name in names if name not in ("self", "*", "", "arg0") and name.isidentifier()]


def functions():
    for node in STUB.body:
        if isinstance(node, ast.FunctionDef):
            yield node, getattr(taut._taut, node.name)
        elif isinstance(node, ast.ClassDef) and node.name not in ONLY_TYPES:
            for member in node.body:
                if isinstance(member, ast.FunctionDef) and public(member.name) and not member.decorator_list:
                    yield member, getattr(getattr(taut._taut, node.name), member.name)


def test_the_stubs_name_what_the_module_has():
    nodes = {node.name: node for node in STUB.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    assert set(nodes) - ONLY_TYPES | {"GRID_MOVES"} == {name for name in vars(taut._taut) if public(name)}
    for name, node in nodes.items():
        if isinstance(node, ast.ClassDef) and name not in ONLY_TYPES:
            members = {member.name for member in node.body if isinstance(member, ast.FunctionDef)}
            bound = {member for member in dir(getattr(taut._taut, name)) if public(member)}
            assert {member for member in members if public(member)} == bound, name


def test_the_stubs_name_the_parameters_that_there_are():
    compared = 0
    for node, thing in functions():
        bound = bound_parameters(thing) if inspect.isroutine(thing) and "->" in (thing.__doc__ or "") else None
        if bound is not None:
            assert parameters(node) == bound, node.name
            compared += 1
    assert compared > 40


def test_the_package_exports_all_of_it():
    assert {name for name in vars(taut._taut) if public(name)} <= set(taut.__all__)
    assert all(hasattr(taut, name) for name in taut.__all__)
