// Other people's planners as drivers, by name: to compare with.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include <taut/robots/roadblocks/drive.h>

namespace taut::roadblocks {

/// All take unknown roadblocks for open and plan again whenever one shows closed (replanning_driver.h).
struct Peer {
  std::string_view name;
  std::string_view about;
  /// `course` must outlive the driver. Only the trees draw: same seed, same drive.
  std::unique_ptr<Driver> (*make)(const Course& course, WallReading reading, std::uint64_t seed);
};

/// `rrt`, `rrt-field`, `rrt-star`, `rrt-connect` (tree_planner.h), `value-iteration` (value_planner.h).
std::span<const Peer> peers();
const Peer* peer_named(std::string_view name);  ///< null: there is none

}  // namespace taut::roadblocks
