// Paths from files, for those who want one checked.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/search/arc_path.h>

namespace taut {

/// A path somebody claims.
struct ClaimedPath {
  std::vector<Point> points;     ///< of arcs their ends
  std::optional<double> length;  ///< what the file says it measures
  bool approximate = false;      ///< the points stand for curves, which are longer than the legs between them
  std::optional<ArcPath> arcs;   ///< a disc's path of legs and arcs, as its bends say
};

/// Reads a path, whatever the program wrote it as:
///  - JSON: a list of points `[[x, y], ...]`, or an object, by itself or as the `result` of an envelope, with such a
///    list under `points` or `path` and perhaps a number under `length`; with `bends`, `start`, `goal` and the
///    `robot`'s radius it is a disc's path of arcs; with `curves` one along the Voronoi diagram, taken as 64 legs a
///    curve;
///  - GeoJSON: one LineString or Point, or a collection with one;
///  - WKT: one LINESTRING or POINT; a COMPOUNDCURVE as legs between the ends and middles of its arcs;
///  - text: a point `x y` or `x,y` a line, or CSV below a heading that begins with `x,y`, further columns left out.
/// `#` starts a comment in the last two. Any number of points.
/// Throws InputError with the line; on a JSON result without a path (its status is not "found") too.
ClaimedPath read_path(std::string_view bytes, const std::string& source = {});

}  // namespace taut
