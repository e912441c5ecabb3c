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

// Columns aligned, the first one to the left.
template <typename Rows>
std::string aligned(const Rows& rows) {
  std::array<std::size_t, std::tuple_size_v<typename Rows::value_type>> most{};
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) most[i] = std::max(most[i], row[i].size());
  std::string out;
  for (const auto& row : rows) {
    out += fmt::format("{:<{}}", row[0], most[0]);
    for (std::size_t i = 1; i < row.size(); ++i) out += fmt::format("  {:>{}}", row[i], most[i]);
    out += '\n';
  }
  return out;
}

// A number of the summary's row for that planner and measure; `-` where there is none.
std::string summary_text(const Json& summary, const std::string& planner, std::string_view measure,
                         std::string_view number) {
  for (const Json& row : *summary.items()) {
    const Json::Members& members = *row.members();
    if (*members[0].second.text() != planner || *members[1].second.text() != measure) continue;
    for (const auto& [name, value] : members)
      if (name == number) return fmt::format("{:.4g}", std::stod(json_line(value)));
  }
  return "-";
}

}  // namespace

std::string comparison_table(const Comparison& comparison) {
  std::vector<Row> rows{{"planner", "solved", "length", "ratio", "clearance", "vertices", "edges", "build s", "query s",
                         "expanded", "verified"}};
  for (const PlannerRuns& p : comparison.planners)
    if (!p.runs.empty()) rows.push_back(row_of(p, comparison.optimum));
  return aligned(rows);
}

std::string worlds_table(const Json& summary) {
  std::vector<std::array<std::string, 10>> rows{
      {"planner", "solved", "ratio", "lower", "median", "upper", "most", "build s", "query s", "graph bytes"}};
  for (const Json& row : *summary.items()) {
    const std::string planner = *row.members()->front().second.text();
    if (planner == rows.back()[0]) continue;
    const auto text = [&](std::string_view measure, std::string_view number) {
      return summary_text(summary, planner, measure, number);
    };
    rows.push_back({planner, text("solved", "mean"), text("ratio", "least"), text("ratio", "lower"),
                    text("ratio", "median"), text("ratio", "upper"), text("ratio", "most"),
                    text("build_seconds", "median"), text("query_seconds", "median"), text("graph_bytes", "median")});
  }
  return aligned(rows);
}

}  // namespace taut::cli
