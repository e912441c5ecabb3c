#include <taut/io/worlds/roadblock_map.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <taut/geometry/errors.h>
#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut {

namespace {

using detail::quoted;
using roadblocks::Course;
using roadblocks::kLargestSide;
using roadblocks::Roadblock;
using roadblocks::RoadblockMap;
using roadblocks::RoadblockSet;
using roadblocks::Sample;

/// A roadblock's line.
struct Declared {
  Roadblock block;
  Point at;
  int line = 0;
};

/// Line by line, a line word by word.
class Reader {
 public:
  Reader(std::string_view bytes, const std::string& source) : lines_(bytes), place_{source} {}

  RoadblockMap read() {
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

  bool next_line() {
    if (!lines_.next()) return false;
    place_.line = lines_.number();
    return true;
  }

  /// The next line that is neither empty nor a comment.
  bool next_said() {
    while (next_line()) {
      const std::string_view line = detail::trimmed(lines_.line());
      if (line.empty() || line.front() == '#') continue;
      words_.emplace(line, place_);
      return true;
    }
    return false;
  }

  /// Empty at the end of the line, and where a remark begins.
  std::string_view word() {
    std::string_view word;
    return words_->next(word) && word.front() != '#' ? word : std::string_view();
  }

  std::string_view needed(const char* what) {
    const std::string_view found = word();
    if (found.empty()) place_.fail(std::string(what) + " is missing");
    return found;
  }

  double number(const char* what) { return detail::coordinate(needed(what), place_); }
  int whole(const char* what, int least, int most) { return detail::whole(needed(what), least, most, what, place_); }

  void end_line() {
    if (const std::string_view more = word(); !more.empty()) place_.fail(quoted(more) + " is more than the line needs");
  }

  void read_header() {
    while (next_said()) {
      const std::string_view key = word();
      if (key == "start")
        course().start = point(start_line_, "start");
      else if (key == "goal")
        course().goal = point(goal_line_, "goal");
      else if (key == "roadblock")
        read_roadblock();
      else if (key == "grid")
        return read_size();
      else
        place_.fail(quoted(key) + " is none of start, goal, roadblock and grid");
    }
    place_.fail("there is no line `grid WIDTH HEIGHT`");
  }

  Point point(int& line, const char* what) {
    if (line != 0) place_.fail(std::string("a second ") + what + "; the first is in line " + std::to_string(line));
    line = lines_.number();
    const double x = number("X");
    const double y = number("Y");
    end_line();
    return {x, y};
  }

  void read_roadblock() {
    const std::string_view letter = word();
    if (letter.size() != 1 || letter[0] < 'A' || letter[0] > 'Z')
      place_.fail("roadblock " + quoted(letter) + " is not a letter from A to Z");
    std::optional<Declared>& declared = declared_[static_cast<std::size_t>(letter[0] - 'A')];
    if (declared)
      place_.fail("a second roadblock " + std::string(letter) + "; the first is in line " +
                  std::to_string(declared->line));
    declared.emplace();
    declared->block.letter = letter[0];
    declared->line = lines_.number();
    declared->at.x = number("X");
    declared->at.y = number("Y");
    read_probability(declared->block);
  }

  void read_probability(Roadblock& block) {
    const std::string_view word = this->word();
    if (word.empty()) return;
    block.open_probability = detail::coordinate(word, place_);
    if (block.open_probability < 0 || block.open_probability > 1)
      place_.fail("P_OPEN " + quoted(word) + " is not between 0 and 1");
    end_line();
  }

  void read_size() {
    grid_line_ = lines_.number();
    course().width = whole("WIDTH", 1, kLargestSide);
    course().height = whole("HEIGHT", 1, kLargestSide);
    end_line();
    if (start_line_ == 0) place_.fail("there is no line `start X Y` before the grid");
    if (goal_line_ == 0) place_.fail("there is no line `goal X Y` before the grid");
  }

  void read_grid() {
    for (int y = 1; y <= course().height; ++y) {
      if (!next_line())
        place_.fail("the grid ends after " + std::to_string(y - 1) + " rows; line " + std::to_string(grid_line_) +
                    " says " + std::to_string(course().height));
      const std::string_view row = lines_.line();
      if (row.size() != static_cast<std::size_t>(course().width))
        place_.fail("a row of " + std::to_string(row.size()) + " cells; line " + std::to_string(grid_line_) + " says " +
                    std::to_string(course().width));
      for (int x = 1; x <= course().width; ++x) read_cell({x, y}, row[static_cast<std::size_t>(x - 1)]);
    }
  }

  void read_cell(Cell c, char what) {
    course().walls.push_back(what == '#');
    if (what == '#' || what == '.') return;
    if (what < 'A' || what > 'Z')
      place_.fail(quoted({&what, 1}) + " in column " + std::to_string(c.x) +
                  " is none of # . and a roadblock's letter");
    std::optional<Declared>& declared = declared_[static_cast<std::size_t>(what - 'A')];
    if (!declared)
      place_.fail("column " + std::to_string(c.x) + " is of the roadblock " + what +
                  ", which no line before the grid names");
    declared->block.cells.push_back(c);
  }

  void gather_roadblocks() {
    for (const std::optional<Declared>& declared : declared_) {
      if (!declared) continue;
      const Roadblock& block = declared->block;
      if (block.cells.empty())
        throw InputError(place_.source, declared->line,
                         std::string("the grid has no cell of the roadblock ") + block.letter);
      const auto [left, right] = std::ranges::minmax(block.cells, {}, &Cell::x);
      const auto [top, bottom] = std::ranges::minmax(block.cells, {}, &Cell::y);
      const Point at = declared->at;
      if (at.x < left.x || at.x > right.x || at.y < top.y || at.y > bottom.y)
        throw InputError(
            place_.source, declared->line,
            std::string("the roadblock ") + block.letter + " is at " + text(left) + " in the grid, not at " + text(at));
      course().roadblocks.push_back(block);
    }
  }

  void require_inside(Point p, const char* what, int line) {
    if (!(p.x >= 1 && p.x <= course().width && p.y >= 1 && p.y <= course().height))
      throw InputError(place_.source, line, std::string(what) + " " + text(p) + " is not within the grid");
  }

  void read_samples() {
    if (!next_said()) return;
    if (const std::string_view key = word(); key != "samples")
      place_.fail(quoted(key) + " after the grid is not `samples K`");
    const int count = whole("K", 0, 1'000'000);
    std::set<int> numbers;
    for (int i = 0; i < count; ++i) {
      if (!next_said()) place_.fail("the samples end after " + std::to_string(i) + " of " + std::to_string(count));
      Sample sample;
      sample.number = whole("I", 0, 1'000'000'000);
      if (!numbers.insert(sample.number).second) place_.fail("a second sample " + std::to_string(sample.number));
      sample.open = roadblocks_of(word(), course(), place_.source, place_.line);
      end_line();
      map_.samples.push_back(sample);
    }
    if (next_said()) place_.fail("more than " + std::to_string(count) + " samples");
  }

  detail::Lines lines_;
  detail::SourceLine place_;
  std::optional<detail::Fields> words_;
  RoadblockMap map_;
  std::array<std::optional<Declared>, 26> declared_;
  int start_line_ = 0, goal_line_ = 0, grid_line_ = 0;
};

}  // namespace

RoadblockMap read_roadblock_map(std::string_view bytes, const std::string& source) {
  return Reader(bytes, source).read();
}

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

std::string roadblock_map_text(const RoadblockMap& map, const std::string& remark) {
  const Course& course = map.course;
  std::vector<std::string> rows(static_cast<std::size_t>(course.height),
                                std::string(static_cast<std::size_t>(course.width), '.'));
  const auto put = [&](Cell c, char what) {
    rows[static_cast<std::size_t>(c.y - 1)][static_cast<std::size_t>(c.x - 1)] = what;
  };
  for (int y = 1; y <= course.height; ++y)
    for (int x = 1; x <= course.width; ++x)
      if (course.is_wall({x, y})) put({x, y}, '#');
  std::string text = remark.empty() ? "" : "# " + remark + "\n";
  text += "start " + taut::text(course.start.x) + " " + taut::text(course.start.y) + "\n";
  text += "goal " + taut::text(course.goal.x) + " " + taut::text(course.goal.y) + "\n";
  for (const Roadblock& block : course.roadblocks) {
    const Cell c = block.cells.front();
    text += std::string("roadblock ") + block.letter + " " + std::to_string(c.x) + " " + std::to_string(c.y) + " " +
            taut::text(block.open_probability) + "\n";
    for (const Cell cell : block.cells) put(cell, block.letter);
  }
  text += "grid " + std::to_string(course.width) + " " + std::to_string(course.height) + "\n";
  for (const std::string& row : rows) text += row + "\n";
  if (!map.samples.empty()) text += "samples " + std::to_string(map.samples.size()) + "\n";
  for (const Sample& sample : map.samples)
    text += std::to_string(sample.number) + " " + bits_of(sample.open, course) + "\n";
  return text;
}

}  // namespace taut
