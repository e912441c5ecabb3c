#include <taut/cli/solve/compare_report.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <taut/cli/report.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/pictures/svg_sheet.h>

namespace taut::cli {

namespace {

constexpr std::size_t kEdgesDrawn = 20'000;
constexpr std::size_t kColumns = 3;

using Row = std::array<std::string, 11>;

std::string solved_text(const PlannerRuns& p) {
  if (p.runs.size() > 1) return fmt::format("{}/{}", p.solved(), p.runs.size());
  return p.solved() ? "yes" : "no";
}

std::string ratio_text(const Length& length, const std::optional<Length>& optimum) {
  if (!optimum) return "-";
  if (length == *optimum) return "1";
  return fmt::format("{:.4f}", length.value() / optimum->value());
}

std::string whole_text(double value) { return fmt::format("{:.0f}", value); }

bool passes(const PlannerRun& run) { return !run.solved || run.verified; }

// Four digits, whatever the size.
std::string brief_seconds(double seconds) { return seconds < 1e-4 ? "<0.0001" : fmt::format("{:.4f}", seconds); }

Row row_of(const PlannerRuns& p, const std::optional<Length>& optimum) {
  const PlannerRun& typical = p.typical();
  const bool all_verified = std::all_of(p.runs.begin(), p.runs.end(), passes);
  return {p.planner->name,
          solved_text(p),
          typical.solved ? fmt::format("{:.6f}", typical.path.length.value()) : "-",
          typical.solved ? ratio_text(typical.path.length, optimum) : "-",
          typical.clearance ? fmt::format("{:.4g}", *typical.clearance) : "-",
          whole_text(p.median([](const PlannerRun& r) { return static_cast<double>(r.vertices); })),
          whole_text(p.median([](const PlannerRun& r) { return static_cast<double>(r.edges); })),
          brief_seconds(p.median([](const PlannerRun& r) { return r.build_seconds; })),
          brief_seconds(p.median([](const PlannerRun& r) { return r.query_seconds; })),
          whole_text(p.median([](const PlannerRun& r) { return static_cast<double>(r.expanded); })),
          p.solved() == 0 ? "-"
          : all_verified  ? "yes"
                          : "NO"};
}

std::string picture_of(const PlannerRuns& p, const Comparison& comparison, const FreeSpace& space) {
  const PlannerRun& run = p.typical();
  SvgPicture picture;
  picture.title = p.planner->name;
  picture.facts = {p.solved() ? "length " + fmt::format("{:.6f}", run.path.length.value()) : "no path found"};
  if (p.solved() && comparison.optimum)
    picture.facts.push_back("ratio " + ratio_text(run.path.length, comparison.optimum));
  if (p.runs.size() > 1) picture.facts.push_back(solved_text(p) + " solved");
  picture.facts.push_back(count_text(run.vertices, "vertex", "vertices"));
  picture.facts.push_back(count_text(run.edges, "edge"));
  if (run.edges <= kEdgesDrawn) picture.roadmap = run.roadmap.get();
  if (run.solved) picture.path = &run.path;
  picture.start = comparison.start;
  picture.goal = comparison.goal;
  return svg(space, picture);
}

}  // namespace

const PlannerRuns* Comparison::wrong() const {
  const auto fails = [](const PlannerRuns& p) { return !std::all_of(p.runs.begin(), p.runs.end(), passes); };
  const auto first = std::find_if(planners.begin(), planners.end(), fails);
  return first == planners.end() ? nullptr : &*first;
}

std::string comparison_table(const Comparison& comparison) {
  std::vector<Row> rows{{"planner", "solved", "length", "ratio", "clearance", "vertices", "edges", "build s", "query s",
                         "expanded", "verified"}};
  for (const PlannerRuns& p : comparison.planners)
    if (!p.runs.empty()) rows.push_back(row_of(p, comparison.optimum));
  std::array<std::size_t, std::tuple_size_v<Row>> widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string out;
  for (const Row& row : rows) {
    out += fmt::format("{:<{}}", row[0], widths[0]);
    for (std::size_t i = 1; i < row.size(); ++i) out += fmt::format("  {:>{}}", row[i], widths[i]);
    out += '\n';
  }
  return out;
}

std::string comparison_svg(const Comparison& comparison, const FreeSpace& space) {
  std::vector<std::string> pictures;
  for (const PlannerRuns& p : comparison.planners)
    if (!p.runs.empty()) pictures.push_back(picture_of(p, comparison, space));
  return svg_sheet(pictures, kColumns);
}

}  // namespace taut::cli
