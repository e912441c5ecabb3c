"""Pictures on matplotlib."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._taut import FreeSpace, NoPath, Roadmap, World


def plot(thing: Any, ax: Any = None, **style: Any) -> Any:
    """Draws a World, a FreeSpace, a Roadmap, a path of any kind, walls (n, 4) or points (n, 2) and returns the axes.

    `style` goes to matplotlib's line or patch. Without `ax` it is a new one, with equal scales.
    """
    if ax is None:
        from matplotlib import pyplot

        ax = pyplot.subplots()[1]
        ax.set_aspect("equal")
    if isinstance(thing, World):
        _plot_world(thing, ax, style)
    elif isinstance(thing, FreeSpace):
        _fill(ax, thing.polygons, {"facecolor": "#eef4fb", "edgecolor": "#8aa4c0", "linewidth": 0.5, **style})
    elif isinstance(thing, Roadmap):
        _segments(ax, thing.points[thing.edges], {"colors": "#9aa7b5", "linewidths": 0.5, **style})
    elif isinstance(thing, NoPath):
        _segments(ax, thing.walls.reshape(-1, 2, 2), {"colors": "#c62828", "linewidths": 2, **style})
    else:
        _plot_array(thing, ax, style)
    ax.autoscale_view()
    return ax


def _plot_world(world, ax, style):
    _segments(ax, world.walls.reshape(-1, 2, 2), {"colors": "#222222", "linewidths": 1, **style})
    if world.y_down and not ax.yaxis_inverted():
        ax.invert_yaxis()
    _fill(ax, world.solids, {"facecolor": "#555555", "edgecolor": "none"})
    for polygon in world.areas:
        for ring in polygon:
            ax.plot(*np.vstack([ring, ring[:1]]).T, color="#bbbbbb", linewidth=0.5)
    if world.start is not None:
        ax.plot(*world.start, "o", color="#2e7d32")
    if isinstance(world.goal, tuple):
        ax.plot(*world.goal, "s", color="#c62828")


def _plot_array(thing, ax, style):
    points = np.asarray(getattr(thing, "points", thing), dtype=float)
    if points.ndim != 2 or points.shape[1] not in (2, 4):
        raise TypeError(f"nothing that taut can plot: {thing!r}")
    if points.shape[1] == 4:
        _segments(ax, points.reshape(-1, 2, 2), {"colors": "#222222", **style})
    else:
        ax.plot(*points.T, **{"color": "#1565c0", "linewidth": 1.5, **style})


def _segments(ax, segments, style):
    from matplotlib.collections import LineCollection

    ax.add_collection(LineCollection(segments, **style))


def _fill(ax, polygons, style):
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path as Outline

    for polygon in polygons:
        closed = [np.vstack([ring, ring[:1]]) for ring in polygon]
        codes = [[Outline.MOVETO] + [Outline.LINETO] * (len(r) - 2) + [Outline.CLOSEPOLY] for r in closed]
        ax.add_patch(PathPatch(Outline(np.vstack(closed), np.concatenate(codes)), **style))
