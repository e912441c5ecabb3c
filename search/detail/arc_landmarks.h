// What is known beforehand of the ways in a disc's graph: distances from landmarks, and pockets. Private.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/search/detail/arc_walk.h>

namespace taut::detail {

/// A node through which the goal is reached, and how far it is from there.
struct ArcExit {
  std::uint32_t node;
  Interval length;
  std::uint32_t leg;  ///< of the goal's
  bool by_arc;        ///< an arc before that leg
};

class ArcLandmarks {
 public:
  static constexpr std::size_t kLandmarks = 8;

  explicit ArcLandmarks(ArcWalk& walk);

  /// For the queries to come: where the goal is.
  void aim(ArcWalk& walk, std::span<const ArcExit> exits);
  /// Not more than the length of any way from the node to the goal, rounding included; infinite when there is none, or
  /// when all that the node leads to is a pocket without the goal.
  double least(std::uint32_t node) const;

 private:
  using Distances = std::array<double, kLandmarks>;

  /// An exit: how far it is from the landmarks, and from them when it is passed the other way.
  struct Target {
    double length;
    Distances there, turned;
  };

  double least(std::uint32_t node, const Target& target) const;
  void measure(ArcWalk& walk, std::uint32_t from, std::size_t landmark);
  void find_pockets(ArcWalk& walk);
  std::uint32_t turned(std::uint32_t node) const { return round_[node / 2] ? node ^ 1 : node; }
  std::uint32_t farthest(std::size_t landmarks) const;

  std::vector<Distances> distance_;
  std::vector<std::uint8_t> round_;  // of each point
  std::vector<std::uint8_t> pocket_;
  std::vector<std::uint32_t> opened_;  // pockets that lead to the goal: the number of the query
  std::uint32_t query_ = 0;
  std::vector<Target> targets_;
  double rounding_ = 0;  // of a distance, as a share
};

}  // namespace taut::detail
