// Files that say how fast a mouse is.
#pragma once

#include <string>
#include <string_view>

#include <taut/robots/micromouse/speed_model.h>

namespace taut {

/// Reads JSON: numbers `cell`, `pivot_90`, `pivot_180`; objects `straight` and `diagonal` with `acceleration`,
/// `deceleration`, `top_speed`; object `turns` with an object `{"speed": v, "time": t}` a turn, by name, `time`
/// optional; a string `comment`. What is left out is as in the default. Throws InputError with the line: no JSON,
/// unknown names, values that are not numbers > 0 up to 10^6, turns faster than the straights they join.
micromouse::SpeedModel read_speed_model(std::string_view text, const std::string& source = {});

}  // namespace taut
