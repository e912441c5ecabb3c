"""shapely, GeoPandas and matplotlib; each where it is there."""

import math

import numpy as np
import pytest

import taut


class Frame:
    """What a GeoDataFrame says of itself."""

    __geo_interface__ = {
        "type": "FeatureCollection",
        "features": [
            {"type": "Feature", "properties": {"role": "obstacle", "n": np.int64(1)},
             "geometry": {"type": "Polygon", "coordinates": [[(2, 2), (4, 2), (4, 4), (2, 4), (2, 2)]]}},
            {"type": "Feature", "properties": {"role": "wall", "thickness": 0.5},
             "geometry": {"type": "LineString", "coordinates": [(6, 0), (6, 4)]}},
        ],
    }


def test_shapely_geometries_are_a_world():
    geometry = pytest.importorskip("shapely.geometry")
    shapes = [geometry.box(2, 2, 4, 4), geometry.LineString([(6, 0), (6, 4)])]
    for given in shapes, geometry.GeometryCollection(shapes):
        world = taut.world_from_geo(given, start=(0, 3), goal=(8, 3))
        assert world.walls.tolist() == [[6, 0, 6, 4]] and len(world.solids) == 1
        path = taut.shortest_path(world)
        assert path.length == pytest.approx(geometry.LineString(path.points).length)
        assert not geometry.LineString(path.points).crosses(shapes[1])


def test_frames_are_read_with_their_roles():
    world = taut.world_from_geo(Frame(), polygons="free")
    assert len(world.solids) == 1 and world.thickness.tolist() == [0.5]
    assert taut.world_from_geo(Frame(), project=False).walls.tolist() == [[6, 0, 6, 4]]


def test_geopandas_frames_are_a_world():
    geopandas = pytest.importorskip("geopandas")
    frame = geopandas.GeoDataFrame.from_features(Frame.__geo_interface__)
    assert len(taut.world_from_geo(frame).solids) == 1
    assert len(geopandas.GeoDataFrame.from_features(taut.world_from_geo(frame).__geo_interface__)) >= 2


def test_floor_plans_have_holes():
    geometry = pytest.importorskip("shapely.geometry")
    plan = geometry.box(0, 0, 9, 9).difference(geometry.box(3, 3, 6, 6))
    world = taut.world_from_geo(plan, polygons="free", start=(1, 4.5), goal=(8, 4.5))
    assert taut.to_shapely(taut.FreeSpace(world)).equals(plan)
    assert taut.shortest_path(world).length == 3 + 2 * math.hypot(2, 1.5)


def test_what_taut_finds_are_shapely_geometries(room, data_folder):
    geometry = pytest.importorskip("shapely.geometry")
    space = taut.FreeSpace(room)
    path = taut.shortest_path(space)
    assert taut.to_shapely(path).length == pytest.approx(path.length)
    assert geometry.shape(path).geom_type == "LineString"
    assert taut.to_shapely(taut.shortest_path(space, (1, 1), (1, 1))).geom_type == "Point"
    assert taut.to_shapely(space).area == 16
    assert taut.to_shapely(space.visibility_polygon((1, 1))).area == 8.25
    assert {g.geom_type for g in taut.to_shapely(room).geoms} == {"MultiLineString", "Point", "Polygon"}
    assert taut.to_shapely(taut.widest_path(room)).length > 0
    assert taut.to_shapely(taut.bug(space)).length == pytest.approx(taut.bug(space).length)


def test_a_world_goes_through_its_geo_interface(room):
    again = taut.world_from_geo(room)
    assert again.walls.tolist() == room.walls.tolist() and again.start == room.start and again.goal == room.goal


def test_what_is_no_geometry_is_refused():
    for given in [1, 2], "POINT (1 1)", 7, None:
        with pytest.raises(TypeError):
            taut.world_from_geo(given)
    with pytest.raises(taut.InputError):
        taut.world_from_geo(type("Odd", (), {"__geo_interface__": {"type": "Circle"}})())


def test_everything_is_plotted(room, sealed):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    space = taut.FreeSpace(room)
    ax = taut.plot(room)
    things = [space, taut.roadmap(space, "full"), taut.shortest_path(space), taut.widest_path(room),
              taut.bug(space), taut.no_path(taut.FreeSpace(sealed), (1, 1), (3, 1)), room.walls, [(1, 1), (2, 2)]]
    for thing in things:
        assert taut.plot(thing, ax) is ax
    assert ax.get_xlim()[0] <= 0 and ax.get_xlim()[1] >= 4 and ax.get_aspect() == 1
    line = taut.plot(taut.shortest_path(space), color="red").lines[-1]
    assert line.get_color() == "red" and line.get_xdata().tolist() == [1, 2, 3]
    with pytest.raises(TypeError):
        taut.plot(np.zeros(3), ax)
    ax.figure.canvas.draw()
    pyplot.close("all")
