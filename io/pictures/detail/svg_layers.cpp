#include <taut/io/pictures/detail/svg_layers.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <taut/geometry/box.h>
#include <taut/geometry/corridor_width.h>

namespace taut::detail {

namespace {

double longer_side(const Box& box) { return std::max(box.max.x - box.min.x, box.max.y - box.min.y); }

bool same(const Ring& a, const Ring& b) { return std::is_permutation(a.begin(), a.end(), b.begin(), b.end()); }

// A walled world shows a bit of what it is carved out of.
Box box_of(const World& world) {
  Box box = world.box();
  if (world.boundary() != Boundary::walled) return box;
  const double rim = longer_side(box) / 40;
  return {{box.min.x - rim, box.min.y - rim}, {box.max.x + rim, box.max.y + rim}};
}

int decimals(const SvgStrokes& strokes) {
  return std::clamp(static_cast<int>(std::ceil(std::log10(60 / strokes.corridor))), 1, 4);
}

// Hands out each edge of a roadmap once.
class Trails {
 public:
  explicit Trails(const Roadmap& roadmap) : roadmap_(roadmap), taken_(roadmap.vertex_count()) {
    for (Roadmap::Vertex v = 0; v < roadmap.vertex_count(); ++v) taken_[v].resize(roadmap.neighbours(v).size());
  }

  /// The lowest neighbour to which there is an edge left, which is taken.
  std::optional<Roadmap::Vertex> next(Roadmap::Vertex v) {
    const auto row = roadmap_.neighbours(v);
    const auto at = std::find(taken_[v].begin(), taken_[v].end(), false);
    if (at == taken_[v].end()) return std::nullopt;
    *at = true;
    const Roadmap::Vertex w = row[static_cast<std::size_t>(at - taken_[v].begin())];
    const auto back = roadmap_.neighbours(w);
    taken_[w][static_cast<std::size_t>(std::lower_bound(back.begin(), back.end(), v) - back.begin())] = true;
    return w;
  }

