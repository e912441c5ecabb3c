#include <taut/io/results/report.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include <taut/io/results/detail/report_table.h>
#include <taut/io/results/words.h>

namespace taut {

namespace {

using detail::columns_of;
using detail::member;

bool holds_objects(const Json& json) {
  const Json::Array* items = json.items();
  return items && !items->empty() && std::ranges::all_of(*items, [](const Json& item) { return item.members(); });
}

bool is_scalar(const Json& json) { return !json.items() && !json.members() && !json.is_verbatim(); }

using Front = std::vector<std::pair<std::string, Json>>;

// Adds a member unless one of that name is there.
void add(Json& row, const std::string& name, const Json& value) {
  if (!member(row, name)) row[name] = value;
}

void add_rows(const Json& items, const Front& front, Json& rows) {
  for (const Json& item : *items.items()) {
    const Json* inner = nullptr;
    Front more = front;
    for (const auto& [name, value] : *item.members()) {
      if (value.text() && more.size() == front.size()) more.emplace_back(name, value);
      if (!inner && holds_objects(value)) inner = &value;
    }
    if (inner) {
      add_rows(*inner, more, rows);
      continue;
    }
    Json row = Json::object();
    for (const auto& [name, value] : front) add(row, name, value);
    for (const auto& [name, value] : *item.members())
      if (is_scalar(value)) add(row, name, value);
    rows.push_back(std::move(row));
  }
}

double quantile(const std::vector<double>& sorted, double part) {
  const double at = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Json summary_row(std::string_view by, const std::string& group, const std::string& measure,
                 std::vector<double> values) {
  std::ranges::sort(values);
  double sum = 0;
  for (const double value : values) sum += value;
  Json row = Json::object();
  if (!by.empty()) row[by] = group;
  row["measure"] = measure;
  row["rows"] = values.size();
  row["mean"] = sum / static_cast<double>(values.size());
  row["least"] = values.front();
  row["lower"] = quantile(values, 0.25);
  row["median"] = quantile(values, 0.5);
  row["upper"] = quantile(values, 0.75);
  row["most"] = values.back();
  return row;
}

}  // namespace

Json report_rows(const Json& result) {
  Json rows = Json::array();
  if (!result.members()) return rows;
  for (const auto& [name, value] : *result.members()) {
    if (!holds_objects(value)) continue;
    add_rows(value, {}, rows);
    break;
  }
  return rows;
}

Json report_summary(const Json& rows, std::string_view by) {
  std::vector<std::string> groups;
  std::map<std::pair<std::string, std::string>, std::vector<double>> values;  // by group and measure
  for (const Json& row : *rows.items()) {
    const Json* named = by.empty() ? nullptr : member(row, by);
    const std::string group = named && named->text() ? *named->text() : "";
    if (std::ranges::find(groups, group) == groups.end()) groups.push_back(group);
    for (const auto& [name, value] : *row.members())
      if (const std::optional<double> number = detail::number_of(value)) values[{group, name}].push_back(*number);
  }
  Json summary = Json::array();
  const std::vector<std::string> columns = columns_of(rows);
  for (const std::string& group : groups)
    for (const std::string& measure : columns)
      if (const auto found = values.find({group, measure}); found != values.end())
        summary.push_back(summary_row(by, group, measure, found->second));
  return summary;
}

std::string report_csv(const Json& rows) {
  const std::vector<std::string> columns = columns_of(rows);
  std::string out;
  const auto put = [&](std::size_t i, const std::string& text) { out += (i > 0 ? "," : "") + csv_field(text); };
  for (std::size_t i = 0; i < columns.size(); ++i) put(i, columns[i]);
  out += '\n';
  for (const Json& row : *rows.items()) {
    for (std::size_t i = 0; i < columns.size(); ++i) put(i, detail::cell_text(member(row, columns[i])));
    out += '\n';
  }
  return out;
}

}  // namespace taut
