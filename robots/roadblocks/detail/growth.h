// How a tree grows towards a sample, in time or against it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <taut/robots/roadblocks/detail/tree_search.h>

namespace taut::roadblocks::detail {

/// What is known of a node's motions, one bit each.
struct Reach {
  std::uint32_t taken = 0;
  std::optional<std::uint32_t> clear;  ///< once it was asked
};

/// A branch: a clear motion, and the pose at its far end.
struct Branch {
  Pose end;
  std::span<const double> controls;  ///< valid as long as the Growth
};

/// Growth guided by reachability (Shkolnik, Walter, Tedrake, 2009): a node has eight motions, straight ahead and back,
/// four arcs, the turn on the spot to both sides. It grows towards a sample by the one that ends nearest to it, if that
/// is nearer than the node itself; a sample that is not so reachable is dropped.
class Growth {
 public:
  enum class Time : std::uint8_t { forwards, backwards };

  /// `backwards`: the motions are those by which a car comes to the node; a branch ends where it begins to drive them.
  Growth(const TreeRoom& room, Time time);

  std::optional<Branch> towards(const Pose& sample, const Pose& node, Reach& reach) const;

 private:
  std::optional<Pose> end_of_clear(const Pose& node, std::span<const double> controls, std::size_t& steps) const;
  std::uint32_t clear_motions(const Pose& node) const;
  Pose end_of(const Pose& node, std::span<const double> controls) const;

  const TreeRoom& room_;
  Time time_;
  std::vector<std::vector<double>> motions_;
};

inline constexpr std::uint32_t kRoot = ~0U;  ///< the parent of a tree's first node

/// All controls from the root to a node, whose `controls` lead to it from `parent`.
template <typename Node>
std::vector<double> controls_to(const std::vector<Node>& nodes, std::uint32_t last) {
  std::vector<std::uint32_t> way;
  for (std::uint32_t n = last; n != kRoot; n = nodes[n].parent) way.push_back(n);
  std::vector<double> all;
  for (std::size_t i = way.size(); i-- > 0;)
    all.insert(all.end(), nodes[way[i]].controls.begin(), nodes[way[i]].controls.end());
  return all;
}

}  // namespace taut::roadblocks::detail
