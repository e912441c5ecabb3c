import numpy as np
import pytest

import taut


@pytest.fixture(scope="module")
def mouse_maze(data_folder):
    return taut.read_world_file(data_folder / "mouse_16.maz")


class LeftHand:
    """Along the left wall; resets in the goal room."""

    def __init__(self, maze_dim):
        self.goal = {(x, y) for x in (maze_dim // 2 - 1, maze_dim // 2) for y in (maze_dim // 2 - 1, maze_dim // 2)}
        self.at, self.heading, self.been = (0, 0), 0, False

    def next_move(self, sensors):
        left, front, right = sensors
        if self.at in self.goal and not self.been:
            self.at, self.heading, self.been = (0, 0), 0, True
            return "Reset", "Reset"
        rotation, movement = (-90, 1) if left else (0, 1) if front else (90, 1) if right else (90, 0)
        self.heading = (self.heading + rotation) % 360
        dx, dy = {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}[self.heading]
        self.at = self.at[0] + movement * dx, self.at[1] + movement * dy
        return rotation, movement


class Still:
    def next_move(self, sensors):
        return 45, 9


ROOMS = "o---o---o\n| G     |\no   o   o\n| S |   |\no---o---o\n"


def test_robots_of_taut_run_by_name(mouse_maze):
    runs = {name: taut.run_mouse(mouse_maze, name) for name in ("flood", "prove", "score")}
    assert all(run.finished and run.score == run.run2 + run.run1 / 30 for run in runs.values())
    assert runs["prove"].run2 <= runs["flood"].run2
    assert set(runs) <= set(taut.mouse_explorers())


def test_a_robot_written_in_python_runs_the_trial():
    maze = taut.read_world(ROOMS)

    class Up:
        def next_move(self, sensors):
            assert len(sensors) == 3
            self.moves = getattr(self, "moves", 0) + 1
            return (0, 1) if self.moves != 2 else "reset"

    run = taut.run_mouse(maze, Up())
    assert run.finished and (run.run1, run.run2) == (2, 1) and run.score == 1 + 2 / 30
    assert run.steps.tolist() == [
        [1, 0, 0, 0, 0, 1, 0, 0, 1, 0],
        [1, 0, 1, 0, 0, 0, 1, 0, 0, 1],
        [2, 0, 0, 0, 0, 1, 0, 0, 1, 0],
    ]
    assert "<svg" in run._repr_svg_() and "Up" in repr(run)


def test_a_class_is_made_from_the_mazes_width():
    assert taut.run_mouse(taut.read_world(ROOMS), LeftHand).steps[:, 7].tolist()[0] == 0


def test_what_the_rules_do_not_know_is_named_and_the_steps_run_out():
    run = taut.run_mouse(taut.read_world(ROOMS), Still(), max_steps=5)
    assert not run.finished and run.score is None and len(run.steps) == 5 and len(run.offences) == 5


def test_what_a_robot_raises_comes_through():
    class Broken:
        def next_move(self, sensors):
            raise ZeroDivisionError("lost")

    class Dumb:
        def next_move(self, sensors):
            return None

    with pytest.raises(ZeroDivisionError, match="lost"):
        taut.run_mouse(taut.read_world(ROOMS), Broken())
    with pytest.raises(TypeError, match="next_move"):
        taut.run_mouse(taut.read_world(ROOMS), Dumb())
    with pytest.raises(AttributeError):
        taut.run_mouse(taut.read_world(ROOMS), object())


def test_a_world_without_cells_is_no_maze(room):
    with pytest.raises(taut.InputError, match="cells"):
        taut.run_mouse(room, "prove")


# ---- a chase ---------------------------------------------------------------------------------------------------------

CHASE = "N\n5,3\nC\n100\nR\n1,1\nT\n5,3\n4,3\n3,3\n2,3\n1,3\n1,3\nM\n" + "\n".join(["1,1,1"] * 5) + "\n"


def test_the_exact_planner_catches_at_least_cost(data_folder):
    chase = taut.chase(taut.read_chase_map_file(data_folder / "town_60x40.chase"))
    assert chase and chase.caught and chase.optimal and chase.end == "caught"
    cheaper = taut.chase(taut.read_chase_map_file(data_folder / "town_60x40.chase"), "first")
    assert cheaper.cost >= chase.cost
    assert (np.diff(chase.track[:, 2]) == 1).all() and "<svg" in chase._repr_svg_()


def test_a_pursuer_written_in_python():
    chart = taut.read_chase_map(CHASE)
    assert chart.costs.shape == (5, 3) and chart.start == (1, 1) and chart.target[0].tolist() == [5, 3]

    def towards(cell, second):
        x, y = chart.target[min(second + 1, len(chart.target) - 1)]
        return cell[0] + np.sign(x - cell[0]), cell[1] + np.sign(y - cell[1])

    run = taut.chase(chart, towards)
    assert run.caught and run.cost >= taut.chase(chart).cost
    assert taut.chase(chart, lambda cell, second: None).end == "gave up"
    assert taut.chase(chart, lambda cell, second: cell).caught is False
    far = taut.chase(chart, lambda cell, second: (9, 9))
    assert far.end == "illegal" and far.reason
    with pytest.raises(TypeError):
        taut.chase(None)
    with pytest.raises(TypeError, match="next cell"):
        taut.chase(chart, lambda cell, second: "north")


def test_a_broken_map_names_its_line():
    with pytest.raises(taut.InputError) as caught:
        taut.read_chase_map(CHASE.replace("R\n1,1", "R\n9,1"), source="town.chase")
    assert caught.value.file == "town.chase"


# ---- a meeting -------------------------------------------------------------------------------------------------------


@pytest.fixture
def hall():
    return taut.FreeSpace(taut.read_world("boundary 0 0 10 10\nstart 1 0\n5 0 5 4\n"))


def test_the_earliest_meeting_is_around_the_wall(hall):
    meeting = taut.earliest_meeting(hall, [(0, 9, 0), (1, 9, 0)], stays=True)
    assert meeting.time == pytest.approx(2 * np.sqrt(32)) == meeting.length and meeting.verify()
    low, high = meeting.time_bounds
    assert low <= high == meeting.time and np.nextafter(low, 99) >= high
    assert meeting.points.tolist() == [[1, 0], [5, 4], [9, 0]] and meeting.at == (9, 0)
    assert "<svg" in meeting._repr_svg_() and "Meeting after 11.31" in repr(meeting)


def test_a_slow_robot_waits_where_the_target_comes_by(hall):
    meeting = taut.earliest_meeting(hall, np.array([(10, 4, 4), (12, 9, 4)]), (1, 0), speed=1)
    assert (meeting.time, meeting.at, meeting.leg, meeting.waits) == (10, (4, 4), 0, 5)


def test_a_target_that_is_gone_before_is_met_by_nobody(hall):
    assert taut.earliest_meeting(hall, [(0, 9, 0), (11, 9, 0)]) is None
    assert taut.earliest_meeting(hall, [(0, 9, 0), (11, 9, 0)], speed=2).time == pytest.approx(np.sqrt(32))


def test_ways_that_cannot_be_walked_are_refused(hall, room):
    for rows, words in (
        ([(0, 1, 2), (4, 9, 2)], "from row 0 to row 1"),
        ([(0, 1, 2), (2, 11, 2)], "from row 0 to row 1"),
        ([(0, 11, 2)], "row 0 the target is in a wall, or outside"),
        ([(0, 1, 2), (0, 1, 3)], "times do not ascend"),
        ([(0, 1, np.nan)], "a time and a point"),
        (np.empty((0, 3)), "no rows"),
    ):
        with pytest.raises(taut.InputError, match=words):
            taut.earliest_meeting(hall, rows)
    with pytest.raises(taut.InputError, match="start"):
        taut.earliest_meeting(hall, [(0, 1, 2)], (11, 1))
    for speed in 0, -1, np.nan:
        with pytest.raises(ValueError, match="speed"):
            taut.earliest_meeting(hall, [(0, 1, 2)], speed=speed)
    with pytest.raises(ValueError):
        taut.earliest_meeting(hall, [(0, 1)])


# ---- a bug, a drive --------------------------------------------------------------------------------------------------


def test_bugs_keep_their_bounds(data_folder):
    world = taut.read_world_file(data_folder / "islands.wkt")
    space = taut.FreeSpace(world)
    shortest = taut.shortest_path(space).length
    for algorithm in "bug1", "bug2", "tangent":
        journey = taut.bug(space, algorithm)
        assert journey.reached and shortest <= journey.length <= journey.bound
        assert taut.verify(space, journey.points, world.start, world.goal)
        assert "<svg" in journey._repr_svg_()
    assert len(taut.bug(space, "bug1").hits) >= 1


def test_a_bug_proves_that_there_is_no_way(sealed):
    journey = taut.bug(taut.FreeSpace(sealed), "bug1")
    assert not journey and "no path" in repr(journey)
    with pytest.raises(ValueError):
        taut.bug(taut.FreeSpace(sealed), "bug3")


def test_a_car_parks(data_folder):
    world = taut.read_world("boundary 0 0 8 5\nstart 1 1\ngoal 7 4\n4 0 4 2.5\n")
    car = taut.Car(length=0.8, width=0.4, radius=0.6, rear=0.2)
    drive = taut.drive(taut.FreeSpace(world), car, heading=0, goal_heading=90)
    assert drive.verify() and drive.lower_bound <= drive.length
    poses = drive.poses(0.1)
    assert poses[0, :3].tolist() == [1, 1, 0] and poses[-1, :2].tolist() == [7, 4]
    assert poses[-1, 2] % 360 == pytest.approx(90)
    assert np.hypot(*np.diff(poses[:, :2], axis=0).T).sum() == pytest.approx(drive.length, rel=1e-2)
    assert "<svg" in drive._repr_svg_() and "leg" in repr(drive)


def test_a_car_too_wide_has_no_drive_and_that_is_proven():
    world = taut.read_world("boundary 0 0 8 5\nstart 1 2\ngoal 7 2\n4 0 4 2.4\n4 2.6 4 5\n")
    assert taut.drive(taut.FreeSpace(world), taut.Car(0.8, 0.4, 0.6, 0.2)) is None
    with pytest.raises(taut.InputError):
        taut.Car(-1, 1, 1)
