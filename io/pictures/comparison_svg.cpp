#include <taut/io/pictures/comparison_svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <taut/io/pictures/detail/svg_layers.h>
#include <taut/io/pictures/detail/svg_panels.h>
#include <taut/io/results/words.h>

namespace taut {

namespace {

using detail::SvgLayers;
using detail::SvgPath;

constexpr std::size_t kEdgesDrawn = 6000;

// Beside what all pictures have; a finer line would be lost in a small map.
std::string more_style(const detail::SvgStrokes& strokes) {
  return detail::SvgPanels::style() +
         fmt::format(".taut .roadmap{{stroke-width:{}}}\n", detail::svg_number(std::max(0.6, strokes.roadmap())));
}

class Sheet {
 public:
  Sheet(const Comparison& comparison, const FreeSpace& space, const std::string& title,
        const std::vector<EndMove>& moves)
      : comparison_(comparison), space_(space), moves_(moves) {
    for (const PlannerRuns& p : comparison.planners)
      if (!p.runs.empty()) panels_.push_back(&p);
    std::vector<detail::SvgPanel> texts;
    for (const PlannerRuns* p : panels_) texts.push_back({std::string(p->planner->name), numbers(*p)});
    layout_.emplace(SvgLayers::size(space.world(), 1), texts);
    pixels_ = layout_->scale();
    title_ = title;
  }

  std::string draw() {
    const detail::SvgFrame frame(layout_->size(), title_, facts(), keys());
    const SvgLayers layers(space_, {}, pixels_);
    out_ = frame.head("", detail::style(layers.strokes()) + more_style(layers.strokes()));
    out_ += "<g xmlns:xlink=\"http://www.w3.org/1999/xlink\">\n<defs>\n<g id=\"taut-ground\">" + layers.solid() +
            layers.free() + layers.rooms(comparison_.goal) + "</g>\n<g id=\"taut-walls\">" + layers.openings() +
            layers.walls() + "</g>\n</defs>\n";
    for (std::size_t i = 0; i < panels_.size(); ++i)
      out_ += layout_->panel(i, frame.map().min, map(*panels_[i], layers));
    return std::move(out_ += "</g>\n" + frame.foot());
  }

 private:
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

  std::string map(const PlannerRuns& p, const SvgLayers& layers) {
    const PlannerRun& run = p.typical();
    std::string out = "<use xlink:href=\"#taut-ground\"/>\n";
    if (has_drawn_edges(run)) out += shared("roadmap", layers.edges(*run.roadmap));
    if (has_milestones(run)) out += shared("milestones", layers.dots(*run.roadmap));
    out += "<use xlink:href=\"#taut-walls\"/>\n";
    if (run.solved) out += SvgLayers::path(line(layers, run.path));
    out += layers.marker("start", comparison_.start);
    if (const auto goal = goal_of(run)) out += layers.marker("goal", *goal);
    return out;
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
  std::string shared(const char* kind, const SvgPath& path) {
    const auto [place, is_new] = ids_.try_emplace(path.text(), ids_.size());
    const std::string id = fmt::format("taut-roadmap-{}", place->second);
    const std::string use = is_new ? fmt::format("<path id=\"{}\" d=\"{}\"/>", id, path.text())
                                   : fmt::format("<use xlink:href=\"#{}\"/>", id);
    return fmt::format("<g class=\"{}\">{}</g>\n", kind, use);
  }

  std::vector<std::string> numbers(const PlannerRuns& p) const {
    const PlannerRun& run = p.typical();
    std::vector<std::string> facts{run.solved ? "length " + length_text(run.path.length) : "no path found"};
    if (run.solved && comparison_.optimum) facts.push_back("ratio " + ratio_text(run.path.length));
    if (p.runs.size() > 1) facts.push_back(fmt::format("{} of {} solved", p.solved(), p.runs.size()));
    if (run.counts) facts.push_back(fmt::format("{} samples drawn, {} kept", run.counts->drawn, run.counts->kept));
    if (!run.counts && run.vertices > 0) facts.push_back(count_text(run.vertices, "vertex", "vertices"));
    if (run.edges > 0) facts.push_back(count_text(run.edges, "edge") + (run.edges > kEdgesDrawn ? ", not drawn" : ""));
    return facts;
  }

  std::string ratio_text(const Length& length) const {
    if (length == *comparison_.optimum) return "1";
    return fmt::format("{:.4f}", length.value() / comparison_.optimum->value());
  }

  const Comparison& comparison_;
  const FreeSpace& space_;
  const std::vector<EndMove>& moves_;
  std::string title_;
  std::vector<const PlannerRuns*> panels_;
  std::optional<detail::SvgPanels> layout_;
  double pixels_ = 0;  // of a map's longer side
  std::map<std::string, std::size_t> ids_;
  std::string out_;
};

}  // namespace

std::string comparison_svg(const Comparison& comparison, const FreeSpace& space, const std::string& title,
                           const std::vector<EndMove>& moves) {
  return Sheet(comparison, space, title, moves).draw();
}

}  // namespace taut
