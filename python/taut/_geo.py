"""Geometry of others in and out: shapely, GeoPandas, and all that has a __geo_interface__."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from ._taut import ArcPath, ClearPath, FreeSpace, Journey, Path, World, read_world


def world_from_geo(geometry: Any, *, polygons: str = "obstacles", **options: Any) -> World:
    """The World of what has a __geo_interface__ (a shapely geometry, a GeoSeries, a GeoDataFrame), or of several.

    Lines are walls; polygons are 'obstacles', 'free' (floor plans) or 'nested'. Columns `role`, `thickness`, `boundary`
    of a GeoDataFrame count as the properties of GeoJSON do. Options as of read_world: start, goal, snap, project, ...
    Raises InputError.
    """
    if hasattr(geometry, "__geo_interface__"):
        mapping = geometry.__geo_interface__
    else:
        geometries = [getattr(part, "__geo_interface__", None) for part in geometry]
        if None in geometries:
            raise TypeError("geometries have a __geo_interface__")
        mapping = {"type": "GeometryCollection", "geometries": geometries}
    return read_world(json.dumps(mapping, default=_number), format="geojson", polygons=polygons, **options)


def _number(value):
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"{value!r} is nothing that GeoJSON holds")


def _line(points):
    pairs = [tuple(p) for p in np.asarray(points).tolist()]
    if len(pairs) == 1:
        return {"type": "Point", "coordinates": pairs[0]}
    return {"type": "LineString", "coordinates": pairs}


def _ring(points):
    pairs = [tuple(p) for p in np.asarray(points).tolist()]
    return [*pairs, pairs[0]]


def _space(space):
    polygons = [[_ring(ring) for ring in polygon] for polygon in space.polygons]
    return {"type": "MultiPolygon", "coordinates": polygons}


def to_shapely(thing: Any) -> Any:
    """A shapely geometry: of a path a LineString, of a FreeSpace a MultiPolygon, of a ring (n, 2) a Polygon, of a World
    a GeometryCollection of its features."""
    from shapely import geometry

    if isinstance(thing, np.ndarray):
        return geometry.Polygon(thing)
    mapping = thing.__geo_interface__
    if mapping["type"] == "FeatureCollection":
        return geometry.GeometryCollection([geometry.shape(f["geometry"]) for f in mapping["features"]])
    return geometry.shape(mapping)


World.__geo_interface__ = property(lambda world: json.loads(world.write("geojson")))
FreeSpace.__geo_interface__ = property(_space)
for _type in (Path, ArcPath, ClearPath, Journey):
    _type.__geo_interface__ = property(lambda path: _line(path.points))
