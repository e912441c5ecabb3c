// Paths in JSON and GeoJSON. Private.
#pragma once

#include <string>
#include <string_view>

#include <taut/io/worlds/read_path.h>

namespace taut::detail {

/// See read_paths().
std::vector<ClaimedPath> read_paths_json(std::string_view bytes, const std::string& source);

}  // namespace taut::detail
