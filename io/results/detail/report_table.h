// Arrays of flat objects, looked at as tables.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <taut/io/results/json.h>

namespace taut::detail {

/// The member of that name; nullptr where there is none.
const Json* member(const Json& row, std::string_view name);

/// The names of all members, in the order in which they appear first.
std::vector<std::string> columns_of(const Json& rows);

/// A number, or a truth as 0 or 1.
std::optional<double> number_of(const Json& value);

/// As it stands in a table: no quotes around text, nothing for null, 0 or 1 for a truth.
std::string cell_text(const Json* value);

}  // namespace taut::detail
