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
  double tolerance = 0;  ///< of approximate points: how far the legs are from the curves, where the file says so
  std::optional<double> measured;  ///< of curves that the file holds: their length, within 1e-12 of it
};

/// Reads the paths of a file, whatever the program wrote them as:
///  - JSON: a list of points `[[x, y], ...]`, or an object, by itself or as the `result` of an envelope, with such a
///    list under `points` or `path` and perhaps a number under `length`; with `bends`, `start`, `goal` and the
///    `robot`'s radius it is a disc's path of arcs; with `curves` one along the Voronoi diagram, taken as 64 legs a
///    curve; a list of such under `tradeoff` is several
///    (a `way` in one is that of a disc, beside which start and goal lie: taken as legs);
///  - GeoJSON: LineStrings and Points, a path each;
///  - WKT: a LINESTRING or POINT each; arcs of a COMPOUNDCURVE as legs no farther from them
///    than a thousandth of their radius;
///  - YAML: messages nav_msgs/Path of ROS, or any with `poses` that have a `position`;
///  - text: a point `x y` or `x,y` a line, or CSV below a heading that begins with `x,y`, further columns left out, or
///    with `path,x,y`: several.
/// `#` starts a comment in the last three; `# legs between points of a curve, no farther than T from it` is believed.
/// With Breaks::blank_lines a blank line in text ends a path, and a third number a line (a heading) is left out: what
/// OMPL's printAsMatrix prints.
/// Any number of points. Throws InputError with the line; on a JSON result without a path (its status is not "found")
/// too. Not empty.
enum class Breaks { none, blank_lines };
std::vector<ClaimedPath> read_paths(std::string_view bytes, const std::string& source = {},
                                    Breaks breaks = Breaks::none);

/// The path of a file with one: else InputError.
ClaimedPath read_path(std::string_view bytes, const std::string& source = {});

}  // namespace taut
