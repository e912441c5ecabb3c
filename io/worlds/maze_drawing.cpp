#include <algorithm>
#include <optional>
#include <vector>

#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/cell_walls.h>
#include <taut/io/worlds/detail/formats.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut::detail {

namespace {

constexpr int kLargestSize = 20000;

bool is_post(char c) { return c == 'o' || c == '+'; }

bool begins_comment(char c) { return c == ' ' || c == '\t' || c == '#' || c == '/' || c == ';'; }

// Blank where the line is too short.
char at(std::string_view line, std::size_t column) { return column < line.size() ? line[column] : ' '; }

enum class Stretch { wall, gap, unknown, none };

// What stands between two posts: `---`, blanks, or one `.` among blanks.
Stretch stretch_of(std::string_view between) {
  if (between.find_first_not_of('-') == std::string_view::npos) return Stretch::wall;
  if (between.find_first_not_of(" .") != std::string_view::npos) return Stretch::none;
  const std::size_t dot = between.find('.');
  if (dot == std::string_view::npos) return Stretch::gap;
  return between.find('.', dot + 1) == std::string_view::npos ? Stretch::unknown : Stretch::none;
}

// From one post of a row to the next, 2 or more; 0 when it is no row of posts.
std::size_t pitch_of(std::string_view line) {
  if (line.empty() || !is_post(line[0])) return 0;
  const std::size_t next = line.find_first_of("o+", 1);
  if (next == std::string_view::npos || next < 2) return 0;
  return stretch_of(line.substr(1, next - 1)) == Stretch::none ? 0 : next;
}

// How many cells wide a row of posts is; 0 when it is none.
int width_of(std::string_view line, std::size_t pitch) {
  if (pitch == 0 || line.empty() || !is_post(line[0])) return 0;
  std::size_t column = 0;
  while (column + pitch < line.size() && is_post(line[column + pitch]) &&
         stretch_of(line.substr(column + 1, pitch - 1)) != Stretch::none)
    column += pitch;
  return static_cast<int>(column / pitch);
}

struct NumberedLine {
  std::string_view text;
  int number = 0;
};

class Drawing {
 public:
  Drawing(std::string_view bytes, const std::string& source) : source_(source) {
    find_rows(bytes);
    check_size();
  }

  GridMaze read(std::size_t& unknown_walls) {
    GridMaze maze(width_, height_, true);
    for (int y = 0; y <= height_; ++y) read_posts(y, maze);
    for (int y = height_ - 1; y >= 0; --y) read_cells(y, maze);
    std::sort(maze.goal.begin(), maze.goal.end());
    if (start_) maze.start = *start_;
    const bool from_opening_to_opening = !start_ && maze.goal.empty() && count_openings(maze) == 2;
    if (maze.goal.empty() && !from_opening_to_opening) maze.goal = centre_room(width_, height_);
    unknown_walls = unknown_;
    return maze;
  }

 private:
  SourceLine place(const NumberedLine& line) const { return {source_, line.number}; }

  // Rows alternate between posts and cells; the first and the last are posts. What comes before and after is comment.
  void find_rows(std::string_view bytes) {
    std::vector<NumberedLine> all;
    for (Lines lines(bytes); lines.next();) all.push_back({lines.line(), lines.number()});
    std::size_t first = 0;
    while (first < all.size() && pitch_of(all[first].text) == 0) {
      const std::string_view line = trimmed(all[first].text);
      if (!line.empty() && line[0] != '*' && !begins_comment(line[0]))
        place(all[first]).fail("not a row of posts: " + quoted(line));
      ++first;
    }
    if (first == all.size()) throw InputError(source_, 0, "no row of posts ('o' or '+')");
    pitch_ = pitch_of(all[first].text);
    width_ = width_of(all[first].text, pitch_);
    for (std::size_t i = first + 2; i < all.size(); ++i)
      if (is_post(at(all[i].text, 0))) {
        rise_ = i - first;
        break;
      }
    std::size_t end = first + 1;
    while (end + rise_ - 1 < all.size() && is_post(at(all[end + rise_ - 1].text, 0))) end += rise_;
    rows_.assign(all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(end));
    for (std::size_t i = end; i < all.size(); ++i) {
      if (at(all[i].text, 0) == '|' && i == end && i + 1 < all.size())
        place(all[i + 1]).fail("a row of posts is expected, not " + quoted(all[i + 1].text));
      if (at(all[i].text, 0) == '|' || width_of(all[i].text, pitch_) > 0)
        place(all[i]).fail("this row does not belong to the drawing above");
    }
  }

