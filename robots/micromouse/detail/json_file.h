// JSON files of this folder: speed models and certificates.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace taut::micromouse::detail {

/// The value that `text` is. `what` says what it should be: `certificate`.
/// Throws InputError, naming source and line, when it is not JSON, holds a number beyond doubles, or is nested deeper
/// than `deepest`.
nlohmann::json parse_json(std::string_view text, const std::string& source, const char* what, int deepest);

}  // namespace taut::micromouse::detail
