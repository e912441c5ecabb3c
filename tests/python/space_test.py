import math

import numpy as np
import pytest

import taut


@pytest.fixture
def space(room):
    return taut.FreeSpace(room)


def test_polygons_are_what_is_left_for_the_robot(room):
    (outer, *holes), = taut.FreeSpace(room, taut.Footprint.square(0.5)).polygons
    x, y = outer.T
    area = abs(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1))) / 2
    assert area == 16 - 1 * 3.5 and not holes  # what stands in its way of a wall is 1 wide, 3.5 high


def test_the_triangulation_covers_it_without_a_copy(space):
    points, triangles, free = space.triangulation
    a, b, c = points[triangles[free == 1]].transpose(1, 0, 2)
    areas = np.cross(b - a, c - a) / 2
    assert (areas > 0).all() and areas.sum() == 16
    assert not points.flags.owndata and not triangles.flags.writeable


def test_arrays_keep_their_space_alive(room):
    points, triangles, free = taut.FreeSpace(room).triangulation
    assert points.sum() == np.array(points).sum() and triangles.max() < len(points)


def test_questions_about_places(space):
    assert space.is_free((1, 1)) and space.is_free((2, 1)) and not space.is_free((5, 1))
    assert space.sees((1, 1), (1, 3)) and not space.sees((1, 1), (3, 1))
    assert space.clearance((1.5, 1)) == 0.5
    assert space.clearances([(1.5, 1), (9, 9), (math.nan, 0)]).tolist() == [0.5, -1, -1]
    assert space.nearest_free((5, 1)) == (4, 1) and space.nearest_free((1, 1)) == (1, 1)
    assert space.component_count == 1
    with pytest.raises(taut.InputError, match="outside the world"):
        space.clearance((5, 1))


def test_the_visibility_polygon_ends_behind_the_wall(space):
    ring = space.visibility_polygon((1, 1))
    x, y = ring.T
    area = abs(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1))) / 2
    assert area == 8 + 0.25  # the left half, and above the wall's end a triangle 0.5 wide, 1 high
    assert {(2, 3), (2.5, 4)} <= {tuple(p) for p in ring}


def test_walls_separate(sealed):
    space = taut.FreeSpace(sealed)
    assert space.component_count == 2
    assert len(space.separation((1, 1), (3, 1))) > 0
    assert space.separation((1, 1), (1, 2)).shape == (0, 4)


@pytest.mark.parametrize("make", [lambda: taut.Footprint.disc(0), lambda: taut.Footprint.square(-1),
                                  lambda: taut.Footprint.disc(math.nan),
                                  lambda: taut.Footprint.polygon([(-1, -1), (1, -1), (0, math.nan)]),
                                  lambda: taut.Footprint.polygon([]),
                                  lambda: taut.Footprint.polygon([(1, 0), (2, 0), (2, 1)])])
def test_robots_that_are_none_are_refused(make):
    with pytest.raises(taut.InputError):
        make()


def test_what_prints_says_what_it_is(space):
    assert repr(space).startswith("<taut.FreeSpace of a point: 1 polygon")
    assert repr(taut.Footprint.disc(0.5)) == "<taut.Footprint disc of radius 0.5>"
