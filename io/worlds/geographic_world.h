// Longitude and latitude, planned in metres.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/geometry/world.h>

namespace taut {

/// A world in degrees, x the longitude and y the latitude (WGS 84), and its image in a plane of metres.
///
///  1. The plane: a degree of longitude and one of latitude have everywhere the lengths that they have at the middle of
///     the box around walls and polygons (local equirectangular). That keeps straight lines straight, as GeoJSON has
///     them in degrees, so nothing that is near to a wall comes to its other side.
///  2. Contacts stay: walls and rings are given corners in degrees wherever they meet (noded_parts.h), then each corner
///     is projected and rounded to `unit()`, a nanometre for worlds of up to 100 km. Equal coordinates stay equal.
///  3. Every length in the plane is within relative_error() of that on the ellipsoid. It grows with the extent in
///     latitude: about tan(latitude) times half of it in radians.
///  4. lon_lat(metres(p)) is p for every corner of the world, and for every p with at most 12 decimals, fewer where the
///     unit is coarser or within a degree of a pole.
/// Thicknesses are metres already. Immutable.
class GeographicWorld {
 public:
  static constexpr double kLargestError = 0.01;  ///< relative; a world where lengths are off by more is refused
  static constexpr double kWidest = 90;          ///< degrees of longitude

  /// Throws InputError where a coordinate is no longitude and latitude, the world has no place at all, is too wide, or
  /// its error too large.
  explicit GeographicWorld(WorldParts degrees);

  /// In metres; what touches one of `ends`, which are longitude and latitude, still does.
  WorldParts in_metres(std::span<const Point> ends = {}) const;

  Point metres(Point lon_lat) const;
  Point lon_lat(Point metres) const;
  Segment lon_lat(const Segment& metres) const { return {lon_lat(metres.a), lon_lat(metres.b)}; }

  /// Throws InputError when `p` is no longitude and latitude, or is one only if swapped, or is so far from the world
  /// that lengths would be off by more than kLargestError. `role` begins the message: `start`.
  void require_end(Point p, const std::string& role) const;

  Point centre() const { return centre_; }          ///< longitude and latitude of (0, 0)
  Point metres_a_degree() const { return scale_; }  ///< east, north
  double unit() const;                              ///< metres
  double relative_error() const { return error_; }  ///< of lengths in the world
  /// How far in metres the length of such a path may be from that of the path on the ellipsoid with the same corners,
  /// by geodesics or by lines straight in degrees.
  double length_error(std::span<const Point> lon_lat, double length) const;

  /// `planned in metres about (13.4, 52.5); lengths are within 0.0012 % of those on the ellipsoid WGS 84`
  std::string text() const;

 private:
  double error_within(const Box& degrees) const;
  double rounding() const;  // of a projected coordinate

  WorldParts degrees_;
  Box box_;
  Point centre_;
  Point scale_;
  int places_ = 9;  // decimals of metres
  int degree_places_ = 12;
  double error_ = 0;
  std::vector<std::pair<Point, Point>> corners_;  // in metres, ordered, and as they were written
};

/// Longitude and latitude, in this order?
bool is_lon_lat(Point p);
/// Throws InputError, with the line, where a coordinate is none.
void require_lon_lat(const WorldParts& parts);

/// Do these numbers look like longitude and latitude that nobody marked as such? Only when all of them are in range,
/// the extent is below one degree, the box is farther from the origin than ten times the extent, and at least half of
/// the coordinates were written with four decimals or more. When in doubt no.
bool looks_like_degrees(const WorldParts& parts);

}  // namespace taut
