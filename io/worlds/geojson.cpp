#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/formats.h>
#include <taut/io/worlds/detail/json_tree.h>
#include <taut/io/worlds/detail/shapes.h>

namespace taut::detail {

namespace {

enum class Role { none, free, obstacle, wall, start, goal, door };

struct Properties {
  Role role = Role::none;
  double thickness = 0;
};

class GeoJson {
 public:
  explicit GeoJson(const ReadOptions& options) : source_(options.source), shapes_(options) {}

  WorldParts read(std::string_view bytes, ReadNotes& notes) {
    for (const JsonTree& root : parse_json_texts(bytes, source_)) {
      read_root(root);
      if (const JsonTree* crs = root.find("crs")) notes.crs = name_of(*crs);
    }
    return shapes_.take(Shapes::Alone::two, notes);
  }

 private:
  [[noreturn]] void fail(const JsonTree& at, const std::string& message) const {
    SourceLine{source_, at.line}.fail(message);
  }

  void read_root(const JsonTree& root) {
    const std::string type = type_of(root);
    if (type == "FeatureCollection") {
      for (const JsonTree& feature : array(root, "features")) read_feature(feature);
    } else if (type == "Feature") {
      read_feature(root);
    } else {
      read_geometry(root, {});
    }
  }

  // {"type": "name", "properties": {"name": "..."}}; RFC 7946 has no such member any more.
  static std::string name_of(const JsonTree& crs) {
    const JsonTree* properties = crs.find("properties");
    const JsonTree* name = properties ? properties->find("name") : nullptr;
    return name && !name->string.empty() ? quoted(name->string) : "in a system without a name";
  }

  std::string type_of(const JsonTree& value) const {
    if (value.kind != JsonTree::Kind::object) fail(value, "a GeoJSON object is expected");
    const JsonTree* type = value.find("type");
    if (!type || type->kind != JsonTree::Kind::string) {
      const bool esri = value.find("rings") || value.find("paths") || value.find("geometryType");
      fail(value, esri ? "is ESRI JSON: ogr2ogr -f GeoJSON makes GeoJSON of it" : "a GeoJSON object without \"type\"");
    }
    return type->string;
  }

  const std::vector<JsonTree>& array(const JsonTree& object, const char* key) const {
    const JsonTree* value = object.find(key);
    if (!value || value->kind != JsonTree::Kind::array) fail(object, fmt::format("\"{}\" is missing or no array", key));
    return value->items;
  }

  void read_feature(const JsonTree& feature) {
    const std::string type = type_of(feature);
    if (type != "Feature") fail(feature, "a Feature is expected, not " + quoted(type));
    const JsonTree* geometry = feature.find("geometry");
    if (!geometry || geometry->kind == JsonTree::Kind::null) return;
    read_geometry(*geometry, properties_of(feature));
  }

  // They are the writer's own: what is none of our words says nothing.
  Properties properties_of(const JsonTree& feature) {
    Properties result;
    const JsonTree* properties = feature.find("properties");
    if (!properties) return result;
    take_properties(*properties, result);
    if (const JsonTree* ours = properties->find("taut")) take_properties(*ours, result);
    return result;
  }

  void take_properties(const JsonTree& properties, Properties& result) {
    if (const JsonTree* role = properties.find("role")) result.role = role_of(*role);
    const JsonTree* thickness = properties.find("thickness");
    if (thickness && thickness->kind == JsonTree::Kind::number && thickness->number >= 0 &&
        thickness->number <= World::kLargest)
      result.thickness = thickness->number;
    const JsonTree* boundary = properties.find("boundary");
    if (!boundary) return;
    if (boundary->string == "limit") shapes_.set_boundary(Boundary::limit);
    if (boundary->string == "walled") shapes_.set_boundary(Boundary::walled);
  }

  static Role role_of(const JsonTree& value) {
    static constexpr std::pair<std::string_view, Role> kRoles[] = {
        {"free", Role::free}, {"obstacle", Role::obstacle}, {"wall", Role::wall},   {"start", Role::start},
        {"goal", Role::goal}, {"door", Role::door},         {"opening", Role::door}};
    for (const auto& [name, role] : kRoles)
      if (value.string == name) return role;
    return Role::none;
  }

