"""An index: the answers of Polyanya, kept in a file and loaded."""

import numpy as np
import pytest

import taut


@pytest.fixture(scope="module")
def space(maze):
    return taut.FreeSpace(maze)


@pytest.fixture(scope="module")
def index(space):
    return taut.Index(space)


def test_answers_are_those_of_polyanya(space, index):
    finder = taut.Polyanya(space)
    queries = np.random.default_rng(3).uniform(0.5, 45.5, (300, 4))
    queries[0] = [1, 1, 300, 1]
    expected, answers = finder.find_many(queries), index.find_many(queries, paths=True)
    np.testing.assert_array_equal(answers.status, expected.status)
    np.testing.assert_array_equal(answers.length, expected.length)
    assert len(answers.path(0)) == 0
    for i in (1, 2, 3):
        path = index.find(queries[i, :2], queries[i, 2:])
        assert path.length == answers.length[i]
        np.testing.assert_array_equal(path.points, answers.path(i))


def test_says_how_large_it_is(index):
    assert index.bends > 100
    assert 1000 < index.nbytes < 10_000_000
    with pytest.raises(taut.InputError):
        taut.Index(index.space, memory=1000)


def test_is_kept_in_a_file(space, index, tmp_path):
    path = str(tmp_path / "maze.index")
    index.save(path)
    loaded = taut.Index.load(path, space)
    queries = np.random.default_rng(4).uniform(0.5, 45.5, (50, 4))
    np.testing.assert_array_equal(loaded.find_many(queries).length, index.find_many(queries).length)
    with open(path, "r+b") as file:
        file.seek(2000)
        file.write(b"damage")
    with pytest.raises(taut.InputError, match="is damaged"):
        taut.Index.load(path, space)


def test_refuses_places_that_are_not_free(index):
    with pytest.raises(taut.InputError):
        index.find((1, 1), (300, 1))
