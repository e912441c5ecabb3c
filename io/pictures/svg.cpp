#include <taut/io/pictures/svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <taut/geometry/corridor_width.h>
#include <taut/io/pictures/colour_scale.h>
#include <taut/io/pictures/detail/svg_labels.h>
#include <taut/io/pictures/detail/svg_motion.h>
#include <taut/io/pictures/detail/svg_path.h>
#include <taut/io/pictures/detail/svg_style.h>

namespace taut {

namespace {

using detail::SvgPath;

double longer_side(const Box& box) { return std::max(box.max.x - box.min.x, box.max.y - box.min.y); }

Ring ring_of(const Box& b) { return {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}}; }

bool same(const Ring& a, const Ring& b) { return std::is_permutation(a.begin(), a.end(), b.begin(), b.end()); }

class Picture {
 public:
  Picture(const FreeSpace& space, const SvgPicture& what)
      : space_(space),
        world_(space.world()),
        what_(what),
        box_(frame(world_)),
        extent_(longer_side(box_)),
        strokes_{corridor_width(space) / extent_ * detail::kMapPixels},
        frame_(size(), what.title, facts(), keys()),
        scale_(box_, frame_.map().min, extent_, detail::kMapPixels, decimals(), world_.y_down()) {}

  std::string draw() {
    begin();
    solid();
    free();
    rooms();
    views();
    roadmap();
    diagram();
    lines("openings", world_.openings());
    walls();
    lines("separation", what_.separation);
    lines("gates", what_.gates);
    shades();
    lines("guides", what_.guides);
    path();
    marker("start", what_.start);
    marker("goal", goal_point());
    labels();
    runner();
    out_ += "</svg>\n";
    if (what_.seconds > 0) out_ += detail::film_controls({frame_.width() - 4, 3});
    return std::move(out_ += frame_.foot());
  }

 private:
  // A walled world shows a bit of what it is carved out of.
  static Box frame(const World& world) {
    Box box = world.box();
    if (world.boundary() != Boundary::walled) return box;
    const double rim = longer_side(box) / 40;
    return {{box.min.x - rim, box.min.y - rim}, {box.max.x + rim, box.max.y + rim}};
  }

  Point size() const {
    return {(box_.max.x - box_.min.x) / extent_ * detail::kMapPixels,
            (box_.max.y - box_.min.y) / extent_ * detail::kMapPixels};
  }

  int decimals() const { return std::clamp(static_cast<int>(std::ceil(std::log10(60 / strokes_.corridor))), 1, 4); }

  void begin() {
    using detail::svg_number;
    out_ = frame_.head("", detail::style(strokes_));
    // An inner <svg> cuts off what reaches beyond the world.
    constexpr double kRim = 16;
    const Box map = frame_.map();
    out_ += fmt::format("<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" viewBox=\"{0} {1} {2} {3}\">\n",
                        svg_number(map.min.x - kRim), svg_number(map.min.y - kRim),
                        svg_number(map.max.x - map.min.x + 2 * kRim), svg_number(map.max.y - map.min.y + 2 * kRim));
  }

  std::vector<detail::SvgKey> keys() const {
    std::vector<detail::SvgKey> keys;
    const auto add = [&](const char* kind) { keys.push_back(detail::key_of(kind)); };
    if (what_.start) add("start");
    if (goal_point()) add("goal");
    if (!what_.goal.room.empty()) add("rooms");
    if (what_.path || what_.arcs || !what_.curves.empty()) add("path");
    if (!what_.separation.empty()) add("separation");
    if (!what_.gates.empty()) add("gates");
    if (!what_.guides.empty()) add("guides");
    if (!what_.views.empty()) add("views");
    if (roadmap_is_drawn() || diagram_is_drawn()) add("roadmap");
    if (space_.footprint().kind() != Footprint::Kind::point) add("solid");
    for (const SvgLabelKey& key : what_.label_keys)
      keys.push_back({"labels", key.meaning, detail::SvgKey::Sample::digit, {}, key.letter});
    keys.push_back(detail::ruler_key(detail::kMapPixels / extent_));
    return keys;
  }

