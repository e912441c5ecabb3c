"""Gates, passages, discs, and ways in the middle."""

import math

import numpy as np
import pytest

import taut

# Two rooms, and a door 1 wide between (4, 2) and (4, 3).
DOOR = "boundary 0 0 8 5\nstart 2 2.5\ngoal 6 2.5\n0 0 8 0\n8 0 8 5\n8 5 0 5\n0 5 0 0\n4 0 4 2\n4 3 4 5\n"


@pytest.fixture
def world():
    return taut.read_world(DOOR)


@pytest.fixture
def space(world):
    return taut.FreeSpace(world)


def test_the_door_is_what_stops_a_larger_disc(space):
    gates = taut.Gates(space)
    passage = gates.passage()
    assert passage and passage.radius == 0.5 and passage.is_proven
    segments, widths = passage.gates
    assert sorted(segments.reshape(-1, 2).tolist()) == [[4, 2], [4, 3]] and widths.tolist() == [1]
    assert len(gates) == len(gates.segments) == len(gates.widths) and (np.diff(gates.widths) >= 0).all()


def test_a_disc_gets_through_its_own_width_and_not_a_bit_less(space):
    gates = taut.Gates(space)
    assert gates.passage(radius=0.5)
    none = gates.passage(radius=math.nextafter(0.5, 1))
    assert not none and none.is_proven and len(none.walls) > 0


def test_its_path_bends_around_the_posts(space):
    path = taut.disc_path(space, 0.4, (2, 1), (6, 1))
    low, high = path.length_bounds
    assert low <= path.length <= high and high - low < 1e-12 and path.verify() and path.radius == 0.4
    assert np.hypot(*(path.points - (4, 2)).T).min() == pytest.approx(0.4, abs=1e-4)
    assert len(path.sampled(1e-6)) > len(path.points)
    assert taut.disc_path(space, 0.6) is None
    with pytest.raises(taut.InputError, match="wall"):
        taut.disc_path(space, 0.4, (0.1, 1))


def test_one_index_knows_the_paths_of_all_radii(space):
    every = taut.AllRadii(space)
    for radius in 0.1, 0.4, 0.5, 0.1:
        path = every.path(radius, (2, 1), (6, 1))
        assert path.verify() and path.length == pytest.approx(taut.disc_path(space, radius, (2, 1), (6, 1)).length)
    assert every.path(0.6) is None
    with pytest.raises(taut.InputError, match="wall"):
        every.path(0.4, (0.1, 1))
    lengths = every.lengths([(2, 1, 6, 1, 0.4), (2, 1, 6, 1, 0.6), (0.1, 1, 6, 1, 0.4)])
    assert lengths[0] == every.path(0.4, (2, 1), (6, 1)).length and np.isnan(lengths[1:]).all()


def test_a_radius_gets_its_graph_when_it_is_asked_about_again(space):
    every = taut.AllRadii(space)
    first = every.path(0.3, (2, 1), (6, 1))
    every.lengths([(2, 1, 6, 1, 0.1), (2, 1, 6, 1, 0.2), (2, 1, 6, 1, 0.6)])
    assert every.graphs == 0
    assert every.path(0.3, (2, 1), (6, 1)).length == pytest.approx(first.length, rel=1e-12)
    assert every.graphs == 1 and every.path(0.3) and every.graphs == 1


def test_an_index_of_all_radii_can_be_kept(world, space):
    every = taut.AllRadii(space)
    kept = every.to_bytes()
    again = taut.AllRadii.from_bytes(kept, space)
    assert len(again) == len(every) > 0 and again.to_bytes() == kept
    with pytest.raises(taut.InputError, match="damaged"):
        taut.AllRadii.from_bytes(kept[:-1], space)


def test_what_is_no_disc_is_refused(world, space):
    with pytest.raises(taut.InputError):
        taut.disc_path(space, math.nan)
    with pytest.raises(taut.InputError):
        taut.Gates(space).passage(radius=0)
    with pytest.raises(ValueError, match="footprint"):
        taut.Gates(taut.FreeSpace(world, taut.Footprint.disc(0.1)))


