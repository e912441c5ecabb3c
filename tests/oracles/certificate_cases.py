"""Worlds, certificates and what a judge has to say of them, by hand: what random ones do not come to."""

from certificate import fingerprint

HEAD = "taut integers 1\nunit 1\nboundary open\n"
WALL = HEAD + "wall 1 0 2 0\n"
SOLID = HEAD + "solid 2 0 4 0 4 4 2 4\n"
AREA = HEAD + "area 0 0 4 0 4 4 0 4\n"
CELL = HEAD + "wall 0 0 10 0\nwall 10 0 10 10\nwall 10 10 0 10\nwall 0 10 0 6\nwall 0 4 0 0\n"  # open by 2
AROUND = [[0, 4], [0, 0], [10, 0], [10, 10], [0, 10], [0, 6]]


def claim(text, kind, path, **more):
    return {"format": "taut certificate 1", "kind": kind, "world": fingerprint(text), "scale": 1, "path": path,
            "goal": [path[-1], path[-1]], **more}


def shortest(text, path, potentials, horizon, reach, **more):
    numbers = {"fraction_bits": 0, "potentials": potentials, "horizon": horizon, "reach": reach}
    return text, claim(text, "shortest", path, **numbers) | more


def none(text, start, goal, **more):
    return text, claim(text, "none", [start], fraction_bits=0, potentials=[[*start, 0]]) | {"goal": [goal, goal]} | more


def narrow(ends, width, chain):
    return CELL, claim(CELL, "none", ends, width=width, chain=chain)


def widest(keeps, width=2):
    return CELL, claim(CELL, "widest", [[5, 5], [-5, 5]], width=width, keeps=keeps, chain=AROUND)


TIP = HEAD + "wall 2 0 4 1\nwall 2 0 4 -1\n"
FAR = HEAD + "wall 50 50 51 50\n"
ROOM = {"goal": [[2, -5], [3, 5]]}

AHEAD = [[0, 2], [0, -2]], [[0, 2, 0]], 4, 3  # past WALL
BEHIND = [[1, 2, 0], [1, 0, 1]], 4, 3  # numbers for what goes from (1, 2) to (0, -2)

CASES = [
    (0, "straight on", *shortest(WALL, *AHEAD)),
    (1, "another world", *shortest(WALL, *AHEAD, world="0" * 16)),
    (3, "another format", *shortest(WALL, *AHEAD, format="taut certificate 2")),
    (3, "another kind", *shortest(WALL, *AHEAD, kind="longest")),
    (3, "no scale", *shortest(WALL, *AHEAD, scale=-1)),
    (3, "a horizon that is no number", *shortest(WALL, AHEAD[0], AHEAD[1], float("nan"), 3)),
    (3, "a horizon that is no integer", *shortest(WALL, AHEAD[0], AHEAD[1], 4.5, 3)),
    (3, "a goal without area", *shortest(WALL, *AHEAD, goal=[[0, -2], [1, -2]])),
    (1, "nothing stops", *none(WALL, [0, 2], [0, -2])),
    (3, "numbers so fine that nothing differs", *none(WALL, [0, 2], [0, -2], fraction_bits=1000)),
    (3, "places so far that nothing differs", *none(WALL, [0, 2], [0, -2], scale=2**500)),
    (3, "a wall of three places", *shortest(HEAD + "wall 1 0 2 0 2 1\n", *AHEAD)),
    (3, "a solid the wrong way round", *shortest(HEAD + "solid 2 4 4 4 4 0 2 0\n", *AHEAD)),
    (0, "a corner turned by", *shortest(WALL, [[1, 2], [0, -2]], *BEHIND)),
    (1, "a corner turned on its wrong side", *shortest(WALL, [[1, 2], [1, 0], [0, -2]], *BEHIND)),
    (1, "a leg of no length", *shortest(WALL, [[0, 2], [0, 2], [0, -2]], *AHEAD[1:])),
    (1, "back at the end of a wall", *shortest(WALL, [[0, 0], [1, 0], [0, 0]], [[0, 0, 0]], 1, 0)),
    (1, "straight through a solid", *shortest(SOLID, [[2, 2], [4, 2]], [[2, 2, 0]], 2, 1)),
    (1, "outside the area", *shortest(AREA, [[5, 1], [5, 2]], [[5, 1, 0]], 2, 1)),
    (1, "between a solid and a wall that touches it",
     *shortest(SOLID + "wall 0 2 2 2\n", [[2, 1], [2, 3]], [[2, 1, 0]], 3, 2)),
    (0, "a leg that is not tangent",
     *shortest(TIP, [[0, 0], [0, 5]], [[0, 0, 0], [2, 0, 3], [4, 1, 3], [4, -1, 3]], 6, 4)),
    (0, "a corner of an area, from inside", *shortest(AREA, [[2, 0], [2, 2]], [[2, 0, 0]], 6, 2)),
    (0, "a room straight ahead", *shortest(FAR, [[0, 0], [2, 0]], [[0, 0, 0]], 4, 2, **ROOM)),
    (1, "a room nearer than its number", *shortest(FAR, [[0, 0], [2, 0]], [[0, 0, 0]], 4, 3, **ROOM)),
    (0, "discs: too narrow", *narrow([[5, 5], [-5, 5]], 3, AROUND)),
    (1, "discs: a gate as wide as it", *narrow([[5, 5], [-5, 5]], 2, AROUND)),
    (1, "discs: a chain in mid-air", *narrow([[5, 5], [-5, 5]], 3, [*AROUND, [-1, 5]])),
    (1, "discs: an end on the chain", *narrow([[0, 2], [-5, 5]], 3, AROUND)),
    (1, "discs: both ends inside", *narrow([[5, 5], [6, 5]], 30, AROUND)),
    (0, "discs: no room at an end", *narrow([[5, 1], [-5, 5]], 3, [[5, 0]])),
    (1, "discs: just room at an end", *narrow([[5, 1], [-5, 5]], 2, [[5, 0]])),
    (3, "discs: less than no width", *narrow([[5, 5], [-5, 5]], -3, AROUND)),
    (0, "discs: the widest", *widest(1)),
    (1, "discs: a path too near", *widest(2)),
    (3, "discs: a path nearer than near", *widest(-1)),
]