  std::vector<std::string> facts() const {
    std::vector<std::string> facts = what_.facts;
    if (what_.roadmap && what_.roadmap->edge_count() > kSvgRoadmapEdges)
      facts.push_back(fmt::format("roadmap of {} edges not drawn", what_.roadmap->edge_count()));
    if (what_.diagram && !diagram_is_drawn())
      facts.push_back(fmt::format("diagram of {} edges not drawn", what_.diagram->edges().size()));
    return facts;
  }

  bool diagram_is_drawn() const { return what_.diagram && what_.diagram->edges().size() <= kSvgRoadmapEdges; }

  bool roadmap_is_drawn() const {
    return what_.roadmap && what_.roadmap->edge_count() > 0 && what_.roadmap->edge_count() <= kSvgRoadmapEdges;
  }

  std::optional<Point> goal_point() const {
    if (what_.goal.point) return what_.goal.point;
    if (what_.path && !what_.path->points.empty()) return what_.path->points.back();
    if (!what_.curves.empty()) return what_.curves.back().to;
    return std::nullopt;
  }

  void group(const char* kind, const SvgPath& path) {
    if (!path.empty()) out_ += fmt::format("<g class=\"{}\"><path d=\"{}\"/></g>\n", kind, path.text());
  }

  void lines(const char* kind, const std::vector<Segment>& segments) {
    SvgPath path(scale_);
    for (const Segment& s : segments) path.segment(s);
    group(kind, path);
  }

  bool all_is_free() const {
    const auto& free = space_.polygons();
    const auto& areas = world_.areas();
    return world_.boundary() != Boundary::walled && free.size() == 1 && areas.size() == 1 && free[0].holes.empty() &&
           areas[0].polygon.holes.empty() && same(free[0].outer, areas[0].polygon.outer);
  }

  // The free polygons are drawn over it.
  void solid() {
    if (all_is_free()) return;
    SvgPath path(scale_);
    if (world_.boundary() == Boundary::walled)
      path.ring(ring_of(box_));
    else if (world_.areas().size() == 1)
      path.polygon(world_.areas()[0].polygon);
    else
      path.ring(ring_of(world_.box()));
    group("solid", path);
  }

  void free() {
    SvgPath path(scale_);
    for (const Polygon& polygon : space_.polygons()) path.polygon(polygon);
    group("free", path);
  }

  void rooms() {
    SvgPath path(scale_);
    for (const Box& box : what_.goal.room) path.ring(ring_of(box));
    group("rooms", path);
  }

  void views() {
    SvgPath all(scale_);
    for (const SvgView& view : what_.views) all.ring(view.ring);
    if (all.empty()) return;
    out_ += fmt::format("<g class=\"views\"><path d=\"{}\"/>", all.text());
    for (std::size_t k = 0; what_.seconds > 0 && k < what_.views.size(); ++k) {
      SvgPath one(scale_);
      one.ring(what_.views[k].ring);
      const double until = k + 1 < what_.views.size() ? what_.views[k + 1].at : 1;
      out_ += fmt::format("<path class=\"moving\" d=\"{}\" opacity=\"0\">{}</path>", one.text(),
                          detail::shown_between(what_.views[k].at, until, what_.seconds));
    }
    out_ += "</g>\n";
  }

  void roadmap() {
    if (!roadmap_is_drawn()) return;
    SvgPath path(scale_);
    for (Roadmap::Vertex v = 0; v < what_.roadmap->vertex_count(); ++v)
      for (const Roadmap::Vertex w : what_.roadmap->neighbours(v))
        if (v < w) path.segment({what_.roadmap->point(v), what_.roadmap->point(w)});
    group("roadmap", path);
  }

  void diagram() {
    if (!diagram_is_drawn()) return;
    SvgPath path(scale_);
    std::vector<VoronoiCurve> curves;
    for (const VoronoiEdge& e : what_.diagram->edges()) curves.push_back(what_.diagram->curve(e));
    path.chain(curves);
    group("roadmap", path);
  }

