#include <taut/io/pictures/comparison_svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <taut/io/pictures/detail/svg_layers.h>
#include <taut/io/results/words.h>

namespace taut {

namespace {

using detail::SvgLayers;
using detail::SvgPath;

constexpr std::size_t kEdgesDrawn = 6000;
constexpr double kInner = 952, kGap = 20;  // of the page between its margins, between panels
constexpr double kHead = 26, kRow = 20;    // a panel's title, a row of its numbers
constexpr double kRim = 6;                 // what may stick out of a map

std::string px(double v) { return detail::svg_number(v); }

// Beside what all pictures have; a finer line would be lost in a small map.
std::string more_style(const detail::SvgStrokes& strokes) {
  return fmt::format(".taut .panel{{font-weight:600}}\n.taut .roadmap{{stroke-width:{}}}\n",
                     px(std::max(0.6, strokes.roadmap())));
}

// Side by side as many as leave each 300 pixels; of wide worlds fewer.
std::size_t columns_for(Point size) { return size.x > 2 * size.y ? 2 : 3; }

class Sheet {
 public:
  Sheet(const Comparison& comparison, const FreeSpace& space, const std::string& title,
        const std::vector<EndMove>& moves)
      : comparison_(comparison), space_(space), moves_(moves) {
    for (const PlannerRuns& p : comparison.planners)
      if (!p.runs.empty()) panels_.push_back(&p);
    const Point whole = SvgLayers::size(space.world(), 1);
    columns_ = std::min(columns_for(whole), std::max<std::size_t>(1, panels_.size()));
    width_ = (kInner - kGap * static_cast<double>(columns_ - 1)) / static_cast<double>(columns_);
    pixels_ = std::min(width_ / whole.x, 1.25 * width_ / whole.y);
    map_ = {whole.x * pixels_, whole.y * pixels_};
    title_ = title;
    for (std::size_t i = 0; i < panels_.size(); i += columns_) tops_.push_back(tops_.back() + height_of_row(i));
  }

  std::string draw() {
    const detail::SvgFrame frame({kInner, tops_.back()}, title_, facts(), keys());
    const SvgLayers layers(space_, {}, pixels_);
    out_ = frame.head("", detail::style(layers.strokes()) + more_style(layers.strokes()));
    out_ += "<g xmlns:xlink=\"http://www.w3.org/1999/xlink\">\n<defs>\n<g id=\"taut-ground\">" + layers.solid() +
            layers.free() + layers.rooms(comparison_.goal) + "</g>\n<g id=\"taut-walls\">" + layers.openings() +
            layers.walls() + "</g>\n</defs>\n";
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      const Point at{frame.map().min.x + static_cast<double>(i % columns_) * (width_ + kGap),
                     frame.map().min.y + tops_[i / columns_]};
      panel(*panels_[i], layers, at);
    }
    return std::move(out_ += "</g>\n" + frame.foot());
  }

 private:
  // As its longest list of numbers needs it.
  double height_of_row(std::size_t first) const {
    std::size_t rows = 0;
    for (std::size_t i = first; i < std::min(first + columns_, panels_.size()); ++i)
      rows = std::max(rows, numbers(*panels_[i]).size());
    return kHead + map_.y + kRow * static_cast<double>(rows) + 1.5 * kGap;
  }

  std::vector<std::string> facts() const {
    std::vector<std::string> facts;
    facts.push_back(comparison_.optimum   ? "shortest path " + length_text(*comparison_.optimum)
                    : comparison_.is_shut ? "no path"
                                          : "no path found");
    for (const EndMove& move : moves_) facts.push_back(end_move_text(move));
    facts.push_back(count_text(panels_.size(), "planner"));
    facts.push_back(fmt::format("seed {}", comparison_.seed));
    if (comparison_.runs > 1) facts.push_back(fmt::format("{} runs of what is random", comparison_.runs));
    std::string unfit;
    for (const PlannerRuns& p : comparison_.planners)
      if (p.runs.empty()) unfit += (unfit.empty() ? "did not run: " : ", ") + std::string(p.planner->name);
    if (!unfit.empty()) facts.push_back(unfit);
    return facts;
  }

  std::vector<detail::SvgKey> keys() const {
    std::vector<detail::SvgKey> keys{detail::key_of("start"), detail::key_of("goal")};
    const auto any = [&](auto is_drawn) {
      return std::any_of(panels_.begin(), panels_.end(), [&](const PlannerRuns* p) { return is_drawn(p->typical()); });
    };
    if (!comparison_.goal.room.empty()) keys.push_back(detail::key_of("rooms"));
    if (any([](const PlannerRun& run) { return run.solved; })) keys.push_back(detail::key_of("path"));
    if (any(has_drawn_edges)) keys.push_back(detail::key_of("roadmap"));
    if (any(has_milestones)) keys.push_back(detail::key_of("milestones"));
    if (space_.footprint().kind() != Footprint::Kind::point) keys.push_back(detail::key_of("solid"));
    keys.push_back(SvgLayers::ruler(space_.world(), pixels_));
    return keys;
  }

