"""Discs of any radius by one index, kept clearance, alternatives."""

import math

import numpy as np
import pytest

import taut

# Two rooms, and a door 1 wide between (4, 2) and (4, 3).
DOOR = "boundary 0 0 8 5\nstart 2 2.5\ngoal 6 2.5\n0 0 8 0\n8 0 8 5\n8 5 0 5\n0 5 0 0\n4 0 4 2\n4 3 4 5\n"


@pytest.fixture
def space():
    return taut.FreeSpace(taut.read_world(DOOR))


@pytest.fixture
def index(space):
    return taut.PassageIndex(space)


def test_one_index_answers_for_all_radii(index):
    assert index.widest() == 0.5 and index.widest((2, 0.25), (2, 4)) == 0.25
    assert index.passes(0.5) and not index.passes(math.nextafter(0.5, 1)) and not index.passes(1, (2, 0.5))
    radii = index.matrix([(2, 2.5), (6, 2.5), (6, 4)])
    assert radii.tolist() == [[2, 0.5, 0.5], [0.5, 2, 1], [0.5, 1, 1]]
    faces = index.map()
    assert all(ring.shape[1] == 2 for ring, _ in faces) and faces[0][1] == 2 and faces[-1][1] == 0.5
    assert len(index.gates) == len(taut.Gates(taut.FreeSpace(taut.read_world(DOOR))))
    with pytest.raises(taut.InputError):
        index.passes(0)
    with pytest.raises(ValueError, match="footprint"):
        taut.PassageIndex(taut.FreeSpace(taut.read_world(DOOR), taut.Footprint.disc(0.1)))


def test_what_a_disc_reaches_ends_at_the_door(index):
    reach = index.reach(0.75)
    assert (2, 4) in reach and (6, 2.5) not in reach and 0 < reach.area < reach.whole_area
    assert reach.widths.tolist() == [1] and reach.gates.shape == (1, 4)
    outer = reach.polygons[0][0]
    assert outer.min() >= 0.75 and len(reach.polygons) == 1
    assert (6, 2.5) in index.reach(0.5) and index.reach(0.75, (0.5, 2)) is None
    place, distance = index.nearest_place(0.75, (2, 0.25))
    assert place == (2, 0.75) and distance == 0.5


def test_clearance_is_kept_where_the_ends_allow(index):
    path = taut.kept_path(index, 0.4, (2, 0.1), (6, 2))
    assert [radius for radius, _ in path.parts] == [0.1, 0.4] and path.verify()
    low, high = path.length_bounds
    assert low <= path.length <= high and path.clearance == 0.4
    assert path.points[0].tolist() == [2, 0.1] and path.points[-1].tolist() == [6, 2]
    assert np.hypot(*np.diff(path.points, axis=0).T).sum() == pytest.approx(path.length, rel=1e-3)
    assert taut.kept_path(index, 0.75) is None
    assert "<svg" in path._repr_svg_() and "2 parts" in repr(path)


def test_alternatives_pass_a_bar_on_both_sides():
    world = taut.read_world("boundary 0 0 10 10\nstart 6 4\ngoal 6 6\n4 5 7 5\n0 0 10 0\n10 0 10 10\n10 10 0 10\n0 10 0 0\n")
    ways = taut.alternatives(taut.FreeSpace(world), 5)
    assert [way.width for way in ways] == [3, 4] and ways[0].length == pytest.approx(math.sqrt(8), rel=1e-15)
    assert ways[1].points.tolist() == [[6, 4], [4, 5], [6, 6]] and set(ways[0].gate) == {(7, 5), (10, 5)}
    assert "<svg" in ways[0]._repr_svg_() and "3 wide" in repr(ways[0])
    assert taut.alternatives(taut.FreeSpace(world), 1)[0].points.tolist() == ways[0].points.tolist()