  void shades() {
    if (what_.shades.empty()) return;
    out_ += "<g class=\"shades\">";
    // Where paths run together, those below show as rims.
    double width = strokes_.path() * 2;
    const double step = strokes_.path() * 1.2 / static_cast<double>(what_.shades.size());
    for (const SvgShade& s : what_.shades) {
      SvgPath path(scale_);
      path.chain(s.curves);
      if (!path.empty())
        out_ += fmt::format("<path style=\"stroke:{};stroke-width:{}\" d=\"{}\"/>", shade_colour(s.shade),
                            detail::svg_number(width), path.text());
      width -= step;
    }
    out_ += "</g>\n";
  }

  void walls() {
    std::map<double, SvgPath> by_thickness;
    for (const Wall& wall : world_.walls())
      by_thickness.try_emplace(wall.thickness, scale_).first->second.segment({wall.a, wall.b});
    // Where a robot's size hides them in `solid`, the limits of the world are lines.
    if (world_.boundary() == Boundary::walled && space_.footprint().kind() != Footprint::Kind::point)
      for (const Area& area : world_.areas()) by_thickness.try_emplace(0, scale_).first->second.polygon(area.polygon);
    SvgPath solids(scale_);
    for (const Area& solid : world_.solids()) solids.polygon(solid.polygon);
    if (by_thickness.empty() && solids.empty()) return;
    out_ += "<g class=\"walls\">";
    if (!solids.empty()) out_ += fmt::format("<path class=\"area\" d=\"{}\"/>", solids.text());
    for (const auto& [thickness, path] : by_thickness) {
      const std::string bar =
          fmt::format(" class=\"bar\" style=\"stroke-width:{}\"", detail::svg_number(scale_.length(thickness)));
      out_ += fmt::format("<path{} d=\"{}\"/>", thickness > 0 ? bar : "", path.text());
    }
    out_ += "</g>\n";
  }

  void path() {
    SvgPath line(scale_);
    if (what_.path) line.chain(what_.path->points);
    if (what_.arcs)
      for (const ArcPiece& piece : pieces(*what_.arcs)) {
        if (piece.turn == 0)
          line.segment({piece.from, piece.to});
        else
          line.arc(piece.from, piece.to, what_.arcs->radius, piece.turn > 0);
      }
    if (!what_.curves.empty()) line.chain(what_.curves);
    if (line.empty()) return;
    out_ += fmt::format("<g class=\"path\"><path class=\"casing\" d=\"{0}\"/><path class=\"line\" d=\"{0}\"/></g>\n",
                        line.text());
  }

  void labels() {
    if (what_.labels.empty()) return;
    std::vector<Segment> lines;
    const auto add = [&](Point a, Point b) { lines.push_back({scale_.pixel(a), scale_.pixel(b)}); };
    for (std::size_t i = 1; what_.path && i < what_.path->points.size(); ++i)
      add(what_.path->points[i - 1], what_.path->points[i]);
    for (const Wall& wall : world_.walls()) add(wall.a, wall.b);
    std::vector<detail::SvgWord> words;
    for (const SvgLabel& label : what_.labels) words.push_back({scale_.pixel(label.at), label.text});
    const double size = std::clamp(0.3 * strokes_.corridor, 11.0, 15.0);
    out_ += "<g class=\"labels\">" + detail::words_beside_dots(words, lines, frame_.map(), size) + "</g>\n";
  }

  void runner() {
    if (!what_.path || what_.seconds <= 0) return;
    SvgPath line(scale_);
    line.chain(what_.path->points);
    if (!line.empty()) out_ += detail::runner_along(line, strokes_.marker_radius(), what_.seconds);
  }

  void marker(const char* kind, const std::optional<Point>& at) {
    if (at) out_ += detail::marker(kind, scale_.pixel(*at), strokes_.marker_radius(), strokes_.corridor);
  }

  const FreeSpace& space_;
  const World& world_;
  const SvgPicture& what_;
  Box box_;
  double extent_;
  detail::SvgStrokes strokes_;
  detail::SvgFrame frame_;
  detail::SvgScale scale_;
  std::string out_;
};

}  // namespace

std::string svg(const FreeSpace& space, const SvgPicture& picture) { return Picture(space, picture).draw(); }

}  // namespace taut
