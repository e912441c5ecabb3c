// How long paths of larger discs are at least, from what a smaller disc's graph holds.
#pragma once

#include <memory>

#include <taut/geometry/point.h>
#include <taut/roadmaps/tangent_graph.h>

namespace taut {

/// Let M(w) be the least of (legs + w times the angle turned around corners) over the ways in the graph of a radius.
///
///  1. For any r from that radius on, no path of a disc of radius r is shorter than M(r): the length of the shortest
///     path of one homotopy class is a convex function of the radius, its slope the angle turned, and a class that a
///     disc fits through a smaller one does (docs/all-radii.md).
///  2. M is concave. So between two weights it is at least what lies between their values: two prepared graphs bound
///     all radii between.
/// Not for several threads at once.
class ArcBounds {
 public:
  /// For radii from graph.radius() to `most`. Prepares two hierarchies: some tens of milliseconds for 10^4 corners.
  /// Precondition: most > graph.radius().
  ArcBounds(TangentGraph graph, double most);
  ~ArcBounds();
  ArcBounds(ArcBounds&&) noexcept;
  ArcBounds& operator=(ArcBounds&&) noexcept;

  double least_radius() const;
  double most_radius() const;

  /// No path from s to g of a disc of radius r is shorter, rounding included; infinite only when there is none.
  /// Precondition: least_radius() <= r <= most_radius().
  double length_at_least(double r, Point s, Point g);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut
