// A meeting with a moving target, as JSON.
#pragma once

#include <optional>

#include <taut/io/results/json.h>
#include <taut/robots/pursuit/interception.h>

namespace taut::pursuit {

/// {"caught", "speed", "start", "target": [[t, x, y], ...], "stays", and of a meeting "time", "time_interval": [lo,
/// hi], "at", "leg", "length", "waits", "path"}.
Json interception_json(const Interception& question, const std::optional<MeetingPlace>& meeting);

}  // namespace taut::pursuit
