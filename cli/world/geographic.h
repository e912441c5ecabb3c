// Of a world that was projected (--project): what people see in longitude and latitude.
#pragma once

#include <string>
#include <string_view>

#include <taut/geometry/free_space.h>
#include <taut/geometry/nearest_free.h>
#include <taut/io/results/end_moves.h>
#include <taut/io/results/json.h>
#include <taut/io/results/result_json.h>
#include <taut/io/worlds/geographic_world.h>
#include <taut/io/worlds/read_world.h>
#include <taut/search/barrier.h>

namespace taut::cli {

/// Places between plane and globe, as the notes of a world have it: nothing changes where it was not projected.
class Shown {
 public:
  explicit Shown(const ReadNotes& notes) : geographic_(notes.geographic.get()) {}

  explicit operator bool() const { return geographic_ != nullptr; }
  const GeographicWorld* geographic() const { return geographic_; }

  Point operator()(Point p) const { return geographic_ ? geographic_->lon_lat(p) : p; }
  Segment operator()(const Segment& s) const { return {(*this)(s.a), (*this)(s.b)}; }
  Box operator()(const Box& b) const { return {(*this)(b.min), (*this)(b.max)}; }
  Goal operator()(Goal goal) const;
  Barrier operator()(Barrier barrier) const;
  FreePlace operator()(FreePlace place) const;
  template <typename Value>
  std::vector<Value> operator()(std::vector<Value> values) const {
    for (Value& value : values) value = (*this)(value);
    return values;
  }
  EndMove operator()(const EndMove& move) const { return {move.role, (*this)(move.given), (*this)(move.place)}; }
  /// Lengths, clearances and what rounding did stay metres.
  PlanResult operator()(PlanResult result) const;

  /// {"centre": [lon, lat], "metres_a_degree": [east, north], "unit", "relative_error"}; with a path (longitude and
  /// latitude) also "error": how far in metres its length may be from that on the ellipsoid. Null: not projected.
  Json json(const std::vector<Point>& path = {}, double length = 0) const;

 private:
  const GeographicWorld* geographic_;
};

/// As blocked_text and require_free of search/query_ends.h, in what is shown.
std::string blocked_text(const World& world, Point p, std::string_view role, const std::optional<FreePlace>& nearest,
                         const Shown& shown);
void require_free(const FreeSpace& space, Point p, std::string_view role, const Shown& shown);

}  // namespace taut::cli
