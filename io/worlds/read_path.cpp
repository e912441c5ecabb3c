#include <taut/io/worlds/read_path.h>

#include <cmath>

#include <taut/geometry/world.h>
#include <taut/io/worlds/detail/json_tree.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut {

namespace {

using detail::JsonTree;
using detail::Place;

double coordinate_of(const JsonTree& json, const std::string& source) {
  const Place place{source, json.line};
  if (json.kind != JsonTree::Kind::number) place.fail("a coordinate is no number");
  if (!(std::abs(json.number) <= World::kLargest)) place.fail("a coordinate is beyond 1e+75");
  return json.number;
}

Point point_of(const JsonTree& json, const std::string& source) {
  if (json.kind != JsonTree::Kind::array || json.items.size() != 2)
    Place{source, json.line}.fail("a point is not written as [x, y]");
  return {coordinate_of(json.items[0], source), coordinate_of(json.items[1], source)};
}

ClaimedPath read_json(std::string_view bytes, const std::string& source) {
  const JsonTree file = detail::parse_json(bytes, source);
  const JsonTree* const result = file.kind == JsonTree::Kind::object ? file.find("result") : nullptr;
  const JsonTree& json = result ? *result : file;
  const JsonTree* points = json.kind == JsonTree::Kind::object ? json.find("points") : &json;
  if (!points || points->kind == JsonTree::Kind::null)
    Place{source, json.line}.fail("holds no path: there are no \"points\"");
  if (points->kind != JsonTree::Kind::array) Place{source, points->line}.fail("the points are not a list");
  ClaimedPath path;
  for (const JsonTree& item : points->items) path.points.push_back(point_of(item, source));
  if (const JsonTree* length = json.find("length"); length && length->kind == JsonTree::Kind::number)
    path.length = length->number;
  return path;
}

ClaimedPath read_lines(std::string_view bytes, const std::string& source) {
  ClaimedPath path;
  for (detail::Lines lines(bytes); lines.next();) {
    const std::string_view line = detail::trimmed(lines.line().substr(0, lines.line().find('#')));
    if (line.empty()) continue;
    const Place place{source, lines.number()};
    std::vector<double> values;
    detail::Fields fields(line, place);
    for (std::string_view field; fields.next(field);) values.push_back(detail::coordinate(field, place));
    if (values.size() != 2) place.fail("a point is two numbers, not " + std::to_string(values.size()));
    path.points.push_back({values[0], values[1]});
  }
  return path;
}

}  // namespace

ClaimedPath read_path(std::string_view bytes, const std::string& source) {
  const std::string_view text = detail::trimmed(detail::stripped(bytes));
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) throw InputError(source, 0, "file is empty");
  return text[first] == '{' || text[first] == '[' ? read_json(bytes, source) : read_lines(bytes, source);
}

}  // namespace taut