def test_the_widest_way_goes_through_the_middle_of_the_door(world):
    way = taut.widest_path(world)
    assert way.clearance == 0.5 and (way.points[:, 1] == 2.5).all() and way.length == pytest.approx(4, rel=1e-13)
    assert way.points[0].tolist() == [2, 2.5] and way.points[-1].tolist() == [6, 2.5]
    assert taut.clear_path(world, 0.25).clearance >= 0.25
    assert taut.clear_path(world, 0.75) is None


def test_room_costs_length():
    # A short narrow door and a long wide one.
    walls = DOOR.replace("4 0 4 2\n4 3 4 5\n", "4 0 4 2\n4 2.6 4 3\n4 5 4 5\n")
    trade = taut.clearance_tradeoff(taut.read_world(walls))
    assert len(trade) >= 2
    assert all(a.length <= b.length and a.clearance < b.clearance for a, b in zip(trade, trade[1:]))


def test_every_radius_at_which_the_way_of_a_disc_changes(data_folder):
    space = taut.FreeSpace(taut.read_world_file(data_folder / "three_ways.txt"))
    stretches = taut.tradeoff(space)
    assert [s.radii[1] for s in stretches][0::3] == [0.2, 1]
    assert stretches[0].then == "closed: 2/5 between (10, 5.8) and (10, 6.2)"
    for one, following in zip(stretches, stretches[1:]):
        assert one.radii[1] < following.radii[0] and one.lengths[1] <= following.lengths[0] + 1e-9
    middle = sum(stretches[2].radii) / 2
    assert stretches[2].length(middle) == pytest.approx(taut.disc_path(space, middle).length, rel=1e-12)
    assert stretches[2].points(middle)[-1].tolist() == [19, 6]
    with pytest.raises(ValueError):
        stretches[0].length(0.5)


def test_a_sealed_room_has_no_way_at_any_width(sealed):
    assert taut.widest_path(sealed) is None
    passage = taut.Gates(taut.FreeSpace(sealed)).passage()
    assert not passage and passage.radius is None


def test_matrices_are_single_queries(maze):
    finder = taut.Polyanya(taut.FreeSpace(maze))
    starts, goals = np.random.default_rng(3).uniform(1, 45, (2, 7, 2))
    lengths = finder.distances(starts, goals)
    assert lengths.shape == (7, 7)
    np.testing.assert_array_equal(lengths, finder.distances(starts, goals, threads=1))
    for i, j in np.ndindex(7, 7):
        assert lengths[i, j] == finder.find(starts[i], goals[j]).length
    np.testing.assert_array_equal(finder.distances(starts).diagonal(), 0)
    assert finder.distances([], goals).shape == (0, 7)


def test_a_matrix_says_what_is_not_reached(sealed):
    lengths = taut.Polyanya(taut.FreeSpace(sealed)).distances([(1, 1), (9, 9)], [(1, 2), (3, 1), (9, 9)])
    assert lengths[0, 0] == 1 and np.isinf(lengths[0, 1]) and np.isnan(lengths[0, 2]) and np.isnan(lengths[1]).all()


def test_what_nearly_touches_is_seen_and_joined():
    world = taut.World([[0, 0, 4, 1], [4, 1.000001, 3, 4]], snap=0)
    ends, walls, distances = taut.near_contacts(world)
    assert len(ends) == len(walls) == 1 and distances[0] == pytest.approx(1e-6)
    joined, report = taut.snapped(world, 1e-5)
    assert report["joined"] == 1 and report["remaining"] == 0 and report["displacement"] <= 1e-5
    assert len(taut.near_contacts(joined)[0]) == 0


def test_notebooks_show_them(world, space):
    for shown in taut.disc_path(space, 0.4), taut.widest_path(world):
        assert "<svg" in shown._repr_svg_() and "length" in repr(shown)
