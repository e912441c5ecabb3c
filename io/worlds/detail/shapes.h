// What wkt and geojson have in common: polygons, lines and points that become a World.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <taut/geometry/world.h>
#include <taut/io/worlds/detail/doors.h>
#include <taut/io/worlds/detail/text_input.h>
#include <taut/io/worlds/read_world.h>

namespace taut::detail {

/// Collects shapes. Each function throws InputError at the place of a shape that cannot be used.
class Shapes {
 public:
  explicit Shapes(const ReadOptions& options)
      : source_(options.source),
        as_(options.polygons),
        thickness_(options.wall_thickness),
        closes_(options.crossings == Crossings::even_odd),
        snap_(options.snap) {
    // In degrees only what lies within rounding is joined.
    if (options.project && snap_.what != Snap::What::nothing) snap_ = {};
    parts_.source = source_;
  }

  /// A ring as these formats write it: its last point is its first, and is cut off. Any other is closed, if the options
  /// say so; one of fewer than 3 points has no area anyway.
  Ring ring(Ring written, int line);

  /// A polygon without a role: ReadOptions decides.
  void add_polygon(Polygon polygon, int line);
  void add_free(Polygon polygon, int line);
  void add_solid(Polygon polygon, int line);

  /// Each leg a wall; at least two points. ReadOptions may know better how thick: doors are as wide as drawn.
  void add_walls(const Ring& chain, double thickness, int line);

  /// A point that says nothing of itself: see take().
  void add_point(Point p);
  /// Each leg takes away what it covers of the walls that it lies on.
  void add_door(const Ring& chain);
  void set_start(Point p, int line);
  void set_goal(Point p, int line);
  void add_goal_box(const Polygon& polygon, int line);

  /// Floor plans (the default) or limits.
  void set_boundary(Boundary boundary) { boundary_ = boundary; }

  /// Of points that say nothing of themselves, when there are no ends: are two start and goal, is one the start?
  enum class Alone { two, one_or_two };
  /// All of it, rings as they were given. Other points that say nothing of themselves are left out, with a remark, as
  /// are doors that lie on no wall.
  WorldParts take(Alone ends, ReadNotes& notes);

 private:
  SourceLine at(int line) const { return {source_, line}; }
  Beside beside_walls() const;

  std::string source_;
  ReadOptions::Polygons as_;
  std::optional<double> thickness_;  // of all walls, whatever they say
  bool closes_;
  Snap snap_;
  Boundary boundary_ = Boundary::walled;
  WorldParts parts_;
  std::vector<Area> nested_;  // polygons that count by the even-odd rule
  std::vector<std::string> unclosed_;
  std::vector<Point> points_;
  std::vector<Segment> doors_;
};

}  // namespace taut::detail
