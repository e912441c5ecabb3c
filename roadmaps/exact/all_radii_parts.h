// What AllRadii keeps.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <taut/roadmaps/all_radii.h>
#include <taut/roadmaps/exact/tangent_parts.h>

namespace taut {

/// What stands around a corner, for all radii.
struct SiteRadii {
  /// A direction that a wall forbids on circles larger than half its distance.
  struct Forbidden {
    PlainDirection direction;
    Interval half;  ///< encloses half the distance
    std::uint32_t wall = kNone;
  };
  double reach = 0;                    ///< no leg touches a larger circle
  std::vector<Forbidden> forbidden{};  ///< the nearest first
};

struct AllRadiiParts {
  /// Looks for all legs and their spans.
  explicit AllRadiiParts(const FreeSpace& space, const TellProgress& tell = {});
  /// Of the legs of an earlier one.
  AllRadiiParts(std::shared_ptr<const TangentGround> common, std::vector<TangentName> names,
                std::vector<std::uint32_t> first, std::vector<RadiusSpan> all);

  TangentGraph at_radius(double r) const;

  /// Are the spans those of radius r? Else graphs are built in the plain way.
  bool covers(double r) const { return r >= least_radius && r <= most_radius; }
  /// Is a leg free? And with both ends, when it is. Exact. Precondition: covers(r).
  bool has(std::size_t leg, double r) const;
  FoundTangent tangent(std::size_t leg, double r) const;
  /// What stands around a site's circle.
  void look_around(std::uint32_t site, double r, CircleObstacles& obstacles) const;
  /// The ends of legs at a site, ascending: twice the number of the leg, and one more for its second end.
  std::span<const std::uint32_t> ends_at(std::uint32_t site) const {
    return std::span(ends_).subspan(first_end_[site], first_end_[site + 1] - first_end_[site]);
  }

  std::shared_ptr<const TangentGround> ground;
  double least_radius = 0, most_radius = 0;  ///< what the spans are of
  std::vector<SiteRadii> sites{};
  std::vector<TangentName> legs{};          ///< ascending
  std::vector<std::uint32_t> first_span{};  ///< of each leg
  std::vector<RadiusSpan> spans{};

 private:
  /// From centre to centre, over the square of that.
  struct Vector {
    Interval x, y, squared;
  };

  void find_legs(const TellProgress& tell);
  void measure_legs();

  std::vector<Vector> vectors_{};
  std::vector<std::uint32_t> first_end_{}, ends_{};
};

}  // namespace taut