 private:
  const Roadmap& roadmap_;
  std::vector<std::vector<bool>> taken_;
};

bool all_is_free(const FreeSpace& space) {
  const auto& free = space.polygons();
  const auto& areas = space.world().areas();
  return space.world().boundary() != Boundary::walled && free.size() == 1 && areas.size() == 1 &&
         free[0].holes.empty() && areas[0].polygon.holes.empty() && same(free[0].outer, areas[0].polygon.outer);
}

}  // namespace

SvgLayers::SvgLayers(const FreeSpace& space, Point top_left, double pixels)
    : space_(space),
      box_(box_of(space.world())),
      extent_(longer_side(box_)),
      strokes_(strokes(space, pixels)),
      scale_(box_, top_left, extent_, pixels, decimals(strokes_), space.world().y_down()) {}

Point SvgLayers::size(const World& world, double pixels) {
  const Box box = box_of(world);
  const double extent = longer_side(box);
  return {(box.max.x - box.min.x) / extent * pixels, (box.max.y - box.min.y) / extent * pixels};
}

SvgKey SvgLayers::ruler(const World& world, double pixels) { return ruler_key(pixels / longer_side(box_of(world))); }

SvgStrokes SvgLayers::strokes(const FreeSpace& space, double pixels) {
  return {corridor_width(space) / longer_side(box_of(space.world())) * pixels};
}

std::string SvgLayers::group(const char* kind, const SvgPath& path) {
  return path.empty() ? "" : fmt::format("<g class=\"{}\"><path d=\"{}\"/></g>\n", kind, path.text());
}

std::string SvgLayers::path(const SvgPath& line) {
  if (line.empty()) return {};
  return fmt::format("<g class=\"path\"><path class=\"casing\" d=\"{0}\"/><path class=\"line\" d=\"{0}\"/></g>\n",
                     line.text());
}

std::string SvgLayers::lines(const char* kind, const std::vector<Segment>& segments) const {
  SvgPath path(scale_);
  for (const Segment& s : segments) path.segment(s);
  return group(kind, path);
}

// The free polygons are drawn over it.
std::string SvgLayers::solid() const {
  if (all_is_free(space_)) return {};
  const World& world = space_.world();
  SvgPath path(scale_);
  if (world.boundary() == Boundary::walled)
    path.ring(ring_of(box_));
  else if (world.areas().size() == 1)
    path.polygon(world.areas()[0].polygon);
  else
    path.ring(ring_of(world.box()));
  return group("solid", path);
}

std::string SvgLayers::free() const {
  SvgPath path(scale_);
  for (const Polygon& polygon : space_.polygons()) path.polygon(polygon);
  return group("free", path);
}

std::string SvgLayers::rooms(const Goal& goal) const {
  SvgPath path(scale_);
  for (const Box& box : goal.room) path.ring(ring_of(box));
  return group("rooms", path);
}

std::string SvgLayers::walls() const {
  const World& world = space_.world();
  std::map<double, SvgPath> by_thickness;
  for (const Wall& wall : world.walls())
    by_thickness.try_emplace(wall.thickness, scale_).first->second.segment({wall.a, wall.b});
  // Where a robot's size hides them in `solid`, the limits of the world are lines.
  if (world.boundary() == Boundary::walled && space_.footprint().kind() != Footprint::Kind::point)
    for (const Area& area : world.areas()) by_thickness.try_emplace(0, scale_).first->second.polygon(area.polygon);
  SvgPath solids(scale_);
  for (const Area& solid : world.solids()) solids.polygon(solid.polygon);
  if (by_thickness.empty() && solids.empty()) return {};
  std::string out = "<g class=\"walls\">";
  if (!solids.empty()) out += fmt::format("<path class=\"area\" d=\"{}\"/>", solids.text());
  for (const auto& [thickness, path] : by_thickness) {
    const std::string bar =
        fmt::format(" class=\"bar\" style=\"stroke-width:{}\"", svg_number(scale_.length(thickness)));
    out += fmt::format("<path{} d=\"{}\"/>", thickness > 0 ? bar : "", path.text());
  }
  return out + "</g>\n";
}

std::string SvgLayers::discs(const std::vector<SvgDisc>& discs) const {
  if (discs.empty()) return {};
  std::string out = "<g class=\"discs\">";
  for (const SvgDisc& disc : discs) {
    const Point at = scale_.pixel(disc.centre);
    out += fmt::format(R"(<circle cx="{}" cy="{}" r="{}"/>)", svg_number(at.x), svg_number(at.y),
                       svg_number(scale_.length(disc.radius)));
  }
  return out + "</g>\n";
}

std::string SvgLayers::marker(const char* kind, Point at, double disc) const {
  const double usual = strokes_.marker_radius();
  const double radius = disc > 0 ? std::min(usual, std::max(3.0, 0.5 * scale_.length(disc))) : usual;
  return detail::marker(kind, scale_.pixel(at), radius,
                        disc > 0 ? std::max(3 * radius, strokes_.corridor) : strokes_.corridor);
}

// Along trails: an edge that goes on from the one before needs no move, which is half of its bytes.
SvgPath SvgLayers::edges(const Roadmap& roadmap) const {
  SvgPath path(scale_);
  Trails trails(roadmap);
  for (Roadmap::Vertex from = 0; from < roadmap.vertex_count(); ++from)
    while (const auto first = trails.next(from))
      for (auto [at, to] = std::pair(from, first); to; at = *to, to = trails.next(at))
        path.segment({roadmap.point(at), roadmap.point(*to)});
  return path;
}

SvgPath SvgLayers::edges(const VoronoiRoadmap& diagram) const {
  SvgPath path(scale_);
  std::vector<Bezier> curves;
  for (const VoronoiEdge& e : diagram.edges()) curves.push_back(diagram.curve(e));
  path.chain(curves);
  return path;
}

SvgPath SvgLayers::dots(const Roadmap& roadmap) const {
  SvgPath path(scale_);
  for (const Point& p : roadmap.points()) path.segment({p, p});
  return path;
}

}  // namespace taut::detail
