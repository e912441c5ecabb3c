#include <taut/io/results/detail/report_table.h>

#include <algorithm>
#include <charconv>

namespace taut::detail {

const Json* member(const Json& row, std::string_view name) {
  for (const auto& [other, value] : *row.members())
    if (other == name) return &value;
  return nullptr;
}

std::vector<std::string> columns_of(const Json& rows) {
  std::vector<std::string> columns;
  for (const Json& row : *rows.items())
    for (const auto& [name, value] : *row.members())
      if (std::ranges::find(columns, name) == columns.end()) columns.push_back(name);
  return columns;
}

std::optional<double> number_of(const Json& value) {
  if (const bool* truth = value.truth()) return *truth ? 1 : 0;
  if (value.is_null() || value.text() || value.items() || value.members()) return {};
  const std::string text = json_line(value);
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ec == std::errc() ? std::optional(number) : std::nullopt;
}

std::string cell_text(const Json* value) {
  if (!value || value->is_null()) return {};
  if (const bool* truth = value->truth()) return *truth ? "1" : "0";
  return value->text() ? *value->text() : json_line(*value);
}

}  // namespace taut::detail
