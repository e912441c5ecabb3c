import math

import numpy as np
import pytest

import taut


def test_the_shortest_path_turns_around_the_walls_end(room):
    path = taut.shortest_path(room)
    assert path.points.tolist() == [[1, 1], [2, 3], [3, 1]]
    assert path.length == 2 * math.sqrt(5)
    assert path.decimals(20) == "4.47213595499957939282"
    for places in (-1, 10**6):
        with pytest.raises(ValueError):
            path.decimals(places)
        with pytest.raises(ValueError):
            path.exact_length.decimals(places)
    assert path.optimal and path.within == 0 and path.corners == 1 and path.clearance == 0 and len(path) == 3
    assert path.verify() and path.verify().reason == ""
    assert (path.start, path.goal) == ((1, 1), (3, 1))


def test_there_is_none_where_a_wall_separates_the_ends_and_it_is_named(sealed):
    assert taut.shortest_path(sealed) is None
    none = taut.no_path(taut.FreeSpace(sealed), (1, 1), (3, 1))
    assert [2, 0, 2, 4] in none.walls.tolist() or [2, 4, 2, 0] in none.walls.tolist()
    assert "<svg" in none._repr_svg_()


def test_nothing_says_so_where_there_is_a_path(room):
    assert taut.no_path(taut.FreeSpace(room), (1, 1), (3, 1)) is None


def test_other_ends_are_given_to_the_query(room):
    assert taut.shortest_path(room, (1, 3), (3, 3)).length == 2
    assert taut.shortest_path(taut.FreeSpace(room), start=(1, 3), goal=[3, 3]).length == 2


def test_an_end_outside_is_told_with_its_nearest_place(room):
    with pytest.raises(taut.InputError, match=r"start \(-1, 1\) lies 1 outside the world; nearest free point \(0, 1\)"):
        taut.shortest_path(room, (-1, 1))


@pytest.mark.parametrize("end", [(math.nan, 1), (math.inf, 1), (1e-80, 1), (1e80, 1)])
def test_what_is_no_point_is_refused(room, end):
    space = taut.FreeSpace(room)
    with pytest.raises(taut.InputError):
        taut.Polyanya(space).find(end, (1, 1))
    with pytest.raises(taut.InputError):
        taut.Polyanya(space).find_many([[1, 1, *end]])
    assert not space.is_free(end) and not space.sees((1, 1), end)


@pytest.mark.parametrize("end", [(1, 2, 3), "ab", None, 7])
def test_an_end_is_a_pair(room, end):
    with pytest.raises(TypeError):
        taut.Polyanya(taut.FreeSpace(room)).find(end, (1, 1))


def test_a_world_without_ends_asks_for_them():
    with pytest.raises(taut.InputError, match="start"):
        taut.shortest_path(taut.World([[0, 0, 4, 0]]))


def test_a_disc_keeps_away_from_walls(room):
    path = taut.shortest_path(room, footprint=taut.Footprint.disc(0.5))
    assert path.length > 2 * math.sqrt(5) and path.verify()
    narrow = taut.World([[2, 0, 2, 3], [0, 4, 4, 4]], areas=room.areas, start=room.start, goal=room.goal)
    assert taut.shortest_path(narrow, footprint=taut.Footprint.disc(0.49))
    assert taut.shortest_path(narrow, footprint=taut.Footprint.disc(0.51)) is None


def test_a_disc_between_its_polygons_is_unproven():
    # The gap is 2 wide: the disc of radius 1 fits, the polygon around it does not.
    area = [(0, 0), (4, 0), (4, 9), (0, 9)]
    world = taut.World([[2, 0, 2, 3], [2, 5, 2, 9]], areas=[area], start=(1, 4), goal=(3, 4))
    with pytest.raises(taut.Unproven, match="polygon around the disc"):
        taut.shortest_path(world, footprint=taut.Footprint.disc(1))


def test_lengths_compare_exactly():
    a = taut.Length([(0, 0), (1, 1), (3, 3)])
    b = taut.Length([(0, 0), (3, 3)])
    assert a == b and not a < b and a <= b and hash(a) == hash(b)
    assert taut.Length([(0, 0), (1, 3)]) < taut.Length([(0, 0), (1, 2), (1, 3)])
    assert float(a + b) == math.sqrt(72)


def test_a_path_of_ones_own_is_checked(room):
    space = taut.FreeSpace(room)
    assert taut.verify(space, [(1, 1), (2, 3), (3, 1)], room.start, room.goal)
    through = taut.verify(space, [(1, 1), (3, 1)])
    assert not through and "crosses the wall" in through.reason and through.leg == 0
    assert not taut.verify(space, [(1, 1), (2, 3)], room.start, room.goal)


def test_points_are_shown_without_a_copy_and_outlive_their_path(maze):
    path = taut.shortest_path(maze)
    points = path.points
    assert not points.flags.writeable and not points.flags.owndata
    assert np.shares_memory(points, path.points)
    length = path.length
    del path
    assert np.hypot(*np.diff(points, axis=0).T).sum() == pytest.approx(length)


def test_a_sloped_wall_keeps_the_end_that_lies_on_it():
    # (0.8, 1.1) lies on the wall from (0, 0.6) to (4, 3.1) as written, though no doubles do.
    world = taut.read_world("boundary 0 0 4 4\n0 0.6 4 3.1\n0.3 3.7 3.1 0.2\n")
    path = taut.shortest_path(world, (0.8, 1.1), (0.1, 0.1))
    assert path.points[0].tolist() == [0.8, 1.1]
    finder = taut.Polyanya(taut.FreeSpace(world))
    above = finder.find((0.8, 1.1), (0.1, 3.9))
    below = finder.find((0.8, 1.1), (0.1, 0.1))
    assert above.verify() and below.verify()
    assert len(above) == len(below) == 2  # straight off to both sides
    goals = [(0.1, 3.9), (0.1, 0.1)]
    assert finder.find_many([[0.8, 1.1, *goal] for goal in goals]).length.tolist() == [above.length, below.length]
    assert finder.distances([(0.8, 1.1)], goals).tolist() == [[above.length, below.length]]
    assert [path.length for path in finder.find_each((0.8, 1.1), goals)] == [above.length, below.length]
    assert finder.find_nearest((0.8, 1.1), goals)[1] == (0 if above.length < below.length else 1)


def test_a_notebook_shows_it(room):
    picture = taut.shortest_path(room)._repr_svg_()
    assert "<svg" in picture and "length 4.472136" in picture


@pytest.mark.parametrize("room", [[[3, 0, 4, math.nan]], [[4, 0, 3, 1]], [[0, 0, 1e80, 1]], [[1, 2, 3]]])
def test_a_goal_room_is_of_boxes(room):
    space = taut.FreeSpace(taut.read_world("boundary 0 0 4 4\nstart 1 1\ngoal 3 1\n2 0 2 3\n"))
    with pytest.raises(ValueError):
        taut.shortest_path(space, goal=room)


def test_lengths_are_of_points():
    for points in [(0, 0), (math.nan, 1)], [(0, 0), (math.inf, 1)], [(1, 2, 3)], "ab":
        with pytest.raises(ValueError):
            taut.Length(points)
