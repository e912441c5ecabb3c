import math

import numpy as np
import pytest

import taut

POCKET = np.array([list(row) for row in (".....", ".###.", "...#.", ".###.", ".....")]) == "#"


def random_grid(seed, shape=(40, 60), density=0.3):
    blocked = np.random.default_rng(seed).random(shape) < density
    blocked[0, 0] = blocked[-1, -1] = False
    return blocked


def test_every_search_finds_a_way_out_of_the_pocket():
    grid = taut.Grid(POCKET)
    for algorithm in "bfs", "dfs", "dijkstra", "greedy", "astar", "weighted-astar", "bidirectional-astar", "idastar":
        answer = grid.find((2, 2), (2, 4), algorithm)
        assert answer and answer.path[0].tolist() == [2, 2] and answer.path[-1].tolist() == [2, 4]
        assert (np.abs(np.diff(answer.path.astype(int), axis=0)).sum(axis=1) == 1).all()
    assert grid.find((2, 2), (2, 4)).cost == 10 and grid.find((2, 2), (2, 4)).optimal


def test_costs_are_exact_sums():
    answer = taut.Grid(np.zeros((4, 6), bool), moves=8).find((0, 0), (3, 5), "jps")
    assert answer.moves == (2, 3) and answer.cost == pytest.approx(2 + 3 * math.sqrt(2))


@pytest.mark.parametrize("moves", [4, 8, "octile"])
def test_distances_and_first_moves_agree_with_searches(moves):
    blocked = random_grid(1)
    grid = taut.Grid(blocked, moves)
    goal = (20, 30)
    if blocked[goal]:
        blocked[goal] = False
        grid = taut.Grid(blocked, moves)
    length, move = grid.distances_to(goal)
    assert length.shape == move.shape == blocked.shape and length[goal] == 0 and move[goal] == -1
    assert np.isinf(length[blocked]).all() and (move[np.isinf(length)] == -1).all()
    for row, column in np.argwhere(np.isfinite(length))[::97]:
        assert grid.find((row, column), goal, "dijkstra").cost == length[row, column]
        cell, walked = (int(row), int(column)), 0
        while move[cell] >= 0:
            down, right = taut.GRID_MOVES[move[cell]]
            cell, walked = (cell[0] + down, cell[1] + right), walked + math.hypot(down, right)
        assert cell == goal and walked == pytest.approx(length[row, column])


def test_what_was_visited_is_recorded_on_request():
    grid = taut.Grid(POCKET)
    assert len(grid.find((2, 2), (2, 4)).visited) == 0
    answer = grid.find((2, 2), (2, 4), record=True)
    assert len(answer.visited) == answer.steps and "<svg" in answer._repr_svg_()


def test_no_way_is_an_answer():
    blocked = np.zeros((3, 3), bool)
    blocked[:, 1] = True
    answer = taut.Grid(blocked).find((0, 0), (0, 2))
    assert not answer and len(answer.path) == 0 and "none" in repr(answer)


@pytest.mark.parametrize(
    "ask, error",
    [
        (lambda g: g.find((1, 1), (0, 0)), taut.InputError),
        (lambda g: g.find((0, 0), (9, 9)), taut.InputError),
        (lambda g: g.find((0, 0), (2, 2), "jps"), taut.InputError),
        (lambda g: g.find((0, 0.5), (2, 2)), TypeError),
        (lambda g: g.find((0, -1), (2, 2)), TypeError),
        (lambda g: g.find((0, 0), (2, 2), "rrt"), ValueError),
        (lambda g: g.find((0, 0), (2, 2), heuristic="vague"), ValueError),
        (lambda g: g.find((0, 0), (2, 2), weight=0.5), ValueError),
        (lambda g: taut.Grid(np.zeros(3)), ValueError),
        (lambda g: taut.Grid(np.zeros((0, 3))), ValueError),
        (lambda g: taut.Grid(np.zeros((3, 3)), moves=6), ValueError),
    ],
)
def test_what_cannot_be_is_refused(ask, error):
    with pytest.raises(error):
        ask(taut.Grid(POCKET))


def test_a_grid_is_a_world_for_exact_paths():
    world = taut.occupancy_world(POCKET)
    path = taut.shortest_path(world, (2.5, 2.5), (4.5, 2.5))
    assert path.exact_length == taut.Length([(2.5, 2.5), (1, 2), (1, 1), (4, 1), (4.5, 2.5)]) and path.verify()
    assert path.length < taut.Grid(POCKET, "octile").find((2, 2), (2, 4)).cost


def test_a_map_of_ros_is_in_metres_with_y_up():
    world = taut.occupancy_world(POCKET, resolution=0.05, origin=(-1, 2))
    np.testing.assert_allclose(world.box, (-1, 2, -0.75, 2.25), atol=0)
    free = taut.FreeSpace(world)
    assert free.is_free((-0.9, 2.125)) and not free.is_free((-0.84, 2.125))  # the middle row: free, then the wall


def test_what_a_topic_publishes_is_taken_as_it_is():
    data = np.zeros((2, 3), np.int8)  # row 0 at the bottom
    data[0, 0], data[1, 2] = 100, -1
    space = taut.FreeSpace(taut.ros_world(data, resolution=1))
    assert not space.is_free((0.5, 0.5)) and space.is_free((1.5, 0.5)) and not space.is_free((2.5, 1.5))
    known = taut.FreeSpace(taut.ros_world(data, resolution=1, unknown_is_free=True))
    assert known.is_free((2.5, 1.5)) and not known.is_free((0.5, 0.5))
