#include <taut/io/worlds/grid_csv.h>

#include <fmt/format.h>

#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/expects.h>
#include <taut/io/worlds/detail/text_input.h>
#include <taut/io/worlds/movingai.h>

namespace taut {

namespace {

using detail::quoted;
using detail::SourceLine;

constexpr std::size_t kMostCells = 400'000'000;

// Without the empty ones at the end.
std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t comma = std::min(line.find(',', from), line.size());
    fields.push_back(detail::trimmed(line.substr(from, comma - from)));
    from = comma + 1;
  }
  while (!fields.empty() && fields.back().empty()) fields.pop_back();
  return fields;
}

bool is_blank(std::string_view line) { return fields_of(line).empty(); }

void require_free(const GridTask& task, const std::optional<GridPlace>& end, const char* what,
                  const SourceLine& place) {
  if (!end) return;
  const OccupancyGrid& grid = task.grid;
  const std::string where = fmt::format("{} (row {}, column {})", what, end->row, end->column);
  if (!grid.contains(end->column, end->row))
    place.fail(fmt::format("{} is outside the grid of {} rows and {} columns", where, grid.height, grid.width));
  if (!grid.free(end->column, end->row)) place.fail(where + " is blocked");
}

class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& source) : lines_(text), source_(source) {}

  GridTask read() {
    int start_line = 0, goal_line = 0;
    while (next())
      if (begins("start") && !task_.start)
        start_line = end("start", task_.start);
      else if (begins("goal") && !task_.goal)
        goal_line = end("goal", task_.goal);
      else
        row();
    if (task_.grid.height == 0) throw InputError(source_, 0, "has no rows of cells");
    require_free(task_, task_.start, "start", {source_, start_line});
    require_free(task_, task_.goal, "goal", {source_, goal_line});
    return std::move(task_);
  }

 private:
  bool next() {
    while (lines_.next())
      if (!is_blank(lines_.line())) return true;
    return false;
  }

  bool begins(std::string_view word) const { return task_.grid.height == 0 && fields_of(lines_.line())[0] == word; }

  int end(const char* word, std::optional<GridPlace>& where) const {
    const SourceLine place{source_, lines_.number()};
    const auto fields = fields_of(lines_.line());
    if (fields.size() != 3)
      place.fail(fmt::format("'{}' wants a row and a column, not {} values", word, fields.size() - 1));
    const auto number = [&](std::size_t i, const char* what) {
      return static_cast<std::uint32_t>(detail::whole(fields[i], 0, 399'999'999, what, place));
    };
    const std::uint32_t row = number(1, "row"), column = number(2, "column");
    where = GridPlace{row, column};
    return place.line;
  }

  void row() {
    OccupancyGrid& grid = task_.grid;
    const SourceLine place{source_, lines_.number()};
    const auto fields = fields_of(lines_.line());
    if (grid.height == 0) grid.width = static_cast<std::uint32_t>(fields.size());
    if (fields.size() != grid.width)
      place.fail(fmt::format("row {} has {} cells, those before it {}", grid.height, fields.size(), grid.width));
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i] != "0" && fields[i] != "1")
        place.fail(fmt::format("cell (row {}, column {}) is {}, not 0 or 1", grid.height, i, quoted(fields[i])));
      grid.blocked.push_back(fields[i] == "1");
    }
    if (grid.blocked.size() > kMostCells) place.fail("more than 400000000 cells");
    ++grid.height;
  }

  detail::Lines lines_;
  const std::string& source_;
  GridTask task_;
};

void draw_cell(GridTask& task, char c, std::uint32_t column, const SourceLine& place) {
  const GridPlace here{task.grid.height, column};
  const auto mark = [&](std::optional<GridPlace>& end) {
    if (end) place.fail(fmt::format("a second '{}' in column {}", c, column));
    end = here;
  };
  if (c == 'S') mark(task.start);
  if (c == 'G') mark(task.goal);
  const bool blocked = std::string_view("#@X1").find(c) != std::string_view::npos;
  if (!blocked && std::string_view("._0SG").find(c) == std::string_view::npos)
    place.fail(fmt::format("{} in column {} is no cell; free are . _ 0 S G, blocked # @ X 1", quoted({&c, 1}), column));
  task.grid.blocked.push_back(blocked);
}

}  // namespace

GridTask read_grid_csv(std::string_view text, const std::string& source) { return CsvReader(text, source).read(); }

std::string grid_csv_text(const GridTask& task) {
  TAUT_EXPECTS(task.start && task.goal);
  const std::uint32_t width = task.grid.width;
  const std::string padding(width > 3 ? width - 3 : 0, ',');
  std::string out = fmt::format("start,{},{}{}\ngoal,{},{}{}\n", task.start->row, task.start->column, padding,
                                task.goal->row, task.goal->column, padding);
  for (std::size_t i = 0; i < task.grid.blocked.size(); ++i) {
    out += task.grid.blocked[i] ? '1' : '0';
    out += (i + 1) % width == 0 ? '\n' : ',';
  }
  return out;
}

GridTask read_grid_drawing(std::string_view text, const std::string& source) {
  GridTask task;
  for (detail::Lines lines(text); lines.next();) {
    if (lines.line().empty()) continue;
    const SourceLine place{source, lines.number()};
    if (task.grid.height == 0) task.grid.width = static_cast<std::uint32_t>(lines.line().size());
    std::uint32_t column = 0;
    for (const char c : lines.line()) draw_cell(task, c, column++, place);
    if (column != task.grid.width)
      place.fail(fmt::format("row {} has {} cells, those before it {}", task.grid.height, column, task.grid.width));
    if (task.grid.blocked.size() > kMostCells) place.fail("more than 400000000 cells");
    ++task.grid.height;
  }
  if (task.grid.height == 0) throw InputError(source, 0, "file is empty");
  return task;
}

GridTask read_grid(std::string_view text, const std::string& source) {
  detail::Lines lines(text);
  while (lines.next() && is_blank(lines.line())) {
  }
  const std::string_view first = detail::trimmed(lines.line());
  if (first.starts_with("type")) return {read_movingai_map(text, source), {}, {}};
  if (first.starts_with("start") || first.starts_with("goal") || first.find(',') != std::string_view::npos)
    return read_grid_csv(text, source);
  return read_grid_drawing(text, source);
}

}  // namespace taut
