// Where the robot's reference point may be.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <taut/geometry/footprint.h>
#include <taut/geometry/point.h>
#include <taut/geometry/triangulation.h>
#include <taut/geometry/world.h>

namespace taut {

class CellPlan;

/// A piece of what stops a path: part of an obstacle's outline or of a zero-thickness wall. Pieces meet only at end
/// points.
struct Constraint {
  Point a;
  Point b;
  bool solid_left = false;     ///< to the left of a -> b lies an obstacle's inside
  bool solid_right = false;    ///< likewise; never both
  std::uint32_t wall = kNone;  ///< a World wall it came from, when one is known

  bool is_wall() const { return !solid_left && !solid_right; }
};

/// Where a point lies in the triangulation.
struct Location {
  enum class Kind {
    outside,   ///< beyond the world's areas, or inside an obstacle; no path can be there
    triangle,  ///< in the interior of a free triangle, or on an unconstrained side of one
    side,      ///< on a constrained side that borders a free triangle, not at its ends
    vertex,    ///< at a vertex of a free triangle
  };
  Kind kind = Kind::outside;
  std::uint32_t triangle = kNone;  ///< a free triangle that contains the point; kNone when outside
  int index = 0;                   ///< the corner opposite to the side, or the corner
};

/// Distance to the nearest obstacle.
struct Clearance {
  double distance = 0;               ///< to the nearest double
  std::uint32_t constraint = kNone;  ///< the nearest piece; the lowest index among equals. kNone: there is none at all
};

/// What is seen from a point.
struct VisibilityPolygon {
  Ring ring;  ///< counter-clockwise; vertices of the triangulation are exact, ends of grazing rays are rounded
  double rounding = 0;  ///< how far a rounded ray end lies from the exact one at most
};

/// What building a FreeSpace did to the numbers.
struct FreeSpaceReport {
  std::size_t crossings = 0;  ///< points constructed because pieces crossed or touched
  double displacement = 0;    ///< the largest distance between a constructed point and its exact position
  double seconds_union = 0;
  double seconds_triangulation = 0;
};

/// An immutable set of the positions a Footprint can take in a World: closed polygons with holes, minus the
/// zero-thickness walls (as constraints), and a constrained Delaunay triangulation of both.
///
///  1. Obstacles are the solids, the walls with a thickness, and with a footprint all walls and Boundary::walled
///     outlines, each Minkowski-summed with the reflected footprint; united exactly, rounded outwards, so none shrinks
///     (but where no double lies between two: to the nearest). report().displacement is what rounding moved at most.
///  2. polygons() is the closure of what is left; two free regions, or parts of one, that touch in a point are
///     not connected there.
///  3. Zero-thickness walls of a point robot are constraints, split where they meet. A crossing that is no pair of
///     doubles is rounded to the nearest decimals, so a wall may bend there by report().displacement.
///  4. Numbers mean what was written (written.h), rounding is to the finest decimals that leave 15 digits. A wall or
///     an outline that bends at a rounded crossing still passes through the world's start and goal, and those of
///     `places`, that lie on it as written.
/// Throws InputError when walls meet at angles so sharp that rounding finds no end. O((n + k) log n) for n input edges
/// with k contacts. Where cells() can answer for a while, pieces and triangles are made when they are first asked for.
class FreeSpace {
 public:
  /// `places`: further points that will be asked about, see 4.
  explicit FreeSpace(World world, Footprint footprint = Footprint::point(), std::span<const Point> places = {});

  const World& world() const;
  const Footprint& footprint() const;
  const FreeSpaceReport& report() const;
  double displacement() const;  ///< report().displacement, and nothing is made for it

  /// Of a point robot among walls on a raster: the free space as cells, made at once. nullptr: there are none.
  const CellPlan* cells() const;
  /// Are pieces and triangles there, or would the next question make them?
  bool is_triangulated() const;

  /// Outer rings counter-clockwise, holes clockwise, in a canonical order (by smallest vertex).
  const std::vector<Polygon>& polygons() const;
  /// Everything that stops a path, pieces in a canonical order.
  const std::vector<Constraint>& constraints() const;
  const Triangulation& triangulation() const;

  /// Exact; expected O(1) with a grid of hints, O(sqrt n) at worst on usual inputs.
  Location locate(Point p) const;

  /// Can the robot be at p? As locate(p) says it, and nothing is made for it where there are cells.
  bool holds(Point p) const;
  /// Does the free space at p begin in the direction of q? Likewise.
  bool opens_towards(Point p, Point q) const;

  /// Can a path go straight from p to q? Exact: it may touch and run along obstacles, it may not pass a
  /// point where obstacles touch from both sides. False when p or q is outside. O(triangles crossed).
  /// With `towards`, only through the part of the surroundings of p that a straight leg from p to `towards` starts in:
  /// of a p on a wall that is the side of the wall where `towards` lies.
  bool sees(Point p, Point q, std::optional<Point> towards = std::nullopt) const;

  /// Precondition: p is not outside. Exact choice of the nearest piece; expands triangles outward from p.
  Clearance clearance(Point p) const;

  /// Precondition: p is not outside. Of a p on a zero-thickness wall: what both sides see.
  VisibilityPolygon visibility_polygon(Point p) const;

  /// The connected part of free space that a triangle belongs to, numbered from 0; kNone for solid triangles.
  std::uint32_t component(std::uint32_t triangle) const;
  std::uint32_t component_count() const;

  /// Why no path leads from p to q: the closed chain of pieces around the one that the other is not in, in order.
  /// Empty when they are connected. Precondition: neither is outside.
  std::vector<Constraint> separation(Point p, Point q) const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace taut