  void read_geometry(const JsonTree& geometry, const Properties& p) {
    const std::string type = type_of(geometry);
    const int line = geometry.line;
    if (type == "GeometryCollection") {
      for (const JsonTree& member : array(geometry, "geometries")) read_geometry(member, p);
      return;
    }
    const bool known = type == "Point" || type == "MultiPoint" || type == "LineString" || type == "MultiLineString" ||
                       type == "Polygon" || type == "MultiPolygon";
    if (!known) fail(geometry, "GeoJSON type " + quoted(type) + " is not supported");
    const JsonTree* coordinates = geometry.find("coordinates");
    if (!coordinates || coordinates->kind != JsonTree::Kind::array) fail(geometry, type + " without \"coordinates\"");
    const std::vector<JsonTree>& items = coordinates->items;
    if (items.empty()) return;
    if (type == "Point") return add_point(*coordinates, p, line);
    if (type == "LineString") return add_line(*coordinates, p, line);
    if (type == "Polygon") return add_polygon(*coordinates, p, line);
    for (const JsonTree& item : items) {
      if (type == "MultiPoint") add_point(item, p, item.line);
      if (type == "MultiLineString") add_line(item, p, item.line);
      if (type == "MultiPolygon") add_polygon(item, p, item.line);
    }
  }

  void add_point(const JsonTree& value, const Properties& p, int line) {
    const Point at = position(value);
    if (p.role == Role::start) return shapes_.set_start(at, line);
    if (p.role == Role::goal) return shapes_.set_goal(at, line);
    shapes_.add_point(at);
  }

  void add_line(const JsonTree& value, const Properties& p, int line) {
    if (p.role == Role::door) return shapes_.add_door(chain(value));
    shapes_.add_walls(chain(value), p.thickness, line);
  }

  void add_polygon(const JsonTree& value, const Properties& p, int line) {
    Polygon polygon = rings(value);
    switch (p.role) {
      case Role::free: return shapes_.add_free(std::move(polygon), line);
      case Role::obstacle: return shapes_.add_solid(std::move(polygon), line);
      case Role::goal: return shapes_.add_goal_box(polygon, line);
      case Role::wall: return add_outline(polygon, p, line);
      default: return shapes_.add_polygon(std::move(polygon), line);
    }
  }

  void add_outline(Polygon& polygon, const Properties& p, int line) {
    polygon.holes.push_back(std::move(polygon.outer));
    for (Ring& ring : polygon.holes) {
      if (ring.empty()) continue;
      ring.push_back(ring.front());
      shapes_.add_walls(ring, p.thickness, line);
    }
  }

  Polygon rings(const JsonTree& value) {
    if (value.kind != JsonTree::Kind::array || value.items.empty())
      fail(value, "the coordinates of a polygon are an array of rings");
    Polygon result;
    for (const JsonTree& item : value.items) {
      Ring ring = shapes_.ring(chain(item), item.line);
      if (&item == &value.items.front())
        result.outer = std::move(ring);
      else
        result.holes.push_back(std::move(ring));
    }
    return result;
  }

  Ring chain(const JsonTree& value) const {
    if (value.kind != JsonTree::Kind::array) fail(value, "an array of positions is expected");
    Ring result;
    for (const JsonTree& item : value.items) result.push_back(position(item));
    return result;
  }

  Point position(const JsonTree& value) const {
    if (value.kind != JsonTree::Kind::array || value.items.size() < 2) fail(value, "a position [x, y] is expected");
    return {number(value.items[0], value), number(value.items[1], value)};
  }

  double number(const JsonTree& value) const { return number(value, value); }

  double number(const JsonTree& value, const JsonTree& at) const {
    if (value.kind != JsonTree::Kind::number) fail(at, "a number is expected");
    if (!(std::abs(value.number) <= World::kLargest))
      fail(at, text(value.number) + " is beyond the largest coordinate, " + text(World::kLargest));
    return value.number + 0.0;
  }

  std::string source_;
  Shapes shapes_;
};

}  // namespace

WorldParts read_geojson(std::string_view bytes, const ReadOptions& options, ReadNotes& notes) {
  return GeoJson(options).read(bytes, notes);
}

}  // namespace taut::detail
