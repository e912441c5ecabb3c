#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/cell_walls.h>
#include <taut/io/worlds/detail/formats.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut::detail {

namespace {

constexpr int kLargestSize = 256;

bool next_content(Lines& lines) {
  while (lines.next())
    if (!lines.line().empty() && lines.line()[0] != '#') return true;
  return false;
}

int read_size(Lines& lines, const std::string& source) {
  if (!next_content(lines)) throw InputError(source, 0, "file is empty");
  const SourceLine place{source, lines.number()};
  return whole(trimmed(lines.line()), 2, kLargestSize, "maze size", place);
}

// The file's bits are up, right, down, left, 1 = open: Side's order.
void read_column(int x, Lines& lines, CellWalls& cells, const std::string& source) {
  const int n = cells.height();
  const SourceLine place{source, lines.number()};
  Fields fields(lines.line(), place);
  std::string_view field;
  int y = 0;
  for (; fields.next(field); ++y) {
    if (y == n) place.fail("column " + std::to_string(x) + " has more than " + std::to_string(n) + " values");
    const int open = whole(field, 0, 15, ("value of cell " + text(Cell{x, y})).c_str(), place);
    cells.set({x, y}, static_cast<std::uint8_t>(15 - open), lines.number());
  }
  if (y < n)
    place.fail("column " + std::to_string(x) + " has " + std::to_string(y) + " values instead of " + std::to_string(n));
}

}  // namespace

GridMaze read_cell_values(std::string_view bytes, const std::string& source) {
  Lines lines(bytes);
  const int n = read_size(lines, source);
  CellWalls cells(n, n);
  for (int x = 0; x < n; ++x) {
    if (!next_content(lines))
      throw InputError(source, lines.number(),
                       "file ends after " + std::to_string(x) + " of " + std::to_string(n) + " columns");
    read_column(x, lines, cells, source);
  }
  if (next_content(lines)) SourceLine{source, lines.number()}.fail("more than " + std::to_string(n) + " columns");
  GridMaze maze = agreed(cells, true, source);
  maze.goal = centre_room(n, n);
  return maze;
}

}  // namespace taut::detail
