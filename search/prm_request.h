// What may be wished of a probabilistic roadmap; the rest is up to its kind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <taut/search/prm_planner.h>

namespace taut {

struct PrmRequest {
  std::optional<PrmSampler> sampler{};
  std::optional<PrmConnection> connection{};
  std::optional<double> clearance{};
  std::optional<std::size_t> samples{};
  std::optional<bool> lazy{};  ///< false: all edges at once, as without it
  bool exactly = false;        ///< PrmPlan::exactly
};

/// The plan of the request, with the sampler and connection that the kind has when nothing else was asked for. Where
/// neither samples nor time are limited it gives up after a minute. Once found, a path is refined (PrmPlan::refine, 1)
/// but for lattices, forests and `exactly`.
PrmPlan plan_of(const PrmRequest& request, PrmSampler sampler, std::uint64_t seed, bool is_limited);

}  // namespace taut
