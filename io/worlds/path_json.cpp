#include <taut/io/worlds/detail/path_json.h>

#include <cmath>

#include <taut/geometry/world.h>
#include <taut/io/worlds/detail/json_tree.h>
#include <taut/io/worlds/detail/text_input.h>
#include <taut/roadmaps/bezier.h>

namespace taut::detail {

namespace {

using Kind = JsonTree::Kind;

constexpr int kLegs = 64;  // a curve

class Reader {
 public:
  explicit Reader(const std::string& source) : source_(source) {}

  std::vector<ClaimedPath> read(const JsonTree& file) {
    if (const JsonTree* type = file.find("type"); type && type->kind == Kind::string) return geojson(file);
    const JsonTree* const result = file.find("result");
    const JsonTree& json = result ? *result : file;
    const JsonTree* const several = json.find("tradeoff");
    if (!several || several->kind != Kind::array || several->items.empty()) return {one(json)};
    std::vector<ClaimedPath> paths;
    for (const JsonTree& item : several->items) {
      const JsonTree* const way = item.find("way");
      paths.push_back(way ? around(json, item, *way) : one(item));
    }
    return paths;
  }

 private:
  ClaimedPath one(const JsonTree& json) {
    ClaimedPath path;
    if (json.kind == Kind::array) {
      path.points = points(json);
      return path;
    }
    if (const JsonTree* length = json.find("length"); length && length->kind == Kind::number)
      path.length = length->number;
    if (const JsonTree* bends = json.find("bends"); bends && bends->kind == Kind::array)
      path.arcs = arcs(json, *bends, path.length.value_or(0));
    if (const JsonTree* curves = json.find("curves"); curves && curves->kind == Kind::array) {
      path.approximate = true;
      follow(*curves, path);
    } else {
      path.points = points(list_of(json));
    }
    return path;
  }

  /// A disc's way that its ends are straight beside: as legs.
  ClaimedPath around(const JsonTree& json, const JsonTree& item, const JsonTree& way) const {
    ClaimedPath path;
    path.approximate = true;
    path.length = member(item, "length").number;
    const JsonTree& goal = member(json, "goal");
    const ArcPath disc = arcs(way, member(way, "bends"), 0);
    path.points = sampled(disc, disc.radius / 1000);
    path.points.insert(path.points.begin(), point(member(json, "start")));
    path.points.push_back(point(goal.kind == Kind::array ? goal : member(goal, "point")));
    path.tolerance = disc.radius / 1000;
    const auto straight = [](Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); };
    path.measured = length_of(pieces(disc)).middle() + straight(path.points.front(), disc.start) +
                    straight(disc.goal, path.points.back());
    return path;
  }

  [[noreturn]] void fail(const JsonTree& at, const std::string& message) const {
    SourceLine{source_, at.line}.fail(message);
  }

  const JsonTree& list_of(const JsonTree& json) const {
    for (const char* name : {"points", "path"})
      if (const JsonTree* list = json.find(name); list && list->kind != Kind::null) {
        if (list->kind != Kind::array) fail(*list, "the points are not a list");
        return *list;
      }
    fail(json, "holds no path: there are no \"points\"");
  }

  double coordinate(const JsonTree& json) const {
    if (json.kind != Kind::number) fail(json, "a coordinate is no number");
    if (!(std::abs(json.number) <= World::kLargest)) fail(json, "a coordinate is beyond 1e+75");
    return json.number;
  }

  Point point(const JsonTree& json, bool more = false) const {
    if (json.kind != Kind::array || json.items.size() < 2 || (!more && json.items.size() > 2))
      fail(json, "a point is not written as [x, y]");
    return {coordinate(json.items[0]), coordinate(json.items[1])};
  }

  std::vector<Point> points(const JsonTree& list, bool more = false) const {
    std::vector<Point> result;
    for (const JsonTree& item : list.items) result.push_back(point(item, more));
    return result;
  }

  const JsonTree& member(const JsonTree& json, const char* name) const {
    const JsonTree* found = json.find(name);
    if (!found) fail(json, std::string("there is no \"") + name + "\" beside the bends");
    return *found;
  }

  ArcPath arcs(const JsonTree& json, const JsonTree& bends, double length) const {
    ArcPath path;
    const JsonTree& goal = member(json, "goal");
    path.start = point(member(json, "start"));
    path.goal = point(goal.kind == Kind::array ? goal : member(goal, "point"));
    path.radius = coordinate(member(member(json, "robot"), "radius"));
    for (const JsonTree& bend : bends.items) {
      if (bend.kind != Kind::array || bend.items.size() != 3) fail(bend, "a bend is not written as [x, y, turn]");
      const double turn = coordinate(bend.items[2]);
      if (turn != 0 && std::abs(turn) != 1) fail(bend, "a bend's turn is none of 1, -1 and 0");
      path.bends.push_back({{coordinate(bend.items[0]), coordinate(bend.items[1])}, static_cast<int>(turn)});
    }
    path.length = {length, length};
    return path;
  }

  void follow(const JsonTree& curves, ClaimedPath& path) const {
    path.measured = 0;
    for (const JsonTree& item : curves.items) {
      const std::vector<Point> c = points(item);
      if (c.size() != 3) fail(item, "a curve is not written as three points");
      if (path.points.empty()) path.points.push_back(c[0]);
      const Bezier curve{c[0], c[1], c[2]};
      for (int k = 1; k < kLegs; ++k) path.points.push_back(curve.at(static_cast<double>(k) / kLegs));
      path.points.push_back(c[2]);
      *path.measured += curve.length();
    }
  }

  std::vector<ClaimedPath> geojson(const JsonTree& file) {
    find_lines(file, nullptr);
    if (found_.empty()) fail(file, "holds no path: there is no LineString");
    return std::move(found_);
  }

  void find_lines(const JsonTree& json, const JsonTree* properties) {
    const JsonTree* const type = json.find("type");
    if (!type) return;
    for (const char* name : {"features", "geometries"})
      if (const JsonTree* items = json.find(name))
        for (const JsonTree& item : items->items) find_lines(item, properties);
    if (const JsonTree* geometry = json.find("geometry")) find_lines(*geometry, json.find("properties"));
    const JsonTree* const coordinates = json.find("coordinates");
    if (!coordinates || (type->string != "LineString" && type->string != "Point")) return;
    ClaimedPath path;
    path.points = type->string == "Point" ? std::vector{point(*coordinates, true)} : points(*coordinates, true);
    if (const JsonTree* length = properties ? properties->find("length") : nullptr;
        length && length->kind == Kind::number)
      path.length = length->number;
    if (const JsonTree* tolerance = properties ? properties->find("tolerance") : nullptr) {
      path.approximate = true;
      if (tolerance->kind == Kind::number && tolerance->number > 0) path.tolerance = tolerance->number;
    }
    found_.push_back(std::move(path));
  }

  const std::string& source_;
  std::vector<ClaimedPath> found_;
};

}  // namespace

std::vector<ClaimedPath> read_paths_json(std::string_view bytes, const std::string& source) {
  return Reader(source).read(parse_json(bytes, source));
}

}  // namespace taut::detail
