#include <taut/io/worlds/read_points.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <taut/geometry/world.h>
#include <taut/io/worlds/detail/json_tree.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut {

namespace {

using detail::JsonTree;
using detail::SourceLine;
using Kind = JsonTree::Kind;

// ---- text -----------------------------------------------------------------------------------------------------------

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t comma; (comma = line.find(',')) != std::string_view::npos; line.remove_prefix(comma + 1))
    cells.push_back(detail::trimmed(line.substr(0, comma)));
  cells.push_back(detail::trimmed(line));
  return cells;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Where x and y are among the columns of a table.
struct Columns {
  std::size_t x = 0, y = 0, count = 0;
};

std::optional<Columns> columns_of(std::string_view heading) {
  const std::vector<std::string_view> cells = cells_of(heading);
  const auto find = [&](const char* name) {
    return static_cast<std::size_t>(
        std::find_if(cells.begin(), cells.end(), [&](std::string_view cell) { return lower(cell) == name; }) -
        cells.begin());
  };
  constexpr std::array<std::array<const char*, 2>, 3> kNames{{{"x", "y"}, {"lon", "lat"}, {"longitude", "latitude"}}};
  for (const auto& [x, y] : kNames)
    if (const Columns found{find(x), find(y), cells.size()}; found.x < cells.size() && found.y < cells.size())
      return found;
  return std::nullopt;
}

Point row_of(std::string_view line, const Columns& columns, const SourceLine& place) {
  const std::vector<std::string_view> cells = cells_of(line);
  if (cells.size() != columns.count)
    place.fail("has " + std::to_string(cells.size()) + " columns, the heading " + std::to_string(columns.count));
  return {detail::coordinate(cells[columns.x], place), detail::coordinate(cells[columns.y], place)};
}

Point point_of(std::string_view line, const SourceLine& place) {
  std::vector<double> values;
  detail::Fields fields(line, place);
  for (std::string_view field; fields.next(field);) values.push_back(detail::coordinate(field, place));
  if (values.size() != 2) place.fail("a point is two numbers, not " + std::to_string(values.size()));
  return {values[0], values[1]};
}

std::vector<ReadPoint> read_lines(std::string_view bytes, const std::string& source) {
  std::vector<ReadPoint> points;
  std::optional<Columns> columns;
  bool begun = false;
  for (detail::Lines lines(bytes); lines.next();) {
    const std::string_view line = detail::without_comment(lines.line());
    if (line.empty()) continue;
    if (!std::exchange(begun, true) && (columns = columns_of(line))) continue;
    const SourceLine place{source, lines.number()};
    points.push_back({columns ? row_of(line, *columns, place) : point_of(line, place), lines.number()});
  }
  return points;
}

// ---- JSON -----------------------------------------------------------------------------------------------------------

class JsonPoints {
 public:
  explicit JsonPoints(const std::string& source) : source_(source) {}

  std::vector<ReadPoint> read(const JsonTree& json) {
    if (json.kind == Kind::array)
      add_all(json);
    else
      add_geojson(json);
    return std::move(points_);
  }

 private:
  [[noreturn]] void fail(const JsonTree& at, const std::string& message) const {
    SourceLine{source_, at.line}.fail(message);
  }

  void add_geojson(const JsonTree& json) {
    const JsonTree* const type = json.find("type");
    if (!type || type->kind != Kind::string) fail(json, "is neither a list of points nor GeoJSON");
    if (type->string == "FeatureCollection") return add_members(json, "features");
    if (type->string == "GeometryCollection") return add_members(json, "geometries");
    if (type->string == "Feature") return add_geojson(member(json, "geometry"));
    const JsonTree& coordinates = member(json, "coordinates");
    if (type->string == "Point") return add(coordinates);
    if (type->string == "MultiPoint") return add_all(coordinates);
    fail(json, "a " + detail::printable_name(type->string) + " is no point");
  }

  const JsonTree& member(const JsonTree& json, const char* name) const {
    const JsonTree* const found = json.find(name);
    if (!found) fail(json, std::string("there is no \"") + name + "\"");
    return *found;
  }

  void add_members(const JsonTree& json, const char* name) {
    const JsonTree& list = member(json, name);
    if (list.kind != Kind::array) fail(list, std::string("\"") + name + "\" is no list");
    for (const JsonTree& item : list.items) add_geojson(item);
  }

  void add_all(const JsonTree& list) {
    if (list.kind != Kind::array) fail(list, "the points are not a list");
    for (const JsonTree& item : list.items) add(item);
  }

  void add(const JsonTree& json) {
    if (json.kind != Kind::array || json.items.size() < 2) fail(json, "a point is not written as [x, y]");
    for (std::size_t i = 0; i < 2; ++i) {
      if (json.items[i].kind != Kind::number) fail(json.items[i], "a coordinate is no number");
      if (!(std::abs(json.items[i].number) <= World::kLargest)) fail(json.items[i], "a coordinate is beyond 1e+75");
    }
    points_.push_back({{json.items[0].number + 0.0, json.items[1].number + 0.0}, json.items[1].line});
  }

  const std::string& source_;
  std::vector<ReadPoint> points_;
};

}  // namespace

std::vector<ReadPoint> read_points(std::string_view bytes, const std::string& source) {
  const std::string_view text = detail::stripped(bytes);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) throw InputError(source, 0, "file is empty");
  if (text[first] == '{' || text[first] == '[') return JsonPoints(source).read(detail::parse_json(bytes, source));
  return read_lines(bytes, source);
}

}  // namespace taut
