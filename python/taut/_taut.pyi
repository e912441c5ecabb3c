"""The module behind the package, as it is bound in python/*.cpp."""

import os
from typing import Any, Callable, Iterable, Protocol, Sequence, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

class HasXY(Protocol):
    @property
    def x(self) -> float: ...
    @property
    def y(self) -> float: ...

class HasGeo(Protocol):
    @property
    def __geo_interface__(self) -> Any: ...

Point = tuple[float, float]
PointLike = Union[tuple[float, float], Sequence[float], NDArray[Any], HasXY]
GoalLike = Union[PointLike, ArrayLike]
Polygon = tuple[NDArray[np.float64], ...]
PolygonLike = Union[ArrayLike, Sequence[ArrayLike], HasGeo]

class Mouse(Protocol):
    def next_move(self, sensors: tuple[int, int, int], /) -> Any: ...

__version__: str
GRID_MOVES: tuple[tuple[int, int], ...]

class Alternative:
    """The shortest path of one way around the obstacles."""

    @property
    def length(self) -> float:
        """The double nearest to the exact one."""
    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 2): the ends, and the corners that it bends around."""
    @property
    def width(self) -> float | None:
        """Of the narrowest gate that all paths of this way pass: no larger disc gets along. None: it passes none."""
    @property
    def gate(self) -> tuple[Point, Point] | None:
        """That gate's two ends."""
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...

class Answers:
    """Answers to many queries, in their order."""

    @property
    def status(self) -> NDArray[np.uint8]:
        """(n,) uint8: 0 found, 1 none (proven), 2 an end is not free, 3 unproven."""
    @property
    def length(self) -> NDArray[np.float64]:
        """(n,): to the nearest double; inf where there is no path, nan where that or the ends are in doubt."""
    @property
    def offsets(self) -> NDArray[np.int64]:
        """(n + 1,): of path i the points offsets[i] to offsets[i + 1]; empty without paths."""
    @property
    def points(self) -> NDArray[np.float64]:
        """(m, 2): of all paths, one after the other."""
    def __len__(self) -> int: ...
    def path(self, i: int) -> NDArray[np.float64]:
        """(k, 2): the points of path i; none where there is no path."""

class AllRadii:
    """Paths of discs of any radius, from one index: what is the same for all radii is found once. A radius
    asked about twice gets a graph; the last 16 are kept. Of a point's space."""

    def __init__(self, space: FreeSpace) -> None: ...
    def path(
        self, radius: float, start: PointLike | None = ..., goal: GoalLike | None = ...
    ) -> ArcPath | None:
        """As disc_path: the first query of a radius in about a millisecond, without a graph of that radius; from the
        third one on in microseconds."""
    def lengths(self, queries: ArrayLike) -> NDArray[np.float64]:
        """(n,) of (n, 5) rows sx, sy, gx, gy, radius: the shortest paths' lengths; nan where there is none, or an end
        is no place for the disc."""
    @property
    def graphs(self) -> int:
        """How many graphs of a radius were made: none for the first query of a radius."""
    def to_bytes(self) -> bytes:
        """To be kept; a mark of the world goes along."""
    @staticmethod
    def from_bytes(bytes: bytes, space: FreeSpace) -> AllRadii:
        """What to_bytes gave, for a space of the same world. Raises InputError when it is of another, or damaged."""
    def __len__(self) -> int:
        """Straight legs that are or may be free for some radius."""

class ArcPath:
    """The path of a disc's centre: straight legs, and arcs around corners."""

    @property
    def length(self) -> float: ...
    @property
    def length_bounds(self) -> tuple[float, float]:
        """Two doubles around the exact length."""
    @property
    def radius(self) -> float: ...
    @property
    def within(self) -> float: ...
    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 2): on the path, legs between them no farther from it than radius / 1000."""
    def sampled(self, tolerance: float) -> NDArray[np.float64]:
        """(n, 2): on the path, legs between them no farther from it than that."""
    def verify(self) -> bool:
        """A check that shares nothing with the planner: True when it can be followed."""
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...
    @property
    def __geo_interface__(self) -> dict[str, Any]: ...

class Audit:
    """What there is to say of anybody's path."""

    @property
    def valid(self) -> bool: ...
    @property
    def reason(self) -> str:
        """Empty when valid."""
    @property
    def leg(self) -> int | None:
        """The first that meets a wall, from 0; None where none does."""
    @property
    def at(self) -> Point | None:
        """Where the robot's reference point is then."""
    @property
    def on(self) -> Point | None:
        """The wall's point."""
    @property
    def wall(self) -> str | None:
        """The wall in words, with its line in the file."""
    @property
    def clearance(self) -> float:
        """The least distance between robot and walls; inf without walls, 0 when not valid."""
    @property
    def length(self) -> float: ...
    @property
    def exact_length(self) -> Length: ...
    @property
    def shortest(self) -> float | None:
        """The length of the shortest path between its ends; None without one."""
    @property
    def gap(self) -> float | None:
        """How much longer it is than that."""
    def __bool__(self) -> bool: ...
    def __repr__(self) -> str: ...

class Car:
    """A rectangular car; its reference point is the middle of the rear axle."""

    def __init__(self, length: float, width: float, radius: float, rear: float = ..., reverse: bool = ...) -> None:
        """radius: the least turning radius. rear: from the rear end to the rear axle. Raises InputError."""
    @property
    def front(self) -> float: ...
    @property
    def back(self) -> float: ...
    @property
    def half_width(self) -> float: ...
    @property
    def radius(self) -> float: ...
    @property
    def reverse(self) -> bool: ...

