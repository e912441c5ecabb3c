#include <taut/robots/roadblocks/road_map.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include <taut/geometry/detail/text.h>
#include <taut/geometry/errors.h>

namespace taut::car {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

std::string quoted(std::string_view word) {
  std::string out = "'";
  for (const char c : word.substr(0, 40)) out += c < ' ' || c > '~' ? '?' : c;
  return out + (word.size() > 40 ? "...'" : "'");
}

/// A file line by line, a line word by word.
class Lines {
 public:
  Lines(std::string_view bytes, const std::string& source) : rest_(bytes), source_(source) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    if (rest_.ends_with('\x1a')) rest_.remove_suffix(1);
  }

  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    while (!line_.empty() && is_blank(line_.back())) line_.remove_suffix(1);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    words_ = line_;
    ++number_;
    return true;
  }

  /// The next line that is neither empty nor a comment.
  bool next_said() {
    while (next()) {
      skip_blanks();
      if (!words_.empty() && words_.front() != '#') return true;
    }
    return false;
  }

  std::string_view line() const { return line_; }
  int number() const { return number_; }

  std::string_view word() {
    skip_blanks();
    std::size_t end = 0;
    while (end < words_.size() && !is_blank(words_[end])) ++end;
    const std::string_view word = words_.substr(0, end);
    words_.remove_prefix(end);
    return word;
  }

  double number(const char* what) {
    const std::string_view word = needed(what);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      fail(std::string(what) + " " + quoted(word) + " is not a number");
    return value;
  }

  int whole(const char* what, int least, int most) {
    const std::string_view word = needed(what);
    int value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || value < least || value > most)
      fail(std::string(what) + " " + quoted(word) + " is not a whole number between " + std::to_string(least) +
           " and " + std::to_string(most));
    return value;
  }

  void end_line() {
    if (const std::string_view more = word(); !more.empty() && more.front() != '#')
      fail(quoted(more) + " is more than the line needs");
  }

  [[noreturn]] void fail(const std::string& message) const { throw InputError(source_, number_, message); }

 private:
  void skip_blanks() {
    while (!words_.empty() && is_blank(words_.front())) words_.remove_prefix(1);
  }

  std::string_view needed(const char* what) {
    const std::string_view found = word();
    if (found.empty()) fail(std::string(what) + " is missing");
    return found;
  }

  std::string_view rest_, line_, words_;
  const std::string& source_;
  int number_ = 0;
};

