// The drivers that come with the library.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include <taut/robots/car/drive.h>
#include <taut/robots/car/lattice_planner.h>

namespace taut::car {

///  ours         the way with the fewest expected steps, roadblocks being open with their probabilities (Canadian traveller problem)
///  optimist     takes unknown roadblocks for open until it sees otherwise
///  pessimist    takes unknown roadblocks for closed while there is another way
///  clairvoyant  is told the sample: the bound that no honest driver is asked to reach
enum class DriverKind : std::uint8_t { ours, optimist, pessimist, clairvoyant };

std::string_view name(DriverKind kind);
std::optional<DriverKind> driver_named(std::string_view word);

/// A driver along `planner`'s plans. It replans when a roadblock of its way shows closed and when one that it avoided shows open.
///
/// `ours` compares, whenever it plans, following the way with unknown roadblocks open against the ways that avoid the first roadblock on it:
///
///     V(pose, known) = min(to where the first is seen + p V(there, open) + (1 - p) V(there, closed), V(pose, first avoided))
///
/// where an avoided roadblock stays avoided until it is seen. A branch without any way counts kNoWay steps, so that such risks are taken last. It looks
/// at most kDeepest roadblocks ahead; beyond, unknown ones are taken for open. Where a roadblock is seen on the way without being on it,
/// the estimate ignores it, the drive does not.
/// `told` is what a clairvoyant knows: the open roadblocks. `planner` must outlive the driver and may be shared by drives on one course.
std::unique_ptr<Driver> make_driver(DriverKind kind, LatticePlanner& planner, RoadblockSet told = 0);

inline constexpr double kNoWay = 100'000;
inline constexpr int kDeepest = 4;

}  // namespace taut::car