class ChaseMap:
    """A cost map, a robot's start, a target's trajectory."""

    @property
    def costs(self) -> NDArray[np.float64]:
        """(x, y): of cell (1, 1) at [0, 0]; inf in obstacles."""
    @property
    def target(self) -> NDArray[np.int32]:
        """(n, 2): x, y, one a second."""
    @property
    def start(self) -> tuple[int, int]: ...

class ChaseRun:
    """How a chase went."""

    @property
    def caught(self) -> bool: ...
    @property
    def end(self) -> str:
        """'caught', 'escaped', 'gave up', 'illegal'."""
    @property
    def reason(self) -> str: ...
    @property
    def cost(self) -> float: ...
    @property
    def seconds(self) -> int:
        """That passed."""
    @property
    def moves(self) -> int:
        """Waiting is none."""
    @property
    def optimal(self) -> bool:
        """Nobody catches it for less, proven."""
    @property
    def track(self) -> NDArray[np.int32]:
        """(n, 3) int32: x, y, second."""
    def __bool__(self) -> bool: ...
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...

class ClearPath:
    """A path in the middle between walls, along the Voronoi diagram."""

    @property
    def length(self) -> float:
        """To about 1e-13 of itself."""
    @property
    def clearance(self) -> float:
        """The least distance to a wall."""
    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 2): legs between them are no farther from it than 1/10 000 of a corridor."""
    @property
    def narrowest(self) -> str:
        """Where that is, in words."""
    @property
    def start(self) -> Point: ...
    @property
    def goal(self) -> Point: ...
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...
    @property
    def __geo_interface__(self) -> dict[str, Any]: ...

class Collision:
    """Two robots that are nearer than the sum of their radii."""

    @property
    def robots(self) -> tuple[int, int]:
        """By number."""
    @property
    def legs(self) -> tuple[int, int]: ...
    @property
    def times(self) -> tuple[float, float]:
        """From, to."""
    @property
    def at(self) -> tuple[Point, Point]:
        """Their centres when it begins."""
    def __repr__(self) -> str: ...

class DiscReach:
    """Where a disc's centre gets to from one place."""

    @property
    def polygons(self) -> list[Polygon]:
        """Each the outer ring, then holes, (n, 2). Arcs are drawn by a 64-gon around the disc, so a rim of 0.121 % of
        the radius is left out; which are reached is exact."""
    @property
    def area(self) -> float: ...
    @property
    def whole_area(self) -> float:
        """Of all places, reached or not."""
    @property
    def gates(self) -> NDArray[np.float64]:
        """(n, 4): too narrow, between what is reached and what is not, the widest first."""
    @property
    def widths(self) -> NDArray[np.float64]:
        """(n,): theirs."""
    def __contains__(self, point: PointLike) -> bool:
        """Does the centre get there? Exactly."""
    def __repr__(self) -> str: ...

class Drive:
    """A drive of a car: exact legs, straight ones and arcs."""

    @property
    def length(self) -> float: ...
    @property
    def lower_bound(self) -> float:
        """No car of this size drives less."""
    @property
    def legs(self) -> int: ...
    @property
    def reversals(self) -> int: ...
    def poses(self, step: float) -> NDArray[np.float64]:
        """(n, 4): x, y, heading in degrees, 1 where it goes back; no farther apart than step."""
    def verify(self) -> bool:
        """A check that shares nothing with the planner but the legs: True when the car meets no wall."""
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...

class Footprint:
    """What moves: the shape of the robot around its reference point."""

    @staticmethod
    def point() -> Footprint: ...
    @staticmethod
    def disc(radius: float) -> Footprint:
        """A disc around its centre; taken for the polygon with 64 sides around it."""
    @staticmethod
    def square(half_side: float) -> Footprint:
        """An axis-parallel square, its reference point in the middle."""
    @staticmethod
    def polygon(ring: ArrayLike) -> Footprint:
        """A convex counter-clockwise polygon (n, 2) around the origin. Raises InputError."""
    @property
    def radius(self) -> float:
        """Of a disc; of a square its half side; else 0."""
    @property
    def ring(self) -> NDArray[np.float64]:
        """(n, 2): the polygon; empty for a point."""
    def __repr__(self) -> str: ...

