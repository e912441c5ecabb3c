#include <taut/io/worlds/geographic_world.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <taut/geometry/box.h>
#include <taut/geometry/noded_parts.h>
#include <taut/geometry/text.h>
#include <taut/geometry/written.h>

namespace taut {

namespace {

// WGS 84.
constexpr double kAxis = 6378137, kFlattening = 1 / 298.257223563, kSquare = kFlattening * (2 - kFlattening);
constexpr double kRadians = std::numbers::pi / 180;

/// Metres a degree, east and north, at a latitude.
Point metres_a_degree_at(double latitude) {
  const double sine = std::sin(latitude * kRadians), w = 1 - kSquare * sine * sine;
  return {kAxis / std::sqrt(w) * std::cos(latitude * kRadians) * kRadians,
          kAxis * (1 - kSquare) / (w * std::sqrt(w)) * kRadians};
}

template <typename Visit>
void for_each_place(const WorldParts& parts, Visit&& visit) {
  for (const Wall& wall : parts.walls)
    for (const Point p : {wall.a, wall.b}) visit(p, wall.line);
  for (const auto* areas : {&parts.areas, &parts.solids})
    for (const Area& area : *areas) {
      for (const Point p : area.polygon.outer) visit(p, area.line);
      for (const Ring& hole : area.polygon.holes)
        for (const Point p : hole) visit(p, area.line);
    }
}

template <typename Change>
void change_places(WorldParts& parts, Change&& change) {
  const auto change_all = [&](Ring& ring) {
    for (Point& p : ring) p = change(p);
  };
  for (Wall& wall : parts.walls) {
    wall.a = change(wall.a);
    wall.b = change(wall.b);
  }
  for (auto* areas : {&parts.areas, &parts.solids})
    for (Area& area : *areas) {
      change_all(area.polygon.outer);
      for (Ring& hole : area.polygon.holes) change_all(hole);
    }
  if (parts.start) parts.start = change(*parts.start);
  if (parts.goal.point) parts.goal.point = change(*parts.goal.point);
  for (Box& box : parts.goal.room) box = {change(box.min), change(box.max)};
}

std::vector<Point> places_of(const WorldParts& parts) {
  std::vector<Point> places;
  for_each_place(parts, [&](Point p, int) { places.push_back(p); });
  return places;
}

Box widened(const Box& box, Point p) {
  return {{std::min(box.min.x, p.x), std::min(box.min.y, p.y)}, {std::max(box.max.x, p.x), std::max(box.max.y, p.y)}};
}

bool holds(const Box& box, Point p, double margin) {
  return box.min.x - margin <= p.x && p.x <= box.max.x + margin && box.min.y - margin <= p.y &&
         p.y <= box.max.y + margin;
}

double rounded(double v, int places) { return written::number(std::llround(v * std::pow(10, places)), places); }

}  // namespace

bool is_lon_lat(Point p) { return std::abs(p.x) <= 180 && std::abs(p.y) <= 90; }

void require_lon_lat(const WorldParts& parts) {
  const auto require = [&](Point p, int line) {
    if (!is_lon_lat(p))
      throw InputError(parts.source, line, taut::text(p) + " is no longitude and latitude, which --project is for");
  };
  for_each_place(parts, require);
  if (parts.start) require(*parts.start, 0);
  if (parts.goal.point) require(*parts.goal.point, 0);
  for (const Box& box : parts.goal.room) {
    require(box.min, 0);
    require(box.max, 0);
  }
}

GeographicWorld::GeographicWorld(WorldParts degrees) : degrees_(std::move(degrees)) {
  require_lon_lat(degrees_);
  const std::vector<Point> places = places_of(degrees_);
  if (places.empty()) throw InputError(degrees_.source, 0, "has no wall or polygon to project");
  box_ = box_around(places);
  const double width = box_.max.x - box_.min.x;
  if (width > kWidest)
    throw InputError(
        degrees_.source, 0,
        fmt::format("reaches over {:.6g} degrees of longitude, more than --project can take ({})", width, kWidest));
  centre_ = {rounded(box_.min.x + width / 2, 9), rounded(box_.min.y + (box_.max.y - box_.min.y) / 2, 9)};
  scale_ = metres_a_degree_at(centre_.y);
  error_ = error_within(box_);
  if (!(error_ <= kLargestError))
    throw InputError(degrees_.source, 0,
                     fmt::format("is too large for --project: lengths would be off by up to {:.2g} %", 100 * error_));
  const double largest = std::max(width * scale_.x, (box_.max.y - box_.min.y) * scale_.y) / 2;
  places_ = std::clamp(14 - static_cast<int>(std::ceil(std::log10(largest + 1))), 0, 9);
  degree_places_ = std::min(12, static_cast<int>(std::floor(-std::log10(2 * unit() / std::min(scale_.x, scale_.y)))));
  for (const Point p : places_of(noded(degrees_))) corners_.emplace_back(metres(p), p);
  std::sort(corners_.begin(), corners_.end());
  corners_.erase(
      std::unique(corners_.begin(), corners_.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
      corners_.end());
}

double GeographicWorld::unit() const { return std::pow(10, -places_); }

double GeographicWorld::rounding() const {
  // A longitude in doubles is off by 2^-53 of itself, and so are centre and difference.
  const double largest =
      std::max({std::abs(box_.min.x), std::abs(box_.min.y), std::abs(box_.max.x), std::abs(box_.max.y)});
  return unit() + 3 * 0x1p-53 * largest * std::max(scale_.x, scale_.y);
}

WorldParts GeographicWorld::in_metres(std::span<const Point> ends) const {
  WorldParts parts = noded(degrees_, ends);
  change_places(parts, [&](Point p) { return metres(p); });
  parts.grid.reset();
  parts.uncertainty = parts.uncertainty * std::max(scale_.x, scale_.y) + rounding();
  return parts;
}

Point GeographicWorld::metres(Point p) const {
  return {rounded((p.x - centre_.x) * scale_.x, places_), rounded((p.y - centre_.y) * scale_.y, places_)};
}

Point GeographicWorld::lon_lat(Point p) const {
  const auto known = std::lower_bound(corners_.begin(), corners_.end(), p,
                                      [](const auto& corner, Point q) { return corner.first < q; });
  if (known != corners_.end() && known->first == p) return known->second;
  return {rounded(centre_.x + p.x / scale_.x, degree_places_), rounded(centre_.y + p.y / scale_.y, degree_places_)};
}

void GeographicWorld::require_end(Point p, const std::string& role) const {
  const auto refuse = [&](const std::string& why) {
    throw InputError(degrees_.source, 0, role + " " + taut::text(p) + " " + why);
  };
  const Point swapped{p.y, p.x};
  if (!holds(box_, p, 1) && is_lon_lat(swapped) && holds(box_, swapped, 0))
    refuse("is far from the world, which holds " + taut::text(swapped) + ": longitude comes first");
  if (!is_lon_lat(p)) refuse("is no longitude and latitude");
  if (!(error_within(widened(box_, p)) <= kLargestError)) refuse("is too far from the world for --project");
}

/// Lengths of degrees change steadily with the latitude on either side of the equator, so their extremes are among
/// those at the ends and there. A line straight in degrees bends by at most 2.1 tan(latitude) / radius, and a curve of
/// length s that bends by k is longer than the geodesic between its ends by less than (k s)^2 / 12 of itself.
double GeographicWorld::error_within(const Box& box) const {
  std::vector<double> latitudes{box.min.y, box.max.y};
  if (box.min.y < 0 && box.max.y > 0) latitudes.push_back(0);
  double error = 0;
  for (const double latitude : latitudes) {
    const Point there = metres_a_degree_at(latitude);
    error = std::max({error, std::abs(there.x / scale_.x - 1), std::abs(there.y / scale_.y - 1)});
  }
  const double steepest = std::max(std::abs(box.min.y), std::abs(box.max.y)) * kRadians;
  const double diagonal =
      (1 + error) * std::hypot((box.max.x - box.min.x) * scale_.x, (box.max.y - box.min.y) * scale_.y);
  const double bend = 2.1 * std::tan(steepest) / (kAxis * (1 - kSquare)) * diagonal;
  return error + bend * bend / 12;
}

double GeographicWorld::length_error(std::span<const Point> points, double length) const {
  if (points.empty()) return 0;
  return error_within(box_around(points)) * length + 3 * rounding() * static_cast<double>(points.size());
}

std::string GeographicWorld::text() const {
  return fmt::format("planned in metres about {}; lengths are within {:.2g} % of those on the ellipsoid WGS 84",
                     taut::text(centre_), 100 * error_);
}

bool looks_like_degrees(const WorldParts& parts) {
  const std::vector<Point> places = places_of(parts);
  if (places.empty() || !std::all_of(places.begin(), places.end(), is_lon_lat)) return false;
  const Box box = box_around(places);
  const double extent = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  if (!(extent < 1)) return false;
  const auto from_zero = [](double low, double high) { return low > 0 ? low : high < 0 ? -high : 0; };
  const double away = std::max(from_zero(box.min.x, box.max.x), from_zero(box.min.y, box.max.y));
  if (away <= 10 * extent) return false;
  std::size_t fine = 0;
  for (const Point p : places)
    for (const double v : {p.x, p.y}) {
      const std::optional<written::Decimal> decimal = written::decimal(v);
      fine += !decimal || decimal->places >= 4;
    }
  return fine >= places.size();
}

}  // namespace taut
