// A request, read.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/io/results/json.h>

namespace taut::web {

/// A member that is absent or null is nothing; one of the wrong kind is an InputError that names it.
class Request {
 public:
  explicit Request(std::string_view json);
  ~Request();

  std::optional<std::string> text(const char* key) const;
  std::optional<double> number(const char* key) const;
  std::optional<int> count(const char* key, int most) const;
  std::optional<Point> point(const char* key) const;
  std::optional<std::vector<double>> numbers(const char* key) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

std::string from_base64(std::string_view text);  ///< throws InputError
std::string to_base64(std::string_view bytes);

/// A flat list of millions.
class Flat {
 public:
  Flat& operator<<(double value);
  Flat& operator<<(Point p) { return *this << p.x << p.y; }
  Flat& operator<<(const Segment& s) { return *this << s.a << s.b; }
  Json json() { return Json::verbatim(text_.empty() ? "[]" : text_ + "]"); }

 private:
  std::string text_;
};

Json flat(std::span<const Point> points);
Json flat(std::span<const Segment> segments);

}  // namespace taut::web