class FreeSpace:
    """Where the robot's reference point may be. Immutable."""

    def __init__(self, world: World, footprint: Footprint = ..., places: ArrayLike | None = ...) -> None:
        """places: points (n, 2) that will be asked about; only where a sloped wall was bent by rounding does that
        matter. Raises InputError, TooFine."""
    @property
    def world(self) -> World: ...
    @property
    def footprint(self) -> Footprint: ...
    @property
    def polygons(self) -> list[Polygon]:
        """Tuples of rings (n, 2): the outer one and holes."""
    @property
    def constraints(self) -> NDArray[np.float64]:
        """(n, 4): everything that stops a path."""
    @property
    def component_count(self) -> int:
        """How many connected parts there are."""
    @property
    def displacement(self) -> float:
        """The largest distance by which a crossing was rounded."""
    @property
    def within(self) -> float:
        """How far an obstacle may lie from where it is written: 0, or where crossings were rounded a bit more."""
    @property
    def triangulation(self) -> tuple[NDArray[np.float64], NDArray[np.uint32], NDArray[np.uint8]]:
        """points (p, 2), triangles (n, 3) as indices of them, free (n,): 1 where a path may be."""
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...
    def is_free(self, point: PointLike) -> bool:
        """Can the robot be there? Exact."""
    def sees(self, p: PointLike, q: PointLike) -> bool:
        """Can a path go straight from p to q? Exact. False when one is not free."""
    def clearance(self, point: PointLike) -> float:
        """The distance to the nearest obstacle. Raises InputError when the point is not free."""
    def clearances(self, points: ArrayLike) -> NDArray[np.float64]:
        """(n,): of points (n, 2); -1 of those that are not free."""
    def visibility_polygon(self, point: PointLike) -> NDArray[np.float64]:
        """(n, 2): the outline of what is seen, counter-clockwise. Raises InputError."""
    def nearest_free(self, point: PointLike) -> tuple[float, float] | None:
        """The nearest place for the robot; the point itself when it is one. None without any place."""
    def separation(self, p: PointLike, q: PointLike) -> NDArray[np.float64]:
        """(n, 4): the closed chain of walls that keeps them apart; no rows when nothing does."""
    @property
    def __geo_interface__(self) -> dict[str, Any]: ...

class Gates:
    """Where walls come near each other: what a disc has to pass. Of a point's space."""

    def __init__(self, space: FreeSpace) -> None: ...
    @property
    def segments(self) -> NDArray[np.float64]:
        """(n, 4): narrowest first, to the nearest doubles."""
    @property
    def widths(self) -> NDArray[np.float64]:
        """(n,): the diameters that pass."""
    def __len__(self) -> int: ...
    def passage(
        self,
        start: PointLike | None = ...,
        goal: GoalLike | None = ...,
        radius: float | None = ...,
    ) -> Passage:
        """A Passage from start to goal. Raises InputError when an end is not free."""

class Grid:
    """A grid of cells (rows, columns), row 0 on top, true where blocked, and searches on it."""

    def __init__(self, blocked: ArrayLike, moves: int | str = ...) -> None:
        """moves: 4, 8, or 'octile': diagonal ones only where both cells beside them are free."""
    def find(
        self,
        start: tuple[int, int] | ArrayLike,
        goal: tuple[int, int] | ArrayLike,
        algorithm: str = ...,
        heuristic: str | None = ...,
        *,
        ties: str = ...,
        weight: float = ...,
        record: bool = ...,
    ) -> GridAnswer:
        """A GridAnswer from start to goal (row, column), by 'bfs', 'dfs', 'dijkstra', 'greedy', 'greedy-once',
        'astar', 'weighted-astar', 'bidirectional-astar', 'idastar', 'jps'. record: keep what was visited. Raises
        InputError when an end is blocked."""
    def distances_to(self, goal: tuple[int, int] | ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.int8]]:
        """length (rows, columns): of the cheapest way from each cell to the goal, inf where there is none; move (rows,
        columns) int8: its first move, an index of GRID_MOVES, -1 at the goal and where there is no way. Exact."""

class GridAnswer:
    """What a search on a grid found, and what it took."""

    @property
    def found(self) -> bool: ...
    @property
    def path(self) -> NDArray[np.uint32]:
        """(n, 2): row, column from start to goal; empty unless found."""
    @property
    def cost(self) -> float:
        """Straight moves are 1, diagonal ones sqrt(2)."""
    @property
    def moves(self) -> tuple[int, int]:
        """How many straight, how many diagonal moves the cost is."""
    @property
    def optimal(self) -> bool:
        """Proven."""
    @property
    def steps(self) -> int:
        """Cells taken."""
    @property
    def entered(self) -> int:
        """Entries of the frontier."""
    @property
    def visited(self) -> NDArray[np.uint32]:
        """(n, 2): cells in the order of their first taking, where recorded."""
    @property
    def frontier(self) -> NDArray[np.uint32]: ...
    def __bool__(self) -> bool: ...
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...

class Journey:
    """What a bug walked."""

    @property
    def reached(self) -> bool:
        """False: there is no path, proven."""
    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 2): all that was walked."""
    @property
    def length(self) -> float: ...
    @property
    def bound(self) -> float:
        """What it never walks more than, by its theory."""
    @property
    def hits(self) -> NDArray[np.float64]:
        """(n, 2)."""
    @property
    def leaves(self) -> NDArray[np.float64]:
        """(n, 2)."""
    def __bool__(self) -> bool: ...
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...
    @property
    def __geo_interface__(self) -> dict[str, Any]: ...

class Judgement:
    """What the judge of certificates says."""

    @property
    def proven(self) -> bool: ...
    @property
    def kind(self) -> str:
        """'shortest', 'none', 'widest', 'arcs'."""
    @property
    def words(self) -> str:
        """What is proven, or what refutes it."""
    @property
    def length(self) -> float:
        """Of the path given; of the widest how far its path keeps from walls."""
    @property
    def bound(self) -> float:
        """No path is shorter; no disc of a greater radius gets through."""
    def __bool__(self) -> bool: ...
    def __repr__(self) -> str: ...

class KeptPath:
    """The shortest path that keeps a clearance, with arcs, where its ends allow."""

    @property
    def length(self) -> float: ...
    @property
    def length_bounds(self) -> tuple[float, float]:
        """Two doubles around the exact length."""
    @property
    def clearance(self) -> float: ...
    @property
    def parts(self) -> list[tuple[float, NDArray[np.float64]]]:
        """[(radius, points), ...]: what each part keeps from walls, and (n, 2) points on it, legs between them no
        farther from it than radius / 1000. Those below the clearance leave the start and enter the goal."""
    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 2): of all parts."""
    def verify(self) -> bool:
        """A check that shares nothing with the planner: True when each part keeps what it says."""
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...

