// Geometries in tables and in hexadecimal.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace taut::detail {

/// Does a geometry in WKT begin here? The word alone decides: `polygon z ((`, `SRID=`.
bool begins_wkt(std::string_view text);

/// Of a table (fields between commas, semicolons, tabs or bars; in double quotes where they hold such, or unquoted)
/// with columns of WKT, found in its first 50 rows: of the one with the most of them, and the first of equals, the same
/// bytes, but blanks in place of all that is not in it, so that lines keep their numbers. Nothing when it is no such
/// table. O(bytes).
struct WktColumn {
  std::string bytes;
  std::size_t number = 0;                ///< of the column, from 1
  std::optional<std::size_t> passed_by;  ///< the first other one that has geometries
};
std::optional<WktColumn> wkt_column(std::string_view bytes);

/// Is this WKB in hexadecimal digits, as PostGIS shows it?
bool is_hex_wkb(std::string_view text);
/// Is one in the first rows of a table, or a line of its own?
bool has_hex_wkb_column(std::string_view bytes);

}  // namespace taut::detail
