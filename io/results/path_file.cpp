#include <taut/io/results/path_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <taut/io/results/json.h>
#include <taut/io/results/words.h>
#include <taut/search/corner_count.h>

namespace taut {

namespace {

std::string approximation(const PathToWrite& path) {
  return path.tolerance == 0 ? "" : approximation_line(path.tolerance);
}

Json feature(const PathToWrite& path) {
  const bool stands = path.points.size() == 1;
  Json properties{{"path", path.name}, {"corners", corner_count(path.points)}};
  if (path.length) properties["length"] = *path.length;
  if (path.tolerance > 0) properties["tolerance"] = path.tolerance;
  for (const auto& [name, values] : path.columns) properties[name] = values;
  Json geometry{{"type", stands ? "Point" : "LineString"},
                {"coordinates", stands ? Json(path.points.front()) : Json(path.points)}};
  return {{"type", "Feature"}, {"properties", std::move(properties)}, {"geometry", std::move(geometry)}};
}

std::string wkt_points(std::span<const Point> points) {
  std::string out = "(";
  for (const Point p : points) {
    if (out.size() > 1) out += ", ";
    out += number_text(p.x) + " " + number_text(p.y);
  }
  return out + ")";
}

std::string wkt_line(std::span<const Point> points) {
  return (points.size() == 1 ? "POINT " : "LINESTRING ") + wkt_points(points) + "\n";
}

Point middle_of(const ArcPiece& arc) {
  const double angle = arc.from_angle + arc.turn * arc.sweep / 2,
               radius = std::hypot(arc.from.x - arc.centre.x, arc.from.y - arc.centre.y);
  return {arc.centre.x + radius * std::cos(angle), arc.centre.y + radius * std::sin(angle)};
}

/// Its pieces end where the next begins, to the digit: what is rounded twice takes the first.
std::string wkt_curve(const PathToWrite& path) {
  std::string out;
  Point at = path.points.front();
  for (const ArcPiece& piece : path.arcs) {
    if (piece.to == at) continue;
    const bool last = &piece == &path.arcs.back();
    const Point to = last ? path.points.back() : piece.to;
    out += out.empty() ? "COMPOUNDCURVE (" : ", ";
    out += piece.turn == 0 ? wkt_points(std::vector{at, to})
                           : "CIRCULARSTRING " + wkt_points(std::vector{at, middle_of(piece), to});
    at = to;
  }
  return out.empty() ? wkt_line(std::vector{at}) : out + ")\n";
}

}  // namespace

std::string approximation_line(double tolerance) {
  return fmt::format("# legs between points of a curve, no farther than {} from it\n", number_text(tolerance));
}

std::string path_listing(const PathToWrite& path) { return approximation(path) + points_text(path.points); }

std::string path_geojson(std::span<const PathToWrite> paths) {
  Json features = Json::array();
  for (const PathToWrite& path : paths)
    if (!path.points.empty()) features.push_back(feature(path));
  return json_text({{"type", "FeatureCollection"}, {"features", std::move(features)}});
}

std::string path_wkt(std::span<const PathToWrite> paths) {
  std::string out;
  for (const PathToWrite& path : paths) {
    if (path.points.empty()) continue;
    out += path.arcs.empty() ? approximation(path) + wkt_line(path.points) : wkt_curve(path);
  }
  return out;
}

std::string path_csv(std::span<const PathToWrite> paths) {
  std::string out;
  for (const PathToWrite& path : paths) out += out.empty() ? approximation(path) : "";
  out += paths.size() > 1 ? "path,x,y" : "x,y";
  if (!paths.empty())
    for (const auto& column : paths.front().columns) out += "," + column.first;
  out += '\n';
  for (std::size_t k = 0; k < paths.size(); ++k)
    for (std::size_t i = 0; i < paths[k].points.size(); ++i) {
      if (paths.size() > 1) out += fmt::format("{},", k + 1);
      out += number_text(paths[k].points[i].x) + "," + number_text(paths[k].points[i].y);
      for (const auto& column : paths[k].columns) out += "," + number_text(column.second[i]);
      out += '\n';
    }
  return out;
}

}  // namespace taut