class Length:
    """The length of a chain of points: a sum of square roots, kept as such. Compared exactly; float() is the
    nearest double."""

    def __init__(self, points: ArrayLike = ...) -> None:
        """Of the chain through the points (n, 2)."""
    def decimals(self, places: int) -> str:
        """The nearest number with that many decimals, as text."""
    @property
    def terms(self) -> int:
        """How many square roots it is a sum of."""
    def __float__(self) -> float: ...
    def __add__(self, _arg0: Length) -> Length: ...
    def __eq__(self, other: object) -> bool: ...
    def __hash__(self) -> int: ...
    def __ne__(self, other: object) -> bool: ...
    def __lt__(self, _arg0: Length) -> bool: ...
    def __le__(self, _arg0: Length) -> bool: ...
    def __gt__(self, _arg0: Length) -> bool: ...
    def __ge__(self, _arg0: Length) -> bool: ...
    def __repr__(self) -> str: ...

class Meeting:
    """Where a robot meets a moving target, as early as can be."""

    @property
    def time(self) -> float:
        """They can be at one place then."""
    @property
    def time_bounds(self) -> tuple[float, float]:
        """Two neighbouring doubles around the exact time, or that time twice."""
    @property
    def at(self) -> Point: ...
    @property
    def leg(self) -> int:
        """Of the target's way, from that row on."""
    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 2): the robot's path, the shortest."""
    @property
    def length(self) -> float: ...
    @property
    def waits(self) -> float:
        """How long the robot stands there before."""
    def verify(self) -> bool:
        """Is the path one, and short enough? By code that shares nothing with the search."""
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...

class MouseRun:
    """A micromouse trial as it went."""

    @property
    def finished(self) -> bool: ...
    @property
    def status(self) -> str:
        """In words."""
    @property
    def score(self) -> float | None:
        """Steps of run 2, and a thirtieth of those of run 1; None unless finished."""
    @property
    def run1(self) -> int:
        """Steps, the reset included."""
    @property
    def run2(self) -> int: ...
    @property
    def steps(self) -> NDArray[np.int32]:
        """(n, 10) int32, a row a step: run, x, y, heading in degrees clockwise from north, what was seen left,
        ahead, right, the rotation asked for, cells moved, 1 for a reset."""
    @property
    def offences(self) -> list[tuple[int, str]]:
        """(step, what): actions that the rules do not know."""
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...

class NoPath:
    """That there is no path, proven, and why."""

    @property
    def walls(self) -> NDArray[np.float64]:
        """(n, 4): the closed chain of walls between the ends, in order."""
    @property
    def start(self) -> Point: ...
    @property
    def goal(self) -> Point | NDArray[np.float64] | None: ...
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...

