"""What the tests share: worlds small enough to check by eye."""

import pathlib

import pytest

import taut

DATA = pathlib.Path(__file__).resolve().parents[2] / "data"

ROOM = "boundary 0 0 4 4\nstart 1 1\ngoal 3 1\n2 0 2 3\n"  # over the wall's end: 2 sqrt(1 + 4)
SEALED = "boundary 0 0 4 4\nstart 1 1\ngoal 3 1\n2 0 2 4\n"


@pytest.fixture(scope="session")
def data_folder():
    return DATA


@pytest.fixture
def room():
    return taut.read_world(ROOM)


@pytest.fixture
def sealed():
    return taut.read_world(SEALED)


@pytest.fixture(scope="session")
def maze():
    """45 x 45 cells, its ends known."""
    return taut.read_world_file(DATA / "maze_45x45.txt")


@pytest.fixture(scope="session")
def small_maze():
    return taut.read_world_file(DATA / "maze_25x25.txt")
