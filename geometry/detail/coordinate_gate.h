// Which numbers may enter a World.
#pragma once

#include <cmath>
#include <string>

#include <taut/geometry/errors.h>
#include <taut/geometry/point.h>
#include <taut/geometry/text.h>
#include <taut/geometry/world.h>

namespace taut::detail {

/// Throws InputErrors about one line of one source: coordinates that no World takes.
class CoordinateGate {
 public:
  CoordinateGate(const std::string& source, int line) : source_(source), line_(line) {}

  void admit(double value) const {
    if (!(std::abs(value) <= World::kLargest)) refuse(value);
    if (value != 0 && std::abs(value) < World::kSmallest) refuse_small(value);
  }
  void admit(Point p) const {
    admit(p.x);
    admit(p.y);
  }
  void admit(const Ring& ring) const {
    for (Point p : ring) admit(p);
  }
  void admit(const Polygon& polygon) const {
    admit(polygon.outer);
    for (const Ring& hole : polygon.holes) admit(hole);
  }
  void admit_thickness(double t) const {
    admit(t);
    if (t < 0) throw InputError(source_, line_, "wall thickness " + text(t) + " is negative");
  }

 private:
  [[noreturn]] void refuse(double value) const {
    const char* why = std::isfinite(value) ? " is beyond " : " is not a finite number";
    throw InputError(source_, line_,
                     "coordinate " + text(value) + why + (std::isfinite(value) ? text(World::kLargest) : ""));
  }

  [[noreturn]] void refuse_small(double value) const {
    throw InputError(source_, line_,
                     "coordinate " + text(value) + " is nearer to 0 than " + text(World::kSmallest) +
                         ": write the world in a smaller unit");
  }

  const std::string& source_;
  int line_;
};

}  // namespace taut::detail
