// Poses of a tree, found by nearness.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <taut/robots/roadblocks/car.h>

namespace taut::roadblocks::detail {

/// An r-tree of poses as points (x, y, kArm cos heading, kArm sin heading): the distance is that of the centres and of
/// tips kArm ahead, so that whole turns do not count. Same calls, same answers.
class PoseIndex {
 public:
  PoseIndex();
  ~PoseIndex();
  PoseIndex(PoseIndex&&) noexcept;

  void insert(const Pose& pose, std::uint32_t which);
  void erase(const Pose& pose, std::uint32_t which);
  std::uint32_t nearest(const Pose& pose) const;                           ///< precondition: not empty
  std::vector<std::uint32_t> nearest(const Pose& pose, unsigned n) const;  ///< at most n, by distance, then by number

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

inline constexpr double kArm = 2.0;

double distance(const Pose& a, const Pose& b);  ///< as above

}  // namespace taut::roadblocks::detail
