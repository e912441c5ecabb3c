#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/occupancy_world.h>
#include <taut/io/worlds/detail/formats.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut::detail {

namespace {

constexpr std::size_t kLongestSide = 20000;
constexpr std::string_view kFree = " ._", kStart = "SsA", kGoal = "GgEBX";

bool is_one_of(char c, std::string_view set) { return set.find(c) != std::string_view::npos; }

bool is_block_character(char c) {
  return c == '#' || is_one_of(c, kFree) || is_one_of(c, kStart) || is_one_of(c, kGoal);
}

bool is_matrix_character(char c) { return is_one_of(c, "01 ,\t[]"); }

// The digits of a row of a matrix, and how many words they stand in.
struct MatrixRow {
  std::string digits;
  std::size_t words = 0;
  bool has_brackets = false;
};

MatrixRow matrix_row(std::string_view line) {
  MatrixRow row;
  bool inside = false;
  for (const char c : line) {
    const bool digit = c == '0' || c == '1';
    row.words += digit && !inside;
    inside = digit;
    row.has_brackets |= c == '[' || c == ']';
    if (digit) row.digits += c;
  }
  return row;
}

// Rows of 4 or 5 numbers are walls, of 6 cells of a .num file: only other rows can be told from them.
bool is_plainly_matrix(const MatrixRow& row) {
  const bool separated = row.words == row.digits.size();
  return row.has_brackets || !separated || row.words < 4 || row.words > 6;
}

struct Rows {
  std::vector<std::pair<std::string_view, int>> lines;  // with their numbers; none that is blank at the ends
};

Rows rows_of(std::string_view bytes) {
  Rows rows;
  for (Lines lines(bytes); lines.next();) rows.lines.emplace_back(lines.line(), lines.number());
  while (!rows.lines.empty() && rows.lines.back().first.empty()) rows.lines.pop_back();
  const auto first = std::ranges::find_if(rows.lines, [](const auto& line) { return !line.first.empty(); });
  rows.lines.erase(rows.lines.begin(), first);
  return rows;
}

bool is_blocks(const Rows& rows) {
  bool has_block = false;
  for (const auto& [line, number] : rows.lines) {
    if (!std::ranges::all_of(line, is_block_character)) return false;
    has_block |= line.find('#') != std::string_view::npos;
  }
  return has_block;
}

bool is_matrix(const Rows& rows) {
  std::size_t width = 0;
  for (const auto& [line, number] : rows.lines) {
    if (!std::ranges::all_of(line, is_matrix_character)) return false;
    const MatrixRow row = matrix_row(line);
    if (row.digits.empty()) continue;  // a line with a bracket alone
    if (row.digits.size() < 2 || !is_plainly_matrix(row) || (width != 0 && row.digits.size() != width)) return false;
    width = row.digits.size();
  }
  return width > 0;
}

class Blocks {
 public:
  Blocks(const Rows& rows, bool matrix, const std::string& source) : source_(source) {
    for (const auto& [line, number] : rows.lines) {
      std::string cells = matrix ? matrix_row(line).digits : std::string(line);
      if (matrix && cells.empty()) continue;
      width_ = std::max(width_, cells.size());
      if (width_ > kLongestSide) SourceLine{source_, number}.fail("more than 20000 cells in a row");
      cells_.push_back(std::move(cells));
      numbers_.push_back(number);
    }
    if (cells_.size() > kLongestSide) SourceLine{source_, numbers_.back()}.fail("more than 20000 rows");
  }

  WorldParts read() {
    OccupancyGrid grid{static_cast<std::uint32_t>(width_), static_cast<std::uint32_t>(cells_.size()), {}};
    grid.blocked.assign(width_ * cells_.size(), 0);
    std::optional<Point> start, goal;
    for (std::size_t row = 0; row < cells_.size(); ++row)
      for (std::size_t column = 0; column < cells_[row].size(); ++column) {
        const char c = cells_[row][column];
        if (c == '#' || c == '1') grid.blocked[row * width_ + column] = 1;
        if (is_one_of(c, kStart)) take(start, c, row, column);
        if (is_one_of(c, kGoal)) take(goal, c, row, column);
      }
    const auto height = static_cast<double>(cells_.size());
    const auto corner = [&](std::uint32_t column, std::uint32_t row) {
      return Point{static_cast<double>(column), height - static_cast<double>(row)};
    };
    WorldParts parts = parts_of(grid, corner, source_);
    parts.start = start;
    parts.goal.point = goal;
    return parts;
  }

 private:
  void take(std::optional<Point>& end, char c, std::size_t row, std::size_t column) const {
    if (end)
      SourceLine{source_, numbers_[row]}.fail(std::string("a second '") + c + "' in column " +
                                              std::to_string(column + 1));
    end = Point{static_cast<double>(column) + 0.5, static_cast<double>(cells_.size() - row) - 0.5};
  }

  const std::string& source_;
  std::size_t width_ = 0;
  std::vector<std::string> cells_;
  std::vector<int> numbers_;
};

}  // namespace

bool looks_like_blocks(std::string_view bytes) {
  const Rows rows = rows_of(bytes);
  return rows.lines.size() > 1 && (is_blocks(rows) || is_matrix(rows));
}

WorldParts read_blocks(std::string_view bytes, const std::string& source) {
  const Rows rows = rows_of(bytes);
  const bool matrix = is_matrix(rows);
  if (!matrix)
    for (const auto& [line, number] : rows.lines) {
      const auto odd = std::ranges::find_if_not(line, is_block_character);
      if (odd != line.end())
        SourceLine{source, number}.fail(quoted(std::string_view(&*odd, 1)) +
                                        " is no cell; cells are # or blank, S and G");
    }
  return Blocks(rows, matrix, source).read();
}

}  // namespace taut::detail
