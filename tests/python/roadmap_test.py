
import numpy as np
import pytest

import taut


@pytest.fixture(scope="module")
def space(small_maze):
    return taut.FreeSpace(small_maze)


def hypot(points, edges):
    a, b = points[edges].transpose(1, 0, 2)
    return np.hypot(*(b - a).T)


KINDS = ["visibility", "full", "visibility-brute", "cells", "cells8", "prm", "prm-lattice", "prm-fixed", "voronoi"]


@pytest.mark.parametrize("kind", KINDS)
def test_arrays_of_every_kind_fit_each_other(space, kind):
    roadmap = taut.roadmap(space, kind)
    assert roadmap.kind == kind and set(KINDS) == set(taut.roadmap_kinds())
    points, edges, offsets, targets = roadmap.points, roadmap.edges, roadmap.offsets, roadmap.targets
    assert points.shape == (len(roadmap), 2) and offsets.shape == (len(roadmap) + 1,)
    assert (edges[:, 0] < edges[:, 1]).all() and len(targets) == 2 * len(edges) == offsets[-1]
    np.testing.assert_array_equal(roadmap.lengths, hypot(points, edges))
    rows = np.repeat(np.arange(len(roadmap)), np.diff(offsets))
    up = rows < targets
    np.testing.assert_array_equal(np.stack([rows[up], targets[up]], axis=1), edges)


def test_the_optimal_kinds_find_the_shortest_path(space):
    shortest = taut.shortest_path(space)
    for kind in "visibility", "full":
        path = taut.roadmap(space, kind).find()
        assert path.exact_length == shortest.exact_length and path.optimal and path.planner == kind
    cells = taut.roadmap(space, "cells").find(algorithm="dijkstra")
    assert cells.exact_length > shortest.exact_length and not cells.optimal and cells.verify()


def test_networkx_finds_what_the_roadmap_finds(space):
    networkx = pytest.importorskip("networkx")
    roadmap = taut.roadmap(space, "cells")
    graph = roadmap.to_networkx()
    assert graph.number_of_nodes() == len(roadmap) and graph.number_of_edges() == len(roadmap.edges)
    assert graph.nodes[0]["pos"] == tuple(roadmap.points[0])
    length, following = roadmap.distances_to(roadmap.points[0])
    theirs = networkx.single_source_dijkstra_path_length(graph, 0)
    assert len(theirs) == np.isfinite(length).sum()
    for vertex, theirs_length in theirs.items():
        assert length[vertex] == pytest.approx(theirs_length, abs=1e-9)


def test_following_next_leads_to_the_point(space):
    roadmap = taut.roadmap(space, "visibility")
    length, following = roadmap.distances_to(space.world.goal)
    vertex, way = int(np.argmax(np.where(np.isfinite(length), length, -1))), []
    while vertex >= 0:
        way.append(roadmap.points[vertex])
        vertex = following[vertex]
    way.append(space.world.goal)
    assert float(taut.Length(way)) == pytest.approx(length[np.isfinite(length)].max())
    assert taut.verify(space, way)


def test_a_prm_is_what_was_wished_and_its_seed_says_which(space):
    wishes = dict(seed=7, sampler="corners", connection="visible:5", clearance=0.01)
    first, again = (taut.roadmap(space, "prm", **wishes) for _ in range(2))
    np.testing.assert_array_equal(first.points, again.points)
    np.testing.assert_array_equal(first.edges, again.edges)
    assert len(taut.roadmap(space, "prm", **{**wishes, "seed": 8}).points) != len(first.points)
    assert first.find().verify()


def test_what_a_roadmap_does_not_find_proves_nothing(space):
    sparse = taut.roadmap(space, "prm-fixed", seed=1)
    with pytest.raises(taut.Unproven, match="prm-fixed"):
        sparse.find()


def test_walls_that_separate_prove_it_in_any_roadmap(sealed):
    assert taut.roadmap(taut.FreeSpace(sealed), "visibility").find() is None
    assert taut.roadmap(taut.FreeSpace(sealed), "prm-fixed").find() is None


@pytest.mark.parametrize(
    "arguments, error",
    [
        ({"kind": "rrt"}, ValueError),
        ({"kind": "polyanya"}, ValueError),
        ({"kind": "prm", "sampler": "halton"}, ValueError),
        ({"kind": "prm", "connection": "nearest"}, ValueError),
        ({"kind": "prm", "connection": "nearest:0"}, ValueError),
        ({"kind": "prm", "connection": "radius:-1"}, ValueError),
        ({"kind": "prm", "clearance": -1}, ValueError),
        ({"kind": "prm", "speed": 1}, TypeError),
        ({"kind": "prm", "samples": "many"}, TypeError),
        ({"kind": "prm", "seed": -1}, TypeError),
        ({"kind": "prm", "start": (-9, -9)}, taut.InputError),
    ],
)
def test_wishes_that_cannot_be_are_refused(space, arguments, error):
    with pytest.raises(error):
        taut.roadmap(space, **arguments)


@pytest.fixture
def slanted():
    return taut.FreeSpace(taut.read_world("boundary 0 0 4 4\nstart 1 1\ngoal 3 1\n2 0 2.1 3\n"))


def test_cells_need_a_grid(slanted):
    with pytest.raises(taut.InputError, match="no cells"):
        taut.roadmap(slanted, "cells")


def test_every_planner_by_name_beside_the_shortest(space):
    shortest = taut.shortest_path(space)
    for name in taut.planners():
        path = taut.plan(space, name)
        assert path.planner == name and path.verify() and path.exact_length >= shortest.exact_length
        assert not path.optimal or path.exact_length == shortest.exact_length


def test_a_comparison_is_a_table(space):
    table = taut.compare(space, ["visibility-astar", "prm"], runs=3, seed=5)
    runs = [(row["planner"], row["seed"]) for row in table]
    assert runs == [("visibility-astar", 5), ("prm", 5), ("prm", 6), ("prm", 7)]
    assert table[0]["ratio"] == 1 and all(row["solved"] and row["verified"] and row["ratio"] >= 1 for row in table)
    assert all(row["build_seconds"] >= 0 and row["vertices"] > 0 for row in table)


def test_a_planner_that_does_not_suit_the_world_says_why(slanted):
    row, = taut.compare(slanted, ["cells4"])
    assert not row["solved"] and "no cells" in row["unfit"] and row["length"] is None
    with pytest.raises(taut.InputError, match="no cells"):
        taut.plan(slanted, "cells4")


def test_a_notebook_shows_it(space):
    assert "<svg" in taut.roadmap(space, "cells")._repr_svg_()
    assert "edges" in repr(taut.roadmap(space, "cells"))
