// Paths as files of other trades: GeoJSON, WKT, CSV. The one place where they are written.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/search/arc_path.h>

namespace taut {

/// A path to be written.
struct PathToWrite {
  std::string name;              ///< who found it: `polyanya`, `bug2`
  std::vector<Point> points;     ///< from start to goal; of arcs and curves some that lie on them
  double tolerance = 0;          ///< how far the path may lie from the legs between the points; 0: it is these legs
  std::vector<ArcPiece> arcs{};  ///< of a path of legs and circular arcs: all its pieces, for WKT
  /// More numbers, one a point: {`second`, {0, 1, ...}}, {`heading`, ...}.
  std::vector<std::pair<std::string, std::vector<double>>> columns{};
  std::optional<double> length{};
};

/// The comment that says how far a curve may be from the legs between its points.
std::string approximation_line(double tolerance);

/// A point `x y` a line; what is approximated says so in a `#` line in front.
std::string path_listing(const PathToWrite& path);

/// Each returns the whole file; coordinates are the shortest decimals that read back as the same double. read_paths()
/// reads them back. No path at all is a file without one.
///
/// A FeatureCollection, a LineString (of one point: a Point) a path, with `path` (its name), `length`, `corners`,
/// `tolerance` when it is not 0, and an array for each of the columns among its properties.
std::string path_geojson(std::span<const PathToWrite> paths);

/// A geometry a line: LINESTRING, of one point POINT; with `arcs` a COMPOUNDCURVE of lines and CIRCULARSTRINGs, each by
/// its ends and its middle. What is approximated says so in a `#` line in front. No columns.
std::string path_wkt(std::span<const PathToWrite> paths);

/// A point a line below a heading: `x,y`, then the columns; in front of them `path` where there are several. What is
/// approximated says so in a `#` line in front.
std::string path_csv(std::span<const PathToWrite> paths);

}  // namespace taut
