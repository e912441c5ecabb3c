#include <algorithm>
#include <array>
#include <vector>

#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/cell_walls.h>
#include <taut/io/worlds/detail/formats.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut::detail {

namespace {

constexpr int kLargestCoordinate = 19999;

struct Row {
  Cell cell;
  std::uint8_t walls = 0;
  int line = 0;
};

Row read_row(std::string_view line, const SourceLine& place) {
  static constexpr std::array names{"X", "Y", "N", "E", "S", "W"};
  std::array<int, 6> values{};
  Fields fields(line, place);
  std::string_view field;
  std::size_t n = 0;
  for (; fields.next(field); ++n) {
    if (n == 6) place.fail("more than the six numbers X Y N E S W");
    values[n] = whole(field, 0, n < 2 ? kLargestCoordinate : 1, names[n], place);
  }
  if (n < 6) place.fail("only " + std::to_string(n) + " of the six numbers X Y N E S W");
  const int walls = values[2] | values[3] << 1 | values[4] << 2 | values[5] << 3;
  return {{values[0], values[1]}, static_cast<std::uint8_t>(walls), place.line};
}

std::vector<Row> read_rows(std::string_view bytes, const std::string& source) {
  std::vector<Row> rows;
  Lines lines(bytes);
  while (lines.next()) {
    const std::string_view line = lines.line().substr(0, lines.line().find('#'));
    if (!trimmed(line).empty()) rows.push_back(read_row(line, {source, lines.number()}));
  }
  if (rows.empty()) throw InputError(source, 0, "file is empty");
  return rows;
}

void check_once_each(std::vector<Row> rows, int width, int height, const std::string& source) {
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.cell < b.cell; });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && rows[i].cell == rows[i - 1].cell)
      SourceLine{source, rows[i].line}.fail("cell " + text(rows[i].cell) + " was already given in line " +
                                            std::to_string(rows[i - 1].line));
    const auto h = static_cast<std::size_t>(height);
    const Cell expected{static_cast<int>(i / h), static_cast<int>(i % h)};
    if (rows[i].cell != expected) throw InputError(source, 0, "cell " + text(expected) + " is missing");
  }
  const auto cells = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (rows.size() < cells)
    throw InputError(source, 0,
                     "cell " + text(Cell{width - 1, static_cast<int>(rows.size() % static_cast<std::size_t>(height))}) +
                         " is missing");
}

}  // namespace

GridMaze read_num(std::string_view bytes, const std::string& source) {
  const std::vector<Row> rows = read_rows(bytes, source);
  int width = 0, height = 0;
  for (const Row& row : rows) {
    width = std::max(width, row.cell.x + 1);
    height = std::max(height, row.cell.y + 1);
  }
  check_once_each(rows, width, height, source);
  CellWalls cells(width, height);
  for (const Row& row : rows) cells.set(row.cell, row.walls, row.line);
  GridMaze maze = agreed(cells, false, source);
  if (count_openings(maze) != 2) maze.goal = centre_room(width, height);
  return maze;
}

}  // namespace taut::detail
