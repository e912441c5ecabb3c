#include <taut/io/svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <taut/geometry/corridor_width.h>
#include <taut/io/colour_scale.h>
#include <taut/io/detail/svg_motion.h>
#include <taut/io/detail/svg_page.h>
#include <taut/io/detail/svg_path.h>

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
        keys_(keys()) {
    const Point aspect{(box_.max.x - box_.min.x) / extent_, (box_.max.y - box_.min.y) / extent_};
    page_ = detail::page_for(aspect, corridor_width(space) / extent_, keys_);
    const int decimals = std::clamp(static_cast<int>(std::ceil(std::log10(60 / page_.corridor))), 1, 4);
    scale_.emplace(box_, page_.map.min, extent_, detail::kMapPixels, decimals, world_.y_down());
  }

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
    out_ += detail::legend(page_, what_.title, facts(), keys_);
    return std::move(out_ += "</svg>\n");
  }

 private:
  // A walled world shows a bit of what it is carved out of.
  static Box frame(const World& world) {
    Box box = world.box();
    if (world.boundary() != Boundary::walled) return box;
    const double rim = longer_side(box) / 40;
    return {{box.min.x - rim, box.min.y - rim}, {box.max.x + rim, box.max.y + rim}};
  }

  void begin() {
    const auto px = [](double v) { return detail::svg_number(v); };
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"taut\" role=\"img\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\">\n"
        "<title>{2}</title>\n<desc>{3}</desc>\n",
        px(page_.width), px(page_.height), detail::xml_text(what_.title),
        detail::xml_text(fmt::format("{}", fmt::join(facts(), ", "))));
    out_ += detail::style(page_);
    out_ += fmt::format("<rect class=\"page\" width=\"{}\" height=\"{}\"/>\n", px(page_.width), px(page_.height));
    // An inner <svg> cuts off what reaches beyond the world.
    constexpr double kRim = 16;
    out_ +=
        fmt::format("<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" viewBox=\"{0} {1} {2} {3}\">\n",
                    px(page_.map.min.x - kRim), px(page_.map.min.y - kRim),
                    px(page_.map.max.x - page_.map.min.x + 2 * kRim), px(page_.map.max.y - page_.map.min.y + 2 * kRim));
  }

  std::vector<std::string> keys() const {
    std::vector<std::string> keys;
    if (what_.start) keys.emplace_back("start");
    if (goal_point()) keys.emplace_back("goal");
    if (!what_.goal.room.empty()) keys.emplace_back("rooms");
    if (what_.path || what_.arcs || !what_.curves.empty()) keys.emplace_back("path");
    if (!what_.separation.empty()) keys.emplace_back("separation");
    if (!what_.gates.empty()) keys.emplace_back("gates");
    if (!what_.guides.empty()) keys.emplace_back("guides");
    if (!what_.views.empty()) keys.emplace_back("views");
    if (roadmap_is_drawn() || diagram_is_drawn()) keys.emplace_back("roadmap");
    if (space_.footprint().kind() != Footprint::Kind::point) keys.emplace_back("solid");
    return keys;
  }

  std::vector<std::string> facts() const {
    std::vector<std::string> facts = what_.facts;
    if (what_.roadmap && !roadmap_is_drawn())
      facts.push_back(fmt::format("roadmap of {} edges not drawn", what_.roadmap->edge_count()));
    if (what_.diagram && !diagram_is_drawn())
      facts.push_back(fmt::format("diagram of {} edges not drawn", what_.diagram->edges().size()));
    return facts;
  }

  bool diagram_is_drawn() const { return what_.diagram && what_.diagram->edges().size() <= kSvgRoadmapEdges; }

  bool roadmap_is_drawn() const { return what_.roadmap && what_.roadmap->edge_count() <= kSvgRoadmapEdges; }

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
    SvgPath path(*scale_);
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
    SvgPath path(*scale_);
    if (world_.boundary() == Boundary::walled)
      path.ring(ring_of(box_));
    else if (world_.areas().size() == 1)
      path.polygon(world_.areas()[0].polygon);
    else
      path.ring(ring_of(world_.box()));
    group("solid", path);
  }

  void free() {
    SvgPath path(*scale_);
    for (const Polygon& polygon : space_.polygons()) path.polygon(polygon);
    group("free", path);
  }

  void rooms() {
    SvgPath path(*scale_);
    for (const Box& box : what_.goal.room) path.ring(ring_of(box));
    group("rooms", path);
  }

  void views() {
    SvgPath all(*scale_);
    for (const SvgView& view : what_.views) all.ring(view.ring);
    if (all.empty()) return;
    out_ += fmt::format("<g class=\"views\"><path d=\"{}\"/>", all.text());
    for (std::size_t k = 0; what_.seconds > 0 && k < what_.views.size(); ++k) {
      SvgPath one(*scale_);
      one.ring(what_.views[k].ring);
      const double until = k + 1 < what_.views.size() ? what_.views[k + 1].at : 1;
      out_ += fmt::format("<path d=\"{}\" opacity=\"0\">{}</path>", one.text(),
                          detail::shown_between(what_.views[k].at, until, what_.seconds));
    }
    out_ += "</g>\n";
  }

  void roadmap() {
    if (!roadmap_is_drawn()) return;
    SvgPath path(*scale_);
    for (Roadmap::Vertex v = 0; v < what_.roadmap->vertex_count(); ++v)
      for (const Roadmap::Vertex w : what_.roadmap->neighbours(v))
        if (v < w) path.segment({what_.roadmap->point(v), what_.roadmap->point(w)});
    group("roadmap", path);
  }

  void diagram() {
    if (!diagram_is_drawn()) return;
    SvgPath path(*scale_);
    std::vector<VoronoiCurve> curves;
    for (const VoronoiEdge& e : what_.diagram->edges()) curves.push_back(what_.diagram->curve(e));
    path.chain(curves);
    group("roadmap", path);
  }

  void shades() {
    if (what_.shades.empty()) return;
    out_ += "<g class=\"shades\">";
    // Where paths run together, those below show as rims.
    double width = page_.path_stroke() * 2;
    const double step = page_.path_stroke() * 1.2 / static_cast<double>(what_.shades.size());
    for (const SvgShade& s : what_.shades) {
      SvgPath path(*scale_);
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
      by_thickness.try_emplace(wall.thickness, *scale_).first->second.segment({wall.a, wall.b});
    SvgPath solids(*scale_);
    for (const Area& solid : world_.solids()) solids.polygon(solid.polygon);
    if (by_thickness.empty() && solids.empty()) return;
    out_ += "<g class=\"walls\">";
    if (!solids.empty()) out_ += fmt::format("<path class=\"area\" d=\"{}\"/>", solids.text());
    for (const auto& [thickness, path] : by_thickness) {
      const std::string bar =
          fmt::format(" class=\"bar\" style=\"stroke-width:{}\"", detail::svg_number(scale_->length(thickness)));
      out_ += fmt::format("<path{} d=\"{}\"/>", thickness > 0 ? bar : "", path.text());
    }
    out_ += "</g>\n";
  }

  void path() {
    SvgPath line(*scale_);
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
    out_ += "<g class=\"labels\">";
    const double size = std::clamp(0.3 * page_.corridor, 9.0, 16.0);
    for (const SvgLabel& label : what_.labels) {
      const Point at = scale_->pixel(label.at);
      out_ +=
          fmt::format("<circle cx=\"{0}\" cy=\"{1}\" r=\"{2}\"/><text x=\"{3}\" y=\"{4}\" font-size=\"{5}\">{6}</text>",
                      detail::svg_number(at.x), detail::svg_number(at.y), detail::svg_number(size / 4),
                      detail::svg_number(at.x + size / 3), detail::svg_number(at.y - size / 3),
                      detail::svg_number(size), detail::xml_text(label.text));
    }
    out_ += "</g>\n";
  }

  void runner() {
    if (!what_.path || what_.seconds <= 0) return;
    SvgPath line(*scale_);
    line.chain(what_.path->points);
    if (!line.empty()) out_ += detail::runner_along(line, page_.marker_radius(), what_.seconds);
  }

  void marker(const char* kind, const std::optional<Point>& at) {
    if (at) out_ += detail::marker(kind, scale_->pixel(*at), page_.marker_radius(), page_.corridor);
  }

  const FreeSpace& space_;
  const World& world_;
  const SvgPicture& what_;
  Box box_;
  double extent_;
  std::vector<std::string> keys_;
  detail::SvgPage page_;
  std::optional<detail::SvgScale> scale_;
  std::string out_;
};

}  // namespace

std::string svg(const FreeSpace& space, const SvgPicture& picture) { return Picture(space, picture).draw(); }

}  // namespace taut
