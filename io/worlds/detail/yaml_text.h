// What has to hold before yaml-cpp takes a file apart.
#pragma once

#include <string>
#include <string_view>

namespace taut::detail {

/// The bytes as text that yaml-cpp comes to the end of. Throws YAML::ParserException where it would not: it begins one
/// document after the other at a place that it cannot pass (a comma behind a text in quotes, a byte 0).
std::string yaml_text(std::string_view bytes);

}  // namespace taut::detail
