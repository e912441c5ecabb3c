// The drivers that come with the library.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include <taut/robots/roadblocks/drive.h>
#include <taut/robots/roadblocks/drive_policy.h>
#include <taut/robots/roadblocks/lattice_planner.h>

namespace taut::roadblocks {

///  policy       follows a DrivePolicy: the fewest steps to be expected, or in the worst case
///  optimist     takes unknown roadblocks for open until it sees otherwise
///  pessimist    takes unknown roadblocks for closed while there is another way
///  clairvoyant  is told the sample: the bound that no honest driver is asked to reach
enum class DriverKind : std::uint8_t { policy, optimist, pessimist, clairvoyant };

std::string_view name(DriverKind kind);
std::optional<DriverKind> driver_named(std::string_view word);

/// A driver along `planner`'s plans. `policy` decides whenever a roadblock shows, the others replan when a roadblock of
/// their way shows closed and when one that they avoided shows open.
/// `told` is what a clairvoyant knows: the open roadblocks. `aim` is for `policy`. `planner` must outlive the driver
/// and may be shared by drives on one course.
std::unique_ptr<Driver> make_driver(DriverKind kind, LatticePlanner& planner, RoadblockSet told = 0,
                                    Aim aim = Aim::expected);

/// `policy` for one of many drives, which share what `policy` knows; it must outlive the driver, and drives follow one
/// another.
std::unique_ptr<Driver> make_driver(DrivePolicy& policy, LatticePlanner& planner);

}  // namespace taut::roadblocks
