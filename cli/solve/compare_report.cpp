#include <taut/cli/solve/compare_report.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <taut/io/results/words.h>

namespace taut::cli {

namespace {

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

// Four digits, whatever the size.
std::string brief_seconds(double seconds) { return seconds < 1e-4 ? "<0.0001" : fmt::format("{:.4f}", seconds); }

Row row_of(const PlannerRuns& p, const std::optional<Length>& optimum) {
  const PlannerRun& typical = p.typical();
  return {p.planner->name,
          solved_text(p),
          typical.solved ? fmt::format("{:.6f}", typical.path.length.value()) : "-",
          typical.solved ? ratio_text(typical.path.length, optimum) : "-",
          typical.clearance ? fmt::format("{:.4g}", *typical.clearance) : "-",
          whole_text(p.median([](const PlannerRun& r) { return static_cast<double>(r.vertices); })),
          whole_text(p.median([](const PlannerRun& r) { return static_cast<double>(r.edges); })),
          brief_seconds(p.median([](const PlannerRun& r) { return r.build.cpu; })),
          brief_seconds(p.median([](const PlannerRun& r) { return r.query.cpu; })),
          whole_text(p.median([](const PlannerRun& r) { return static_cast<double>(r.expanded); })),
          p.solved() == 0    ? "-"
          : p.all_verified() ? "yes"
                             : "NO"};
}

}  // namespace

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

}  // namespace taut::cli
