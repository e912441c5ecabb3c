// A micromouse trial in words.
#pragma once

#include <string>

#include <taut/io/results/mouse_json.h>

namespace taut::cli {

/// `source` is the maze's name.
std::string mouse_table(const MouseTrial& trial, const std::string& source);

}  // namespace taut::cli
