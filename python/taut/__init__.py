"""Exact motion planning in the plane: mazes, floor plans, polygons.

    import taut
    path = taut.shortest_path(taut.read_world_file("maze.txt"))
    path.length, path.points, path.verify()

Points are pairs, arrays of points float64 (n, 2), in the unit of the input; x to the right, y up. What is wrong with the
input is a taut.InputError, a ValueError that names file, line and culprit.
"""

from ._errors import InputError, TooFine, Unproven
from ._taut import (
    Answers,
    Footprint,
    FreeSpace,
    Length,
    NoPath,
    Path,
    Polyanya,
    Verdict,
    World,
    __version__,
    no_path,
    read_world,
    read_world_file,
    shortest_path,
    verify,
)

__all__ = [
    "Answers",
    "Footprint",
    "FreeSpace",
    "InputError",
    "Length",
    "NoPath",
    "Path",
    "Polyanya",
    "TooFine",
    "Unproven",
    "Verdict",
    "World",
    "__version__",
    "no_path",
    "read_world",
    "read_world_file",
    "shortest_path",
    "verify",
]
