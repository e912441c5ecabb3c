"""Exact motion planning in the plane: mazes, floor plans, polygons.

    import taut
    path = taut.shortest_path(taut.read_world_file("maze.txt"))
    path.length, path.points, path.verify()

Points are pairs, arrays of points float64 (n, 2), in the unit of the input; x to the right, y up. What is wrong with the
input is a taut.InputError, a ValueError that names file, line and culprit.
"""

from ._errors import InputError, TooFine, Unproven
from ._networkx import to_networkx
from ._taut import (
    Answers,
    ArcPath,
    ClearPath,
    Footprint,
    FreeSpace,
    Gates,
    Length,
    NoPath,
    Passage,
    Path,
    Polyanya,
    Roadmap,
    Verdict,
    World,
    clear_path,
    clearance_tradeoff,
    compare,
    disc_path,
    near_contacts,
    no_path,
    plan,
    planners,
    read_world,
    read_world_file,
    roadmap,
    roadmap_kinds,
    shortest_path,
    snapped,
    verify,
    widest_path,
    __version__,
)

Roadmap.to_networkx = to_networkx

__all__ = [
    "Answers",
    "ArcPath",
    "ClearPath",
    "Footprint",
    "FreeSpace",
    "Gates",
    "InputError",
    "Length",
    "NoPath",
    "Passage",
    "Path",
    "Polyanya",
    "Roadmap",
    "TooFine",
    "Unproven",
    "Verdict",
    "World",
    "__version__",
    "clear_path",
    "clearance_tradeoff",
    "compare",
    "disc_path",
    "near_contacts",
    "no_path",
    "plan",
    "planners",
    "read_world",
    "read_world_file",
    "roadmap",
    "roadmap_kinds",
    "shortest_path",
    "snapped",
    "to_networkx",
    "verify",
    "widest_path",
]
