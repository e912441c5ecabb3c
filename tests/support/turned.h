// Worlds as computed coordinates have them: turned by an angle, moved to where a survey's zone may be.
#pragma once

#include <cmath>
#include <cstdlib>
#include <numbers>

#include <taut/geometry/world.h>

namespace taut::test {

class Turn {
 public:
  explicit Turn(double degrees, Point to = {})
      : cos_(std::cos(degrees * std::numbers::pi / 180)), sin_(std::sin(degrees * std::numbers::pi / 180)), to_(to) {}

  Point operator()(Point p) const { return {cos_ * p.x - sin_ * p.y + to_.x, sin_ * p.x + cos_ * p.y + to_.y}; }
  Ring operator()(Ring ring) const {
    for (Point& p : ring) p = (*this)(p);
    return ring;
  }
  WorldParts operator()(WorldParts parts) const {
    for (Wall& wall : parts.walls) wall = {(*this)(wall.a), (*this)(wall.b), wall.thickness, wall.line};
    for (auto* areas : {&parts.areas, &parts.solids})
      for (Area& area : *areas) {
        area.polygon.outer = (*this)(area.polygon.outer);
        for (Ring& hole : area.polygon.holes) hole = (*this)(hole);
      }
    if (parts.start) parts.start = (*this)(*parts.start);
    if (parts.goal.point) parts.goal.point = (*this)(*parts.goal.point);
    return parts;
  }

 private:
  double cos_, sin_;
  Point to_;
};

/// Where a survey may have it.
inline constexpr Point kSurvey{5e5, 5.4e6};

/// How many angles a test turns a world by: so many by default, or what TAUT_TURNS says.
inline int turns(int usual) {
  const char* asked = std::getenv("TAUT_TURNS");
  return asked ? std::atoi(asked) : usual;
}

}  // namespace taut::test
