// Words and keyword arguments that planners and roadmaps take.
#pragma once

#include <taut/geometry/free_space.h>
#include <taut/python/bind.h>
#include <taut/search/roadmap_kinds.h>

namespace taut::python {

/// `seed`, and of a PRM `sampler`, `connection` (`nearest:8`, `visible:8`, `forest:8`, `radius:1.5`, `prm-star`),
/// `clearance`, `samples`, `lazy`, `exactly`. TypeError for any other, ValueError for what they cannot be.
BuildRequest request_of(const py::kwargs& given);

/// ValueError for words that are none.
GraphMethod method_of(const std::string& algorithm, const std::string& heuristic);
const RoadmapKind& kind_named(const std::string& word);

/// What asks of discs stands on the space of a point: ValueError for another, InputError for a radius that is none.
void require_point_robot(const FreeSpace& space);
void require_radius(double r);

inline constexpr const char* kWishes =
    "Of the random ones seed; of a PRM also sampler ('sobol', 'uniform', 'lattice', 'gaussian', 'bridge', "
    "'medial-axis', 'corners'), connection ('nearest:8', 'visible:8', 'forest:8', 'radius:1.5', 'prm-star'), "
    "clearance, samples, lazy, exactly.";

}  // namespace taut::python