class Passage:
    """How large a disc gets through, and what stops a larger one."""

    @property
    def radius(self) -> float | None:
        """Of the largest disc that gets through, exactly: no larger double does. None: not even a point does."""
    @property
    def gets_through(self) -> bool:
        """Of the radius that was asked about; without one, of a point."""
    @property
    def is_proven(self) -> bool: ...
    @property
    def walls(self) -> NDArray[np.float64]:
        """(n, 4): the walls of the chain that stops the disc asked about, else any larger one."""
    @property
    def gates(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """(n, 4), (n,): its gates, the widest first, and their widths."""
    @property
    def start(self) -> Point: ...
    @property
    def goal(self) -> Point: ...
    def __bool__(self) -> bool: ...
    def __repr__(self) -> str: ...

class PassageIndex:
    """Where a disc of any radius gets to, and how wide it is: one index for all radii and ends, microseconds a
    question. Of a point's space; exact."""

    def __init__(self, space: FreeSpace) -> None: ...
    @property
    def gates(self) -> Gates: ...
    def widest(self, start: PointLike | None = ..., goal: GoalLike | None = ...) -> float | None:
        """The radius of the largest disc that gets from start to goal; None: not even a point does."""
    def passes(self, radius: float, start: PointLike | None = ..., goal: GoalLike | None = ...) -> bool:
        """Does a disc get there? False also where it cannot be at an end."""
    def matrix(self, points: ArrayLike) -> NDArray[np.float64]:
        """(n, n): the radii of the largest discs between each two of (n, 2) points; 0 where none gets."""
    def map(self, start: PointLike | None = ...) -> list[tuple[NDArray[np.float64], float]]:
        """[(ring, radius), ...]: the faces between walls and gates, and the largest disc that gets into each; the
        widest first."""
    def reach(self, radius: float, start: PointLike | None = ...) -> DiscReach | None:
        """The DiscReach of a disc; None where it cannot be at the start."""
    def nearest_place(self, radius: float, point: PointLike) -> tuple[Point, float] | None:
        """The place of a disc's centre that is nearest to the point, and its distance; None: there is none at all."""
    def __repr__(self) -> str: ...

class Path:
    """A path of the robot's reference point."""

    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 2): from start to goal."""
    @property
    def length(self) -> float:
        """To the nearest double."""
    @property
    def exact_length(self) -> Length:
        """A Length: compares exactly."""
    @property
    def optimal(self) -> bool:
        """It is the shortest, proven."""
    @property
    def within(self) -> float:
        """0, or where crossings of walls were rounded: no path that stays so far from obstacles is shorter, and
        this one goes through none deeper."""
    @property
    def planner(self) -> str:
        """What found it."""
    @property
    def expanded(self) -> int:
        """Nodes that the search took from its queue."""
    @property
    def start(self) -> Point: ...
    @property
    def goal(self) -> Point | NDArray[np.float64] | None:
        """A point, or a room as boxes (n, 4)."""
    @property
    def space(self) -> FreeSpace: ...
    @property
    def corners(self) -> int:
        """How often it bends."""
    @property
    def clearance(self) -> float:
        """The least distance to an obstacle; 0 when it touches one."""
    def verify(self) -> Verdict:
        """A check that shares nothing with the planners: a Verdict."""
    def decimals(self, places: int) -> str:
        """The length with that many decimals, as text."""
    def __len__(self) -> int: ...
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...
    @property
    def __geo_interface__(self) -> dict[str, Any]: ...

class Polyanya:
    """A free space with its navigation mesh, for any number of queries and threads. landmarks: a table of
    distances from so many places, for thousands of queries where paths wind."""

    def __init__(self, space: FreeSpace, landmarks: int = ...) -> None: ...
    @property
    def space(self) -> FreeSpace: ...
    def find(self, start: PointLike, goal: GoalLike) -> Path | None:
        """The shortest Path; None when there is none, proven. The goal is a point, or a room as boxes (n, 4). Raises
        InputError when an end is not free, Unproven."""
    def find_many(self, queries: ArrayLike, *, paths: bool = ..., threads: int = ...) -> Answers:
        """Answers to queries (n, 4): start x y, goal x y. On all cores, or so many threads, without Python's lock; the
        answers are the same however many. paths: their points as well. Ctrl-C stops it."""
    def distances(self, starts: ArrayLike, goals: ArrayLike = ..., *, threads: int = ...) -> NDArray[np.float64]:
        """(n, m): the lengths of the shortest paths from starts (n, 2) to goals (m, 2), the starts themselves unless
        given; inf where there is no path, nan where an end is not free. One search a start, on all cores."""
    def find_nearest(self, start: PointLike, goals: ArrayLike) -> tuple[Path, int] | None:
        """The shortest Path to any of the goals (n, 2) and which one it is; None when none is reached. Goals that are
        not free are left out."""
    def find_each(self, start: PointLike, goals: ArrayLike) -> list[Path] | None:
        """A list of the shortest Path to each of the goals (n, 2), in one search; None where there is none."""

class Index:
    """A free space prepared for queries of microseconds, in so many bytes at most. For thousands of queries."""

    def __init__(self, space: FreeSpace, memory: int = ...) -> None: ...
    @staticmethod
    def load(path: str, space: FreeSpace) -> Index:
        """What save() wrote, mapped, for the same world and robot. Raises InputError when it is another's or
        damaged."""
    def save(self, path: str) -> None:
        """Keeps it in a file, for load()."""
    @property
    def space(self) -> FreeSpace: ...
    @property
    def bends(self) -> int:
        """How many places there are where a path can bend."""
    @property
    def nbytes(self) -> int:
        """How large it is."""
    def find(self, start: PointLike, goal: PointLike) -> Path | None:
        """The shortest Path, as Polyanya's find; None when there is none, proven. Raises InputError when an end is not
        free, Unproven."""
    def find_many(self, queries: ArrayLike, *, paths: bool = ...) -> Answers:
        """Answers to queries (n, 4): start x y, goal x y; without Python's lock. paths: their points as well. Ctrl-C
        stops it."""

class Roadmap:
    """A graph embedded in a FreeSpace."""

    @property
    def points(self) -> NDArray[np.float64]:
        """(v, 2): the vertices."""
    @property
    def edges(self) -> NDArray[np.uint32]:
        """(e, 2) uint32: the edges, each once, the lower vertex first."""
    @property
    def lengths(self) -> NDArray[np.float64]:
        """(e,): of the edges."""
    @property
    def offsets(self) -> NDArray[np.int64]:
        """(v + 1,): the neighbours of v are targets[offsets[v]:offsets[v + 1]]."""
    @property
    def targets(self) -> NDArray[np.uint32]:
        """(2 e,) uint32: every edge from both ends, rows ascending."""
    @property
    def space(self) -> FreeSpace: ...
    @property
    def kind(self) -> str: ...
    @property
    def optimal(self) -> bool:
        """Its paths are the shortest in the plane."""
    def find(
        self,
        start: PointLike | None = ...,
        goal: GoalLike | None = ...,
        *,
        algorithm: str = ...,
        heuristic: str = ...,
    ) -> Path | None:
        """A Path in the roadmap, by 'astar', 'dijkstra', 'bfs', 'dfs' or 'greedy'; the estimate is 'euclidean',
        'manhattan', 'octile', 'chebyshev' or 'zero'. None when there is none anywhere, proven. Raises Unproven
        where only the roadmap has none, InputError."""
    def distances_to(self, point: PointLike) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """length (v,): of each vertex' way to the point, inf where there is none, off by at most an ulp a leg; next
        (v,): the vertex to go to, -1 where it is the point itself or there is no way."""
    def __len__(self) -> int: ...
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...
    def to_networkx(self) -> Any:
        """A networkx.Graph: nodes 0 to v - 1 with `pos`, edges with `weight`, their length."""

class TradeoffStretch:
    """Radii of discs whose shortest way bends around the same corners."""

    @property
    def radii(self) -> tuple[float, float]:
        """The least and the largest."""
    @property
    def lengths(self) -> tuple[float, float]:
        """Of their ways."""
    @property
    def then(self) -> str:
        """What happens beyond, in words."""
    def length(self, radius: float) -> float:
        """Of the shortest way of that disc."""
    def points(self, radius: float) -> NDArray[np.float64]:
        """(n, 2): on that way, legs between them no farther from it than radius / 1000."""
    def __repr__(self) -> str: ...

class Verdict:
    """What the check of a path found that shares nothing with the planners."""

    @property
    def valid(self) -> bool: ...
    @property
    def reason(self) -> str:
        """Empty when valid, else one line."""
    @property
    def leg(self) -> int:
        """The first offending leg, from 0."""
    @property
    def clearance(self) -> float: ...
    def __bool__(self) -> bool: ...
    def __repr__(self) -> str: ...

class World:
    """What stands where, before any robot is chosen. Immutable, checked."""

    def __init__(
        self,
        walls: ArrayLike | None = ...,
        *,
        thickness: ArrayLike = ...,
        areas: Iterable[PolygonLike] | None = ...,
        solids: Iterable[PolygonLike] | None = ...,
        boundary: str = ...,
        start: PointLike | None = ...,
        goal: GoalLike | None = ...,
        snap: float | str | None = ...,
        source: str = ...,
    ) -> None:
        """A world of arrays. walls: (n, 4) x1 y1 x2 y2, or (n, 2, 2). thickness: of all walls, or one a wall; 0 is a
        wall that a path may touch. areas: polygons where the world is; solids: polygons that are obstacles. A
        polygon is a ring (n, 2), a list of rings (the outer one, then holes), or what has a __geo_interface__ of
        one (shapely's polygons). boundary: of areas; 'walled': solid outside, 'limit': one may not leave, 'open'.
        start, goal: points; a goal may be a room, boxes (n, 4). snap: None joins what lies within rounding, a
        number what is no farther apart, 'auto', 0 nothing. Raises InputError."""
    @property
    def source(self) -> str:
        """The file's name; may be empty."""
    @property
    def walls(self) -> NDArray[np.float64]:
        """(n, 4): x1 y1 x2 y2."""
    @property
    def thickness(self) -> NDArray[np.float64]:
        """(n,): of each wall."""
    @property
    def areas(self) -> list[Polygon]:
        """Polygons: tuples of rings (n, 2), the outer one and holes."""
    @property
    def solids(self) -> list[Polygon]:
        """Polygons that are obstacles."""
    @property
    def boundary(self) -> str:
        """'walled', 'limit' or 'open'."""
    @property
    def start(self) -> Point | None:
        """A point, or None."""
    @property
    def goal(self) -> Point | NDArray[np.float64] | None:
        """A point, a room as boxes (n, 4), or None."""
    @property
    def box(self) -> tuple[float, float, float, float]:
        """xmin, ymin, xmax, ymax of the areas."""
    @property
    def openings(self) -> NDArray[np.float64]:
        """(n, 4): the pieces of the outline on which no wall stands."""
    @property
    def y_down(self) -> bool:
        """Pictures show its y growing downwards."""
    @property
    def uncertainty(self) -> float:
        """How far from where it was meant a place may lie."""
    def with_ends(self, start: PointLike | None = ..., goal: PointLike | None = ...) -> World:
        """A copy with another start, goal (a point); an absent one stays. Raises InputError."""
    def with_wall_thickness(self, thickness: float) -> World:
        """A copy whose walls all are so thick. Raises InputError."""
    def write(self, format: str = ...) -> bytes:
        """The bytes of a file that read_world reads back."""
    def _repr_svg_(self) -> str: ...
    def __repr__(self) -> str: ...
    @property
    def __geo_interface__(self) -> dict[str, Any]: ...

def alternatives(
    space: FreeSpace, count: int = ..., start: PointLike | None = ..., goal: GoalLike | None = ...
) -> list[Alternative]:
    """Up to count Alternatives, the shortest of each homotopy class, the shortest first; none when there is no path.
    Raises InputError, Unproven."""

def audit(world: World, points: ArrayLike, robot: Footprint = ..., *, gap: bool = ...) -> Audit:
    """Can the robot follow the points (n, 2), where does it first meet a wall, how near does it come, how much longer
    than the shortest is it? An Audit; a disc is taken for the disc itself."""

def bug(
    space: FreeSpace,
    algorithm: str = ...,
    start: PointLike | None = ...,
    goal: GoalLike | None = ...,
    *,
    turn: str = ...,
    range: float = ...,
) -> Journey:
    """The Journey of a bug that knows where its goal is, and of walls what it touches ('bug1', 'bug2') or sees as far
    as range ('tangent'). Raises InputError when an end is not free."""

def certificate(
    space: FreeSpace,
    start: PointLike | None = ...,
    goal: GoalLike | None = ...,
    *,
    widest: bool = ...,
    radius: float | None = ...,
) -> str:
    """A proof, as text, that no path is shorter, or that there is none; with widest that no larger disc gets through;
    with a radius what no path of that disc is shorter than. Of a point or a square. Raises InputError when an end is
    not free, Unproven."""

def chase(
    map: ChaseMap,
    planner: str | Callable[[tuple[int, int], int], tuple[int, int] | None] = ...,
    *,
    clock: str = ...,
    horizon: int | None = ...,
) -> ChaseRun:
    """A ChaseRun by 'exact', 'entry', 'weighted', 'first', or by what may be called: planner((x, y), second) gives the
    next cell, itself to wait, None to give up. horizon: seconds of the trajectory that are seen ahead. A step takes
    one second."""

def clear_path(
    world: World,
    clearance: float,
    start: PointLike | None = ...,
    goal: GoalLike | None = ...,
) -> ClearPath | None:
    """The shortest ClearPath, along the Voronoi diagram, that keeps the clearance; None when none does, proven. Raises
    InputError, Unproven."""

def clearance_tradeoff(world: World, start: PointLike | None = ..., goal: GoalLike | None = ...) -> list[ClearPath]:
    """Every best ClearPath, from the shortest to the widest: what room costs in length."""

def collisions(
    robots: Sequence[ArrayLike], radius: float | Sequence[float], *, stay: bool = ...
) -> list[Collision]:
    """All collisions of discs, by time. robots: for each rows time, x, y (n, 3), straight and even in between; radius:
    of all, or one each. Without stay they are nowhere before their first and after their last time. Exact."""

def compare(
    space: FreeSpace,
    planners: Iterable[str] | None = ...,
    start: PointLike | None = ...,
    goal: GoalLike | None = ...,
    runs: int = ...,
    *,
    seed: int = ...,
    sampler: str = ...,
    connection: str = ...,
    clearance: float = ...,
    samples: int = ...,
    lazy: bool = ...,
    exactly: bool = ...,
) -> list[dict[str, Any]]:
    """A table, for pandas.DataFrame: a dict for each run of each planner; random ones run with seeds seed, seed + 1,
    ... `ratio` is to the shortest in the plane, seconds are CPU, `unfit` says why a planner did not run at all. Of
    the random ones seed; of a PRM also sampler ('sobol', 'uniform', 'lattice', 'gaussian', 'bridge', 'medial-axis',
    'corners'), connection ('nearest:8', 'visible:8', 'forest:8', 'radius:1.5', 'prm-star'), clearance, samples,
    lazy, exactly."""

def disc_path(
    space: FreeSpace,
    radius: float,
    start: PointLike | None = ...,
    goal: GoalLike | None = ...,
) -> ArcPath | None:
    """The shortest ArcPath of a disc of exactly that radius, in a point's space; None when there is none, proven.
    Raises InputError when the disc cannot be at an end, Unproven."""

def drive(
    space: FreeSpace,
    car: Car,
    start: PointLike | None = ...,
    goal: GoalLike | None = ...,
    *,
    heading: float | None = ...,
    goal_heading: float | None = ...,
    weight: float = ...,
    most_poses: int = ...,
) -> Drive | None:
    """A Drive from start to goal; headings in degrees counter-clockwise from x, any when None. At most weight times as
    long as the shortest on its lattice. None when there is none, proven. Raises InputError when the car cannot
    stand there, Unproven."""

def earliest_meeting(
    space: FreeSpace,
    way: ArrayLike,
    start: PointLike | None = ...,
    *,
    speed: float = ...,
    stays: bool = ...,
) -> Meeting | None:
    """The earliest Meeting of a robot, from start at time 0 and with speed at most, and a target on its way: rows time,
    x, y (n, 3), straight and even in between; after the last one it is gone, or stays. None when there is none, proven.
    The target may be faster. Raises InputError when the start is not free, or a wall is in the target's way."""

def judge(space: FreeSpace, certificate: str) -> Judgement:
    """Does the certificate, as text, prove what it says of the space? A Judgement, by signs of integers alone. Raises
    InputError when it cannot be read."""

def kept_path(
    index: PassageIndex, clearance: float, start: PointLike | None = ..., goal: GoalLike | None = ...
) -> KeptPath | None:
    """The KeptPath of a PassageIndex: an end nearer to walls is left, or entered, by the shortest way that keeps what
    the end has (docs/definitions.md). None where gates are too narrow. Raises InputError."""

def mouse_explorers() -> list[str]:
    """The names of the robots that come with taut."""

def near_contacts(world: World) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """What nearly touches: ends (n, 2), the wall or side that each is near (n, 4), distances (n,)."""

def no_path(space: FreeSpace, start: PointLike, goal: GoalLike) -> NoPath | None:
    """A NoPath with the walls that separate the ends; None when nothing proves that there is no path. Raises
    InputError when an end is not free."""

def occupancy_world(
    blocked: ArrayLike,
    *,
    resolution: float | None = ...,
    origin: PointLike = ...,
    yaw: float = ...,
    source: str = ...,
) -> World:
    """The World of cells (rows, columns), row 0 on top: cell (row r, column c) is [c, c + 1] x [r, r + 1], y down.
    With a resolution in metres a cell, y up, the lower left corner at origin, turned by yaw around it, as ROS has
    maps."""

def plan(
    space: FreeSpace,
    planner: str = ...,
    start: PointLike | None = ...,
    goal: GoalLike | None = ...,
    *,
    seed: int = ...,
    sampler: str = ...,
    connection: str = ...,
    clearance: float = ...,
    samples: int = ...,
    lazy: bool = ...,
    exactly: bool = ...,
) -> Path | None:
    """A Path by one of planners(); None when there is none, proven. Of the random ones seed; of a PRM also sampler
    ('sobol', 'uniform', 'lattice', 'gaussian', 'bridge', 'medial-axis', 'corners'), connection ('nearest:8',
    'visible:8', 'forest:8', 'radius:1.5', 'prm-star'), clearance, samples, lazy, exactly. Raises InputError when an end is
    not free or the world does not suit the planner, Unproven."""

def planners() -> dict[str, str]:
    """What planners there are: a line for each name."""

def read_chase_map(text: str, source: str = ...) -> ChaseMap:
    """A ChaseMap of a text with sections N, C, R, T, M. Raises InputError."""

def read_chase_map_file(path: str | os.PathLike[str]) -> ChaseMap:
    """The same from a file."""

def read_world(
    text: str | bytes,
    *,
    format: str | None = ...,
    polygons: str = ...,
    repair: bool = ...,
    cell_size: float = ...,
    resolution: float | None = ...,
    unknown_is_free: bool = ...,
    snap: float | str | None = ...,
    thickness: float | None = ...,
    project: bool = ...,
    start: PointLike | None = ...,
    goal: PointLike | None = ...,
    source: str = ...,
    notes: list[str] | None = ...,
) -> World:
    """The world that a text, or bytes, of any format describes; found out from the content. Options: format:
    'segments', 'drawing', 'blocks', 'wkt', 'geojson', 'svg', 'movingai', 'ros', 'picture', 'maz', 'num', 'cells'.
    polygons without a role are 'free' (floor plans), 'obstacles' or 'nested'. repair: also rings that cross.
    cell_size of grid mazes; resolution of a picture: metres a pixel; unknown_is_free of ROS maps. snap: as of
    World. thickness of every wall. project: coordinates are longitude and latitude. start, goal instead of what is
    written. source: a file's name for messages. notes: a list that takes a line for what one may wish to know.
    Raises InputError with file, line and culprit."""

def read_world_file(
    path: str | os.PathLike[str],
    *,
    format: str | None = ...,
    polygons: str = ...,
    repair: bool = ...,
    cell_size: float = ...,
    resolution: float | None = ...,
    unknown_is_free: bool = ...,
    snap: float | str | None = ...,
    thickness: float | None = ...,
    project: bool = ...,
    start: PointLike | None = ...,
    goal: PointLike | None = ...,
    source: str = ...,
    notes: list[str] | None = ...,
) -> World:
    """The world that a file, gzipped or not, describes; options as of read_world."""

def roadmap(
    space: FreeSpace,
    kind: str = ...,
    start: PointLike | None = ...,
    goal: GoalLike | None = ...,
    *,
    seed: int = ...,
    sampler: str = ...,
    connection: str = ...,
    clearance: float = ...,
    samples: int = ...,
    lazy: bool = ...,
    exactly: bool = ...,
) -> Roadmap:
    """A Roadmap of one of roadmap_kinds(). A 'prm' grows until it joins start and goal, the world's own unless others
    are given. Of the random ones seed; of a PRM also sampler ('uniform', 'lattice', 'gaussian', 'bridge', 'medial-
    axis', 'corners'), connection ('nearest:8', 'visible:8', 'forest:8', 'radius:1.5', 'prm-star'), clearance,
    samples, lazy, exactly. Raises InputError where the world does not suit the kind."""

def roadmap_kinds() -> dict[str, str]:
    """What roadmaps there are: a line for each name."""

def run_mouse(maze: World, robot: str | type[Mouse] | Mouse, *, max_steps: int = ..., seed: int = ...) -> MouseRun:
    """A contest of two runs in a maze, a World that came from cells. robot: the name of one of mouse_explorers(), an
    object with next_move((left, front, right)) -> (rotation, movement), or a class of such, made from the maze's
    width. rotation: -90, 0, 90; movement: -3 to 3 cells; 'reset', or a pair that begins with it, ends run 1. Raises
    InputError when the maze has openings or no cells, and what next_move raises."""

@overload
def shortest_path(
    world: World,
    start: PointLike | None = ...,
    goal: GoalLike | None = ...,
    footprint: Footprint = ...,
) -> Path | None:
    """The shortest Path in a World, or a FreeSpace, from start to goal, its own unless others are given; None when
    there is none, proven: no_path says why. Raises InputError when an end is not free, Unproven."""
@overload
def shortest_path(space: FreeSpace, start: PointLike | None = ..., goal: GoalLike | None = ...) -> Path | None: ...

def snapped(world: World, snap: float | str | None) -> tuple[World, dict[str, Any]]:
    """The world with what nearly touches joined, and a report: tolerance, joined, displacement, remaining. snap: a
    distance, 'auto', or None for what lies within rounding. Raises InputError when contacts remain."""

def tradeoff(
    space: FreeSpace, start: PointLike | None = ..., goal: GoalLike | None = ...
) -> list[TradeoffStretch]:
    """What room costs: a TradeoffStretch for each radius at which the shortest way of a disc changes, up to the largest
    disc that gets through; [] where none does. In a point's space."""

def verify(
    space: FreeSpace,
    points: ArrayLike,
    start: PointLike | None = ...,
    goal: GoalLike | None = ...,
) -> Verdict:
    """Can the points (n, 2) be followed, from start to goal? A Verdict, by a check that shares nothing with the
    planners. Without ends, from the first to the last point."""

def widest_path(world: World, start: PointLike | None = ..., goal: GoalLike | None = ...) -> ClearPath | None:
    """The ClearPath with the largest clearance; None when there is no path, proven."""
