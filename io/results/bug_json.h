// A bug's journey as JSON.
#pragma once

#include <optional>

#include <taut/geometry/length.h>
#include <taut/io/results/json.h>
#include <taut/robots/bug/bug.h>

namespace taut::bug {

/// The length of the journey by that of the shortest path; nothing without either or when both are 0.
std::optional<double> ratio_of(const Journey& journey, const std::optional<Length>& shortest);

/// `algorithm`, `turn`, `range` (tangent; `inf`), `start`, `goal`, `length`, `shortest` and `ratio` (where there is a
/// path), `bound`, `rounding`, `hits`, `minima` (tangent) and `leaves` of {point, distance, obstacle}, `obstacles` of
/// {perimeter, hits, ...}, `path`.
Json bug_json(const Journey& journey, const Options& options, Point start, Point goal,
              const std::optional<Length>& shortest);

}  // namespace taut::bug
