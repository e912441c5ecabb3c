// Values as they appear in messages and files: shortest text that reads back as the same double, whatever the locale.
#pragma once

#include <charconv>
#include <string>

#include <taut/geometry/grid_maze.h>
#include <taut/geometry/point.h>

namespace taut {

inline void append(std::string& out, double value) {
  char digits[32];
  out.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

inline std::string text(double value) {
  std::string out;
  append(out, value);
  return out;
}

/// `(0.5, 1)`
inline std::string text(Point p) { return "(" + text(p.x) + ", " + text(p.y) + ")"; }

/// `(0.5, 1)-(2, 1)`
inline std::string text(const Segment& s) { return text(s.a) + "-" + text(s.b); }

/// `(3,6)`
inline std::string text(Cell c) { return "(" + std::to_string(c.x) + "," + std::to_string(c.y) + ")"; }

}  // namespace taut