  void check_size() {
    height_ = static_cast<int>(rows_.size() / rise_);
    if (height_ == 0) place(rows_[0]).fail("the drawing has no row of cells");
    if (width_ > kLargestSize || height_ > kLargestSize)
      place(rows_[0]).fail("the drawing is more than " + std::to_string(kLargestSize) + " cells wide or high");
    const std::size_t full = pitch_ * static_cast<std::size_t>(width_) + 1;
    for (const NumberedLine& row : rows_)
      if (width_of(row.text, pitch_) > width_ || (row.text.size() > full && !begins_comment(row.text[full])))
        place(row).fail("the row is longer than the " + std::to_string(width_) + " cells of the first row");
  }

  // The row of posts below the cells of height y; y == height: the topmost.
  void read_posts(int y, GridMaze& maze) {
    const NumberedLine& row = rows_[rows_.size() - 1 - rise_ * static_cast<std::size_t>(y)];
    for (int x = 0; x <= width_; ++x) {
      const std::size_t column = pitch_ * static_cast<std::size_t>(x);
      if (!is_post(at(row.text, column))) fail_at(row, column, "is no post ('o' or '+')");
      if (x == width_) break;
      const bool stands = horizontal(row, column + 1, y == 0 || y == height_);
      if (y < height_)
        maze.set_wall({x, y}, Side::south, stands);
      else
        maze.set_wall({x, y - 1}, Side::north, stands);
    }
  }

  bool horizontal(const NumberedLine& row, std::size_t column, bool border) {
    std::string between;
    for (std::size_t i = 0; i + 1 < pitch_; ++i) between += at(row.text, column + i);
    switch (stretch_of(between)) {
      case Stretch::wall: return true;
      case Stretch::gap: return false;
      case Stretch::unknown: return unknown(border);
      case Stretch::none: break;
    }
    fail_at(row, column, "begins no wall ('---', '   ' or ' . ')");
  }

  bool unknown(bool border) {
    ++unknown_;
    return border;
  }

  void read_cells(int y, GridMaze& maze) {
    const std::size_t below = rows_.size() - 1 - rise_ * static_cast<std::size_t>(y), top = below - (rise_ - 1);
    for (int x = 0; x <= width_; ++x) {
      const std::size_t column = pitch_ * static_cast<std::size_t>(x);
      const bool stands = vertical(top, column, x == 0 || x == width_);
      if (x == width_)
        maze.set_wall({x - 1, y}, Side::east, stands);
      else
        maze.set_wall({x, y}, Side::west, stands);
      for (std::size_t row = top; row < below && x < width_; ++row)
        for (std::size_t i = 1; i < pitch_; ++i) mark({x, y}, rows_[row], column + i, maze);
    }
  }

  // The wall whose uppermost character is in row `top`: the same all the way down.
  bool vertical(std::size_t top, std::size_t column, bool border) {
    const char c = at(rows_[top].text, column);
    if (c != '|' && c != ' ' && c != '.') fail_at(rows_[top], column, "is no wall ('|', ' ' or '.')");
    for (std::size_t row = top + 1; row < top + rise_ - 1; ++row)
      if (at(rows_[row].text, column) != c)
        fail_at(rows_[row], column, "where the wall above it is " + quoted(std::string(1, c)));
    return c == '.' ? unknown(border) : c == '|';
  }

  void mark(Cell cell, const NumberedLine& row, std::size_t column, GridMaze& maze) {
    const char c = at(row.text, column);
    if (c == ' ') return;
    if (c == 'G') {
      if (std::find(maze.goal.begin(), maze.goal.end(), cell) == maze.goal.end()) maze.goal.push_back(cell);
    } else if (c == 'S') {
      if (start_) place(row).fail("a second start, in cell " + text(cell) + "; the first is in cell " + text(*start_));
      start_ = cell;
    } else {
      fail_at(row, column, "in cell " + text(cell) + " is neither S nor G");
    }
  }

  [[noreturn]] void fail_at(const NumberedLine& row, std::size_t column, const std::string& message) const {
    place(row).fail("column " + std::to_string(column + 1) + ": " + quoted(std::string(1, at(row.text, column))) + " " +
                    message);
  }

  const std::string& source_;
  std::vector<NumberedLine> rows_;
  std::size_t pitch_ = 4;  // from post to post, in a row
  std::size_t rise_ = 2;   // and from row of posts to row of posts
  int width_ = 0;
  int height_ = 0;
  std::optional<Cell> start_;
  std::size_t unknown_ = 0;
};

}  // namespace

bool is_row_of_posts(std::string_view line) { return pitch_of(line) > 0; }

GridMaze read_drawing(std::string_view bytes, const std::string& source, std::size_t& unknown_walls) {
  return Drawing(bytes, source).read(unknown_walls);
}

}  // namespace taut::detail
