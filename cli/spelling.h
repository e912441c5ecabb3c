// Words that were meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace taut::cli {

/// The one of `names` that takes the fewest letters added, left out, replaced or exchanged with the next to become
/// `text`, a third of its length and one at most; else one that `text` begins with, or that begins with it, of three
/// letters or more. Of several the first; empty where there is none.
std::string_view nearest_name(std::string_view text, const std::vector<std::string_view>& names);

/// `; did you mean 'solve'?` of the nearest, or nothing.
std::string meant(std::string_view text, const std::vector<std::string_view>& names);

}  // namespace taut::cli
