// Files that gzip made.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace taut {

/// Do these bytes begin as gzip's do, 1f 8b?
bool is_gzip(std::string_view bytes);

/// What was packed: all members, one after the other, as gzip -d gives it. Throws InputError, with `source`, when the
/// bytes are damaged or cut off, or hold more than `limit` bytes.
std::string gunzip(std::string_view bytes, const std::string& source, std::size_t limit = std::size_t{1} << 30);

}  // namespace taut