/// A roadblock's line.
struct Declared {
  Roadblock block;
  Point at;
  int line = 0;
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& source) : lines_(bytes, source), source_(source) {}

  RoadMap read() {
    read_header();
    read_grid();
    gather_roadblocks();
    require_inside(course().start, "start", start_line_);
    require_inside(course().goal, "goal", goal_line_);
    read_samples();
    return std::move(map_);
  }

 private:
  Course& course() { return map_.course; }

  void read_header() {
    while (lines_.next_said()) {
      const std::string_view key = lines_.word();
      if (key == "start")
        course().start = point(start_line_, "start");
      else if (key == "goal")
        course().goal = point(goal_line_, "goal");
      else if (key == "roadblock")
        read_roadblock();
      else if (key == "grid")
        return read_size();
      else
        lines_.fail(quoted(key) + " is none of start, goal, roadblock and grid");
    }
    lines_.fail("there is no line `grid WIDTH HEIGHT`");
  }

  Point point(int& line, const char* what) {
    if (line != 0) lines_.fail(std::string("a second ") + what + "; the first is in line " + std::to_string(line));
    line = lines_.number();
    const double x = lines_.number("X");
    const double y = lines_.number("Y");
    lines_.end_line();
    return {x, y};
  }

  void read_roadblock() {
    const std::string_view letter = lines_.word();
    if (letter.size() != 1 || letter[0] < 'A' || letter[0] > 'Z')
      lines_.fail("roadblock " + quoted(letter) + " is not a letter from A to Z");
    std::optional<Declared>& declared = declared_[static_cast<std::size_t>(letter[0] - 'A')];
    if (declared)
      lines_.fail("a second roadblock " + std::string(letter) + "; the first is in line " +
                  std::to_string(declared->line));
    declared.emplace();
    declared->block.letter = letter[0];
    declared->line = lines_.number();
    declared->at.x = lines_.number("X");
    declared->at.y = lines_.number("Y");
    read_probability(declared->block);
  }

  void read_probability(Roadblock& block) {
    Lines ahead = lines_;
    const std::string_view word = ahead.word();
    if (word.empty() || word.front() == '#') return;
    block.open_probability = lines_.number("P_OPEN");
    if (block.open_probability < 0 || block.open_probability > 1)
      lines_.fail("P_OPEN " + quoted(word) + " is not between 0 and 1");
    lines_.end_line();
  }

  void read_size() {
    grid_line_ = lines_.number();
    course().width = lines_.whole("WIDTH", 1, kLargestSide);
    course().height = lines_.whole("HEIGHT", 1, kLargestSide);
    lines_.end_line();
    if (start_line_ == 0) lines_.fail("there is no line `start X Y` before the grid");
    if (goal_line_ == 0) lines_.fail("there is no line `goal X Y` before the grid");
  }

  void read_grid() {
    for (int y = 1; y <= course().height; ++y) {
      if (!lines_.next())
        lines_.fail("the grid ends after " + std::to_string(y - 1) + " rows; line " + std::to_string(grid_line_) +
                    " says " + std::to_string(course().height));
      const std::string_view row = lines_.line();
      if (row.size() != static_cast<std::size_t>(course().width))
        lines_.fail("a row of " + std::to_string(row.size()) + " cells; line " + std::to_string(grid_line_) + " says " +
                    std::to_string(course().width));
      for (int x = 1; x <= course().width; ++x) read_cell({x, y}, row[static_cast<std::size_t>(x - 1)]);
    }
  }

  void read_cell(Cell c, char what) {
    course().walls.push_back(what == '#');
    if (what == '#' || what == '.') return;
    if (what < 'A' || what > 'Z')
      lines_.fail(quoted({&what, 1}) + " in column " + std::to_string(c.x) +
                  " is none of # . and a roadblock's letter");
    std::optional<Declared>& declared = declared_[static_cast<std::size_t>(what - 'A')];
    if (!declared)
      lines_.fail("column " + std::to_string(c.x) + " is of the roadblock " + what +
                  ", which no line before the grid names");
    declared->block.cells.push_back(c);
  }

  void gather_roadblocks() {
    for (const std::optional<Declared>& declared : declared_) {
      if (!declared) continue;
      const Roadblock& block = declared->block;
      if (block.cells.empty())
        throw InputError(source_, declared->line, std::string("the grid has no cell of the roadblock ") + block.letter);
      const auto [left, right] = std::ranges::minmax(block.cells, {}, &Cell::x);
      const auto [top, bottom] = std::ranges::minmax(block.cells, {}, &Cell::y);
      const Point at = declared->at;
      if (at.x < left.x || at.x > right.x || at.y < top.y || at.y > bottom.y)
        throw InputError(source_, declared->line,
                         std::string("the roadblock ") + block.letter + " is at " + detail::text(left) +
                             " in the grid, not at " + detail::text(at));
      course().roadblocks.push_back(block);
    }
  }

  void require_inside(Point p, const char* what, int line) {
    if (!(p.x >= 1 && p.x <= course().width && p.y >= 1 && p.y <= course().height))
      throw InputError(source_, line, std::string(what) + " " + detail::text(p) + " is not within the grid");
  }

  void read_samples() {
    if (!lines_.next_said()) return;
    if (const std::string_view key = lines_.word(); key != "samples")
      lines_.fail(quoted(key) + " after the grid is not `samples K`");
    const int count = lines_.whole("K", 0, 1'000'000);
    for (int i = 0; i < count; ++i) {
      if (!lines_.next_said())
        lines_.fail("the samples end after " + std::to_string(i) + " of " + std::to_string(count));
      Sample sample;
      sample.number = lines_.whole("I", 0, 1'000'000'000);
      for (const Sample& other : map_.samples)
        if (other.number == sample.number) lines_.fail("a second sample " + std::to_string(sample.number));
      sample.open = roadblocks_of(lines_.word(), course(), source_, lines_.number());
      lines_.end_line();
      map_.samples.push_back(sample);
    }
    if (lines_.next_said()) lines_.fail("more than " + std::to_string(count) + " samples");
  }

  Lines lines_;
  const std::string& source_;
  RoadMap map_;
  std::array<std::optional<Declared>, 26> declared_;
  int start_line_ = 0, goal_line_ = 0, grid_line_ = 0;
};

}  // namespace

RoadMap read_road_map(std::string_view bytes, const std::string& source) { return Reader(bytes, source).read(); }

RoadblockSet roadblocks_of(std::string_view bits, const Course& course, const std::string& source, int line) {
  if (bits.size() != course.roadblocks.size())
    throw InputError(source, line,
                     quoted(bits) + " has " + std::to_string(bits.size()) + " characters for " +
                         std::to_string(course.roadblocks.size()) + " roadblocks");
  RoadblockSet open = 0;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    if (bits[i] != '0' && bits[i] != '1') throw InputError(source, line, quoted(bits) + " is not made of 0 and 1");
    if (bits[i] == '1') open |= RoadblockSet{1} << i;
  }
  return open;
}

std::string bits_of(RoadblockSet open, const Course& course) {
  std::string bits;
  for (std::size_t i = 0; i < course.roadblocks.size(); ++i) bits += (open >> i) & 1 ? '1' : '0';
  return bits;
}

}  // namespace taut::car
