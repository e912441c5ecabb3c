// A triangulation on integer places: which triangles hold a place, and does one place see another?
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/geometry/integer_places.h>

namespace taut::detail {

/// The free triangles that hold a place which is no vertex: one, or both beside a side.
struct PlaceAt {
  IntegerPlaces::Place at{};
  std::uint32_t count = 0;
  std::array<std::uint32_t, 2> triangles{kNone, kNone};
  bool is_on_constraint = false;

  bool is_in(std::uint32_t t) const { return t == triangles[0] || t == triangles[1]; }
};

/// Immutable. 4 bytes for two triangles and 8 a vertex.
class IntegerWorld {
 public:
  using Place = IntegerPlaces::Place;

  /// Of a space whose vertices are on `places`.
  IntegerWorld(const FreeSpace& space, const IntegerPlaces& places);

  const IntegerPlaces& places() const { return places_; }
  Place at(std::uint32_t vertex) const { return at_[vertex]; }

  /// False for what is no integer place, a vertex or outside: ask the space.
  bool find(Point p, PlaceAt& place) const;

  enum class Sight { no, yes, unknown };
  /// Unknown where the line passes a vertex, or from a wall along it.
  Sight sees(const PlaceAt& from, const PlaceAt& to) const;

 private:
  std::uint32_t walk(Place p) const;
  std::size_t cell(Place p) const {
    return static_cast<std::size_t>(p[1] >> shift_) * columns_ + static_cast<std::size_t>(p[0] >> shift_);
  }
  int side(std::uint32_t t, int i, Place p) const {
    const auto& corners = tri_.triangles[t];
    return IntegerPlaces::side(at_[corners[Triangulation::ccw(i)]], at_[corners[Triangulation::cw(i)]], p);
  }

  FreeSpace space_;
  const Triangulation& tri_;
  IntegerPlaces places_;
  std::vector<Place> at_;  // by vertex
  int shift_ = 0;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> hints_;
};

}  // namespace taut::detail
