// The core of a hierarchy, side by side, and distances from a few of its nodes. Private.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/search/detail/arc_hierarchy.h>

namespace taut::detail {

/// For a landmark l, a node n and the goal g: d(l, g) <= d(l, n) + d(n, g). And a way from n to an exit e, turned,
/// leads from the turned e to the turned n: d(l, turned n) <= d(l, turned e) + d(n, e).
/// (ALT: Goldberg and Harrelson, 2005.)
class ArcCore {
 public:
  static constexpr std::size_t kLandmarks = 8;

  struct Edge {
    std::uint32_t to;
    double length;
  };

  explicit ArcCore(const ArcHierarchy& hierarchy);

  std::size_t size() const { return node_.size(); }
  std::uint32_t number(std::uint32_t node) const { return number_[node]; }  ///< in the core; kNone
  std::uint32_t node(std::uint32_t i) const { return node_[i]; }
  std::uint32_t turned(std::uint32_t i) const { return turned_[i]; }
  /// As the hierarchy's, in the same order.
  std::span<const Edge> edges(std::uint32_t i) const {
    return std::span(edges_).subspan(first_[i], first_[i + 1] - first_[i]);
  }

  /// For the queries to come: the nodes of the core (by number) from which the goal is reached without passing others.
  void aim(std::span<const ArcDoor> exits);
  /// Not more than what is left from a node of the core to the goal, rounding included.
  double least(std::uint32_t i) const;

 private:
  using Distances = std::array<double, kLandmarks>;

  void measure(std::uint32_t from, std::size_t landmark);
  std::uint32_t farthest(std::size_t landmarks) const;

  std::vector<std::uint32_t> number_, node_, turned_, first_;
  std::vector<Edge> edges_;
  std::vector<Distances> distance_;  // of the core
  Distances whole_{};                // to the goal
  Distances back_{};                 // the most of a distance to a turned exit, less what is left there
  double rounding_ = 0;              // of a distance, as a share
};

}  // namespace taut::detail
