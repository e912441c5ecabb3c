// Distances from a few far places: lower bounds where the straight line says little.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/free_space.h>
#include <taut/roadmaps/navmesh.h>

namespace taut::detail {

/// The lengths of the shortest paths from a few bends, the landmarks, to every bend. By the triangle inequality a path
/// from bend b to a goal g is no shorter than |d(L, g) - d(L, b)|, for each landmark L (Goldberg and Harrelson,
/// "Computing the shortest path: A* search meets graph theory", SODA 2005). Landmarks lie as far as possible from each
/// other, in the component that has most bends. Immutable.
///
/// Kept as floats, 4 bytes a bend and landmark; each is off by at most error(). What is not reached is infinitely far.
class Landmarks {
 public:
  /// Takes count + 1 searches over the whole mesh.
  Landmarks(const FreeSpace& space, const Navmesh& mesh, std::size_t count);

  std::size_t count() const { return count_; }
  std::span<const float> distances(std::uint32_t bend) const { return {table_.data() + bend * count_, count_}; }
  double error() const { return error_; }

 private:
  std::size_t count_;
  std::vector<float> table_;  // by bend
  double error_ = 0;
};

/// What the landmarks say of one goal.
class LandmarkBounds {
 public:
  /// `polygons`: those that hold the goal.
  LandmarkBounds(const Landmarks* landmarks, const Navmesh& mesh) : landmarks_(landmarks), mesh_(mesh) {}

  void aim_at(Point goal, std::span<const std::uint32_t> polygons);
  void aim_at_nothing() { is_used_ = false; }

  /// At most the length of a path from a bend to the goal; 0 when nothing is known.
  double rest(std::uint32_t bend) const {
    if (!is_used_) return 0;
    const std::span<const float> d = landmarks_->distances(bend);
    float most = 0;
    for (std::size_t i = 0; i < d.size(); ++i) most = std::max({most, least_[i] - d[i], d[i] - most_[i]});
    return std::max(0.0, static_cast<double>(most) - landmarks_->error());
  }

 private:
  const Landmarks* landmarks_;
  const Navmesh& mesh_;
  bool is_used_ = false;
  std::vector<float> least_, most_;  // of the goal's distance from each landmark
};

}  // namespace taut::detail
