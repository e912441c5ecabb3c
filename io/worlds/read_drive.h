// Drives of cars from files, for those who want one checked.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <taut/robots/car/leg.h>

namespace taut {

/// A drive somebody claims.
struct ClaimedDrive {
  std::vector<car::Leg> legs;
  std::optional<car::CarShape> car;  ///< that the file names
  std::optional<double> length;
};

/// Is it JSON with `legs` that have `headings`?
bool holds_drive(std::string_view bytes);

/// The JSON of `taut drive --car`, its `result` or such an object by itself: `legs`, each with `from` and `to` (places,
/// [x, y, ...]), `headings` (two of 0 to 63) and perhaps `backward`; perhaps `car` and `length`. Throws InputError with
/// the line.
ClaimedDrive read_drive(std::string_view bytes, const std::string& source = {});

}  // namespace taut