  static bool has_drawn_edges(const PlannerRun& run) { return run.edges > 0 && run.edges <= kEdgesDrawn; }
  static bool has_milestones(const PlannerRun& run) { return run.counts && run.vertices <= kEdgesDrawn; }

  void panel(const PlannerRuns& p, const SvgLayers& layers, Point at) {
    const PlannerRun& run = p.typical();
    const Point map{at.x + (width_ - map_.x) / 2, at.y + kHead};
    text("panel", at.x, at.y + 14, p.planner->name);
    out_ += fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\">", px(map.x - kRim),
                        px(map.y - kRim), px(map_.x + 2 * kRim), px(map_.y + 2 * kRim), px(-kRim), px(-kRim),
                        px(map_.x + 2 * kRim), px(map_.y + 2 * kRim));
    out_ += "<use xlink:href=\"#taut-ground\"/>\n";
    if (has_drawn_edges(run)) shared("roadmap", layers.edges(*run.roadmap));
    if (has_milestones(run)) shared("milestones", layers.dots(*run.roadmap));
    out_ += "<use xlink:href=\"#taut-walls\"/>\n";
    if (run.solved) out_ += SvgLayers::path(line(layers, run.path));
    out_ += layers.marker("start", comparison_.start);
    if (const auto goal = goal_of(run)) out_ += layers.marker("goal", *goal);
    out_ += "</svg>\n";
    double y = map.y + map_.y + kRow;
    for (const std::string& row : numbers(p)) text("facts", at.x, std::exchange(y, y + kRow), row);
  }

  static SvgPath line(const SvgLayers& layers, const Path& path) {
    SvgPath line(layers.scale());
    line.chain(path.points);
    return line;
  }

  std::optional<Point> goal_of(const PlannerRun& run) const {
    if (comparison_.goal.point) return comparison_.goal.point;
    return run.solved ? std::optional(run.path.points.back()) : std::nullopt;
  }

  // What stands on the page already is used again.
  void shared(const char* kind, const SvgPath& path) {
    const auto [place, is_new] = ids_.try_emplace(path.text(), ids_.size());
    const std::string id = fmt::format("taut-roadmap-{}", place->second);
    out_ += fmt::format("<g class=\"{}\">", kind);
    out_ += is_new ? fmt::format("<path id=\"{}\" d=\"{}\"/>", id, path.text())
                   : fmt::format("<use xlink:href=\"#{}\"/>", id);
    out_ += "</g>\n";
  }

  std::vector<std::string> numbers(const PlannerRuns& p) const {
    const PlannerRun& run = p.typical();
    std::vector<std::string> facts{run.solved ? "length " + length_text(run.path.length) : "no path found"};
    if (run.solved && comparison_.optimum) facts.push_back("ratio " + ratio_text(run.path.length));
    if (p.runs.size() > 1) facts.push_back(fmt::format("{} of {} solved", p.solved(), p.runs.size()));
    if (run.counts) facts.push_back(fmt::format("{} samples drawn, {} kept", run.counts->drawn, run.counts->kept));
    if (!run.counts && run.vertices > 0) facts.push_back(count_text(run.vertices, "vertex", "vertices"));
    if (run.edges > 0) facts.push_back(count_text(run.edges, "edge") + (run.edges > kEdgesDrawn ? ", not drawn" : ""));
    return detail::wrapped(facts, width_);
  }

  std::string ratio_text(const Length& length) const {
    if (length == *comparison_.optimum) return "1";
    return fmt::format("{:.4f}", length.value() / comparison_.optimum->value());
  }

  void text(const char* kind, double x, double y, const std::string& words) {
    out_ +=
        fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", kind, px(x), px(y), detail::xml_text(words));
  }

  const Comparison& comparison_;
  const FreeSpace& space_;
  const std::vector<EndMove>& moves_;
  std::string title_;
  std::vector<const PlannerRuns*> panels_;
  std::size_t columns_ = 3;
  double width_ = 0, pixels_ = 0;  // of a panel, of its map's longer side
  std::vector<double> tops_{0};    // of the rows of panels, and below the last
  Point map_;                      // its size
  std::map<std::string, std::size_t> ids_;
  std::string out_;
};

}  // namespace

std::string comparison_svg(const Comparison& comparison, const FreeSpace& space, const std::string& title,
                           const std::vector<EndMove>& moves) {
  return Sheet(comparison, space, title, moves).draw();
}

}  // namespace taut
