#include <algorithm>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/detail/cell_walls.h>
#include <taut/io/worlds/write_world.h>

namespace taut {

namespace {

[[noreturn]] void fail(const char* format, const std::string& what) {
  throw InputError("", 0, std::string(format) + " cannot hold " + what);
}

std::string size_of(const GridMaze& maze) {
  return std::to_string(maze.width()) + " x " + std::to_string(maze.height());
}

// The ends that readers of formats without marks assume.
void check_unmarked_ends(const GridMaze& maze, const char* format) {
  if (maze.start != Cell{0, 0}) fail(format, "a start other than the bottom left cell");
  std::vector<Cell> goal = maze.goal;
  std::sort(goal.begin(), goal.end());
  const bool openings = detail::count_openings(maze) == 2;
  if (openings && !goal.empty()) fail(format, "a goal room beside two openings of the border");
  if (!openings && goal != centre_room(maze.width(), maze.height()))
    fail(format, "a goal other than the room in the middle");
}

int walls_of(const GridMaze& maze, Cell c) {
  int bits = 0;
  for (Side side : kSides) bits |= (maze.wall(c, side) ? 1 : 0) << static_cast<int>(side);
  return bits;
}

// The row of posts below the cells of height y; y == height: the topmost.
void append_posts(const GridMaze& maze, int y, std::string& out) {
  for (int x = 0; x < maze.width(); ++x) {
    const bool stands = y < maze.height() ? maze.wall({x, y}, Side::south) : maze.wall({x, y - 1}, Side::north);
    out += stands ? "o---" : "o   ";
  }
  out += "o\n";
}

}  // namespace

std::string write_drawing(const GridMaze& maze) {
  if (maze.goal.empty() && (maze.start != Cell{0, 0} || detail::count_openings(maze) != 2))
    fail("drawing", "a maze without goal");
  const auto width = static_cast<std::size_t>(maze.width());
  std::vector<std::string> rows(static_cast<std::size_t>(maze.height()), std::string(4 * width + 1, ' '));
  for (int y = 0; y < maze.height(); ++y) {
    std::string& row = rows[static_cast<std::size_t>(y)];
    for (int x = 0; x < maze.width(); ++x)
      if (maze.wall({x, y}, Side::west)) row[4 * static_cast<std::size_t>(x)] = '|';
    if (maze.wall({maze.width() - 1, y}, Side::east)) row.back() = '|';
  }
  const auto mark = [&](Cell c, std::size_t offset, char what) {
    rows[static_cast<std::size_t>(c.y)][4 * static_cast<std::size_t>(c.x) + offset] = what;
  };
  for (Cell c : maze.goal) mark(c, c == maze.start ? 3 : 2, 'G');
  if (!maze.goal.empty()) mark(maze.start, 2, 'S');
  std::string out;
  out.reserve((rows.size() * 2 + 1) * (4 * width + 2));
  for (int y = maze.height(); y > 0; --y) {
    append_posts(maze, y, out);
    out.append(rows[static_cast<std::size_t>(y - 1)]).append("\n");
  }
  append_posts(maze, 0, out);
  return out;
}

std::string write_cell_values(const GridMaze& maze) {
  const int n = maze.width();
  if (n != maze.height() || n < 2 || n > 256)
    fail("cells", "a maze of " + size_of(maze) + ", only squares of 2 to 256 a side");
  if (detail::count_openings(maze) != 0) fail("cells", "openings of the border");
  check_unmarked_ends(maze, "cells");
  std::string out = std::to_string(n) + "\n";
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y) out.append(std::to_string(15 - walls_of(maze, {x, y}))).append(y + 1 < n ? "," : "\n");
  return out;
}

std::string write_maz(const GridMaze& maze) {
  if (maze.width() != maze.height() || (maze.width() != 16 && maze.width() != 32))
    fail("maz", "a maze of " + size_of(maze) + ", only 16 x 16 and 32 x 32");
  check_unmarked_ends(maze, "maz");
  std::string out;
  for (int x = 0; x < maze.width(); ++x)
    for (int y = 0; y < maze.height(); ++y) out += static_cast<char>(walls_of(maze, {x, y}));
  return out;
}

std::string write_num(const GridMaze& maze) {
  check_unmarked_ends(maze, "num");
  std::string out;
  for (int x = 0; x < maze.width(); ++x)
    for (int y = 0; y < maze.height(); ++y) {
      out.append(std::to_string(x)).append(" ").append(std::to_string(y));
      for (Side side : kSides) out += maze.wall({x, y}, side) ? " 1" : " 0";
      out += '\n';
    }
  return out;
}

}  // namespace taut
