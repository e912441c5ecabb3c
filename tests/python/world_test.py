import gzip
import pickle

import numpy as np
import pytest

import taut

from conftest import ROOM


def test_a_world_of_text_is_that_of_its_file(tmp_path, room):
    for name, content in ("room.txt", ROOM.encode()), ("room.txt.gz", gzip.compress(ROOM.encode())):
        (tmp_path / name).write_bytes(content)
        world = taut.read_world_file(tmp_path / name)
        assert world.source == str(tmp_path / name)
        assert world.start == room.start == (1, 1) and world.goal == (3, 1)
        np.testing.assert_array_equal(world.walls, [[2, 0, 2, 3]])


def test_a_world_of_arrays_is_that_of_its_text(room):
    world = taut.World(
        np.array([[2, 0, 2, 3]]), areas=[[(0, 0), (4, 0), (4, 4), (0, 4)]], start=(1, 1), goal=np.array([3.0, 1.0])
    )
    assert world.write("segments") == room.write("segments")
    assert taut.World([[[2, 0], [2, 3]]]).walls.tolist() == [[2, 0, 2, 3]]


def test_thickness_is_one_for_all_or_one_a_wall():
    walls = [[0, 0, 1, 0], [0, 2, 1, 2]]
    assert taut.World(walls, thickness=0.5).thickness.tolist() == [0.5, 0.5]
    assert taut.World(walls, thickness=[0.5, 0.25]).thickness.tolist() == [0.5, 0.25]
    with pytest.raises(ValueError, match="one a wall"):
        taut.World(walls, thickness=[0.5])


def test_polygons_are_rings_or_rings_with_holes():
    ring = [(0, 0), (9, 0), (9, 9), (0, 9)]
    hole = np.array([(3, 3), (6, 3), (6, 6), (3, 6), (3, 3)], float)
    world = taut.World(areas=[[ring, hole]], boundary="walled", solids=[[(1, 1), (2, 1), (1, 2)]])
    outer, inner = world.areas[0]
    assert outer.shape == (4, 2) and inner.shape == (4, 2)
    assert world.boundary == "walled" and len(world.solids) == 1
    assert world.box == (0, 0, 9, 9)


def test_polygons_of_shapely_are_taken():
    geometry = pytest.importorskip("shapely.geometry")
    world = taut.World(solids=[geometry.box(2, 2, 4, 4)], start=geometry.Point(0, 3), goal=(6, 3))
    assert taut.shortest_path(world).exact_length == taut.Length([(0, 3), (2, 2), (4, 2), (6, 3)])


def test_a_room_is_a_goal(room):
    world = taut.World(room.walls, areas=room.areas[0:1], start=(1, 1), goal=[[3, 0, 4, 1]])
    assert world.goal.tolist() == [[3, 0, 4, 1]]
    assert taut.shortest_path(world).points[-1].tolist() == [3, 1]


@pytest.mark.parametrize("write", ["segments", "geojson"])
def test_what_is_written_reads_back(maze, write):
    again = taut.read_world(maze.write(write))
    assert {tuple(w) for w in again.walls} == {tuple(w) for w in maze.walls}


def test_wrong_input_names_file_line_and_culprit():
    with pytest.raises(taut.InputError, match="^a.txt:2: 'x' is not a number$") as caught:
        taut.read_world("0 0 1 1\n0 0 x 1\n", source="a.txt")
    assert isinstance(caught.value, ValueError)
    assert (caught.value.file, caught.value.line, caught.value.culprit) == ("a.txt", 2, "'x' is not a number")
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value) and again.line == 2


def test_wrong_input_without_a_file_names_the_line():
    with pytest.raises(taut.InputError) as caught:
        taut.read_world("0 0 1 1\n0 0 x 1\n")
    assert (caught.value.file, caught.value.line, caught.value.culprit) == (None, 2, "'x' is not a number")


def test_a_missing_file_is_named():
    with pytest.raises(taut.InputError) as caught:
        taut.read_world_file("no such: 12: file")
    assert (caught.value.file, caught.value.line) == ("no such: 12: file", None)


@pytest.mark.parametrize(
    "arguments",
    [
        {"walls": [[0, 0, 1, float("nan")]]},
        {"walls": [[0, 0, 1]]},
        {"walls": [[0, 0, 1, 1]], "thickness": -1},
        {"walls": "0 0 1 1"},
        {"solids": [[(0, 0), (1, 1)]]},
        {"walls": [[0, 0, 1, 1]], "boundary": "none"},
    ],
)
def test_wrong_arrays_are_value_errors(arguments):
    with pytest.raises(ValueError):
        taut.World(**arguments)


def test_options_that_do_not_exist_are_named():
    with pytest.raises(TypeError, match="polygon"):
        taut.read_world(ROOM, polygon="free")
    with pytest.raises(ValueError, match="dxf"):
        taut.read_world(ROOM, format="dxf")


def test_notes_take_what_reading_has_to_remark():
    notes = []
    taut.read_world("POINT (1 1)\nPOINT (2 2)\nPOINT (3 3)\nLINESTRING (0 0, 4 0, 4 4, 0 4, 0 0)", notes=notes)
    assert len(notes) == 1 and "points" in notes[0]


def test_snap_joins_what_was_meant_to_touch():
    walls = [[0, 0, 4, 0], [4, 0.001, 4, 4]]
    first, second = taut.World(walls, snap=0.01).walls
    assert first[2:].tolist() == second[:2].tolist()
    assert taut.World(walls, snap=0).walls.tolist() == walls
    with pytest.raises(ValueError, match="snap"):
        taut.World(walls, snap="all")
    for snap in (-1, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="snap"):
            taut.World(walls, snap=snap)


def test_a_notebook_shows_it(room):
    assert room._repr_svg_().startswith("<svg") or "<svg" in room._repr_svg_()[:200]
    assert "1 wall" in repr(room)
