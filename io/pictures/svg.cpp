#include <taut/io/pictures/svg.h>

#include <fmt/format.h>

#include <algorithm>

#include <taut/io/pictures/colour_scale.h>
#include <taut/io/pictures/detail/svg_labels.h>
#include <taut/io/pictures/detail/svg_layers.h>
#include <taut/io/pictures/detail/svg_motion.h>
#include <taut/io/pictures/detail/svg_path.h>
#include <taut/io/pictures/detail/svg_style.h>

namespace taut {

namespace {

using detail::SvgLayers;
using detail::SvgPath;

class Picture {
 public:
  Picture(const FreeSpace& space, const SvgPicture& what)
      : space_(space),
        what_(what),
        strokes_(SvgLayers::strokes(space, detail::kMapPixels)),
        frame_(SvgLayers::size(space.world(), detail::kMapPixels), what.title, facts(), keys()),
        layers_(space, frame_.map().min, detail::kMapPixels),
        scale_(layers_.scale()) {}

  std::string draw() {
    begin();
    out_ += layers_.solid() + layers_.free();
    fills();
    out_ += layers_.rooms(what_.goal);
    views();
    out_ += layers_.lines("contours", what_.contours);
    roadmap();
    out_ += layers_.openings() + layers_.walls() + layers_.lines("separation", what_.separation) +
            layers_.lines("gates", what_.gates);
    shades();
    out_ += layers_.lines("guides", what_.guides) + layers_.lines("moves", end_move_lines(what_.moves)) +
            layers_.discs(what_.discs);
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
    if (!what_.guides.empty() && !what_.guide_label.empty()) keys.back().label = what_.guide_label;
    if (!what_.contours.empty()) add("contours");
    if (!what_.moves.empty()) add("moves");
    if (!what_.views.empty()) add("views");
    if (!what_.fills.empty()) {
      std::vector<std::string> colours;
      const double one = what_.fills.front().shade;
      const bool alike =
          std::all_of(what_.fills.begin(), what_.fills.end(), [&](const SvgFill& fill) { return fill.shade == one; });
      if (alike) colours.push_back(flood_colour(one));
      for (int i = 0; i <= 8 && !alike; ++i) colours.push_back(flood_colour(i / 8.0));
      keys.push_back({"fills", what_.fill_label, detail::SvgKey::Sample::scale, std::move(colours)});
    }
    if (!what_.discs.empty()) add("discs");
    if (roadmap_is_drawn() || diagram_is_drawn()) add("roadmap");
    if (milestones_are_drawn()) add("milestones");
    if (space_.footprint().kind() != Footprint::Kind::point) add("solid");
    for (const SvgLabelKey& key : what_.label_keys)
      keys.push_back({"labels", key.meaning, detail::SvgKey::Sample::digit, {}, key.letter});
    keys.push_back(SvgLayers::ruler(space_.world(), detail::kMapPixels));
    return keys;
  }

  std::vector<std::string> facts() const {
    std::vector<std::string> facts = what_.facts;
    for (const EndMove& move : what_.moves) facts.push_back(end_move_text(move));
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

  bool milestones_are_drawn() const {
    return what_.milestones && what_.roadmap && what_.roadmap->vertex_count() > 0 &&
           what_.roadmap->vertex_count() <= kSvgRoadmapEdges;
  }

  std::optional<Point> goal_point() const {
    if (what_.goal.point) return what_.goal.point;
    if (what_.path && !what_.path->points.empty()) return what_.path->points.back();
    if (!what_.curves.empty()) return what_.curves.back().to;
    return std::nullopt;
  }

  /// A path a colour; neighbours of one colour leave no seam.
  void fills() {
    constexpr int kColours = 64;
    std::vector<SvgPath> paths(kColours, SvgPath(scale_));
    for (const SvgFill& fill : what_.fills)
      paths[std::clamp(static_cast<int>(fill.shade * kColours), 0, kColours - 1)].ring(fill.ring);
    if (what_.fills.empty()) return;
    out_ += "<g class=\"fills\">";
    for (int i = 0; i < kColours; ++i)
      if (!paths[i].empty())
        out_ += fmt::format("<path d=\"{}\" fill=\"{}\"/>", paths[i].text(), flood_colour((i + 0.5) / kColours));
    out_ += "</g>\n";
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
    if (roadmap_is_drawn()) out_ += SvgLayers::group("roadmap", layers_.edges(*what_.roadmap));
    if (diagram_is_drawn()) out_ += SvgLayers::group("roadmap", layers_.edges(*what_.diagram));
    if (milestones_are_drawn()) out_ += SvgLayers::group("milestones", layers_.dots(*what_.roadmap));
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
    out_ += SvgLayers::path(line);
  }

  // What labels should leave to be seen, in pixels: path, walls, and the markers as crosses.
  std::vector<Segment> drawn() const {
    std::vector<Segment> lines;
    const auto add = [&](Point a, Point b) { lines.push_back({scale_.pixel(a), scale_.pixel(b)}); };
    for (std::size_t i = 1; what_.path && i < what_.path->points.size(); ++i)
      add(what_.path->points[i - 1], what_.path->points[i]);
    for (const Wall& wall : space_.world().walls()) add(wall.a, wall.b);
    const double r = strokes_.marker_radius();
    for (const std::optional<Point>& end : {what_.start, goal_point()}) {
      if (!end) continue;
      const Point p = scale_.pixel(*end);
      lines.push_back({{p.x - r, p.y - r}, {p.x + r, p.y + r}});
      lines.push_back({{p.x - r, p.y + r}, {p.x + r, p.y - r}});
    }
    return lines;
  }

  void labels() {
    if (what_.labels.empty()) return;
    std::vector<detail::SvgWord> words;
    for (const SvgLabel& label : what_.labels) words.push_back({scale_.pixel(label.at), label.text});
    const double size = std::clamp(0.3 * strokes_.corridor, 11.0, 15.0);
    out_ += "<g class=\"labels\">" + detail::words_beside_dots(words, drawn(), frame_.map(), size) + "</g>\n";
  }

  void runner() {
    if (what_.seconds <= 0) return;
    for (const SvgTraveller& who : what_.travellers) {
      std::vector<std::pair<double, Point>> places = who.places;
      for (auto& [when, at] : places) at = scale_.pixel(at);
      out_ += detail::dot_by_clock(places, strokes_.marker_radius(), what_.seconds, who.kind);
    }
    if (!what_.path || !what_.travellers.empty()) return;
    SvgPath line(scale_);
    line.chain(what_.path->points);
    if (!line.empty()) out_ += detail::runner_along(line, strokes_.marker_radius(), what_.seconds);
  }

  void marker(const char* kind, const std::optional<Point>& at) {
    if (at) out_ += layers_.marker(kind, *at, what_.discs.empty() ? 0 : what_.discs.front().radius);
  }

  const FreeSpace& space_;
  const SvgPicture& what_;
  detail::SvgStrokes strokes_;
  detail::SvgFrame frame_;
  SvgLayers layers_;
  const detail::SvgScale& scale_;
  std::string out_;
};

}  // namespace

std::string svg(const FreeSpace& space, const SvgPicture& picture) { return Picture(space, picture).draw(); }

}  // namespace taut
