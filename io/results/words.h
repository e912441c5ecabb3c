// Words and numbers for people.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <taut/geometry/length.h>
#include <taut/geometry/point.h>

namespace taut {

/// The shortest that reads back the same: `1`, `0.1`.
std::string number_text(double value);

/// `0.004 s`, `1.27 s`, `35.8 s`; `<0.001 s`
std::string seconds_text(double seconds);

/// Six decimals where they say something, else nine digits: `77.262691`, `1.25e-05`.
std::string length_text(const Length& length);

/// `1 wall`, `2 walls`
std::string count_text(std::size_t count, const char* one, const char* many = nullptr);

/// `(0.5, 1)`
std::string point_text(Point p);

/// One `x y` a line, for --path.
std::string points_text(const std::vector<Point>& points);

/// `(0, 1)-(2, 1)`, and of several the first few: `(0, 1)-(2, 1), (2, 1)-(2, 4) and 7 more`
std::string segment_text(const Segment& s);
std::string segments_text(const std::vector<Segment>& segments, std::size_t most);

/// As a field of a CSV row (RFC 4180): in quotes where it has to be.
std::string csv_field(const std::string& text);

/// A file's name without its folder.
std::string title_of(const std::string& source);

}  // namespace taut
