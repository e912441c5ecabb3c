"""Roadmaps for networkx."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._taut import Roadmap


def to_networkx(roadmap: Roadmap) -> Any:
    """A networkx.Graph: nodes 0 to v - 1 with `pos`, edges with `weight`, their length."""
    import networkx

    graph = networkx.Graph()
    graph.add_nodes_from((i, {"pos": (x, y)}) for i, (x, y) in enumerate(roadmap.points.tolist()))
    ends = roadmap.edges.tolist()
    graph.add_weighted_edges_from((a, b, w) for (a, b), w in zip(ends, roadmap.lengths.tolist()))
    return graph
