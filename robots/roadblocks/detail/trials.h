// Whole policies judged by real drives in the same random worlds.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <taut/robots/roadblocks/lattice_planner.h>
#include <taut/robots/roadblocks/rollout_policy.h>

namespace taut::roadblocks::detail {

/// How RolloutPolicy can decide a drive from end to end.
enum class Whole : std::uint8_t { hope, fear, choose };

/// Steps of a drive in one world after the other.
using Steps = std::vector<double>;

/// Is `bold` to be taken rather than `base`? Of both the same worlds, in the same order.
///  expected: its mean is less, by more than kErrors standard errors that the mean of the differences has in `count`
///            worlds: what that many drives are likely to show.
///  worst:    in none of kParts parts of the worlds its worst is more, in one it is less (or in all as much, and the
///            sum is less).
/// Fewer than kParts worlds say nothing: false.
bool is_better(Aim aim, std::span<const double> bold, std::span<const double> base, std::size_t count);

/// The one to follow, judged in kDraws random worlds, of which those with a way count.
///  1. The better of optimist (hope) and pessimist (fear): the fewest steps, for `Aim::worst` in the worst world. The
///     optimist where no way leads around all roadblocks.
///  2. Choices by rollouts where they are better than that (is_better, `count` being the worlds with a way). Where
///     these are less than kFew, or a standard error more or less would change the answer, it is given by kMore times
///     as many worlds, and `count` stays.
Whole best_whole(LatticePlanner& planner, RolloutPolicy& policy, Aim aim);

inline constexpr std::size_t kDraws = 200;
inline constexpr std::size_t kFew = 20;
inline constexpr std::size_t kMore = 4;
inline constexpr double kErrors = 2;
inline constexpr std::size_t kParts = 4;

}  // namespace taut::roadblocks::detail
