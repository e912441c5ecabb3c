#include <taut/io/worlds/movingai.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut {

namespace {

using detail::Lines;
using detail::SourceLine;

constexpr int kLargestSide = 65536;

/// `width 512`: the word and what follows it.
std::pair<std::string_view, std::string_view> split(std::string_view line) {
  line = detail::trimmed(line);
  const std::size_t end = line.find_first_of(" \t");
  if (end == std::string_view::npos) return {line, {}};
  return {line.substr(0, end), detail::trimmed(line.substr(end))};
}

class MapReader {
 public:
  MapReader(std::string_view text, const std::string& source) : lines_(text), source_(source) {}

  OccupancyGrid read() {
    read_header();
    grid_.blocked.reserve(std::size_t{grid_.width} * grid_.height);
    std::uint32_t rows = 0;
    while (lines_.next()) {
      if (lines_.line().empty()) continue;
      if (rows == grid_.height)
        here().fail(fmt::format("a row too many: line {} says height {}", height_line_, grid_.height));
      read_row(lines_.line());
      ++rows;
    }
    if (rows < grid_.height)
      here().fail(fmt::format("the map ends after {} rows; line {} says height {}", rows, height_line_, grid_.height));
    return std::move(grid_);
  }

 private:
  SourceLine here() const { return {source_, lines_.number()}; }

  void read_header() {
    int type_line = 0;
    while (lines_.next()) {
      const auto [word, value] = split(lines_.line());
      if (word.empty()) continue;
      if (word == "map" && value.empty()) {
        if (height_line_ == 0) here().fail("the header says no height");
        if (width_line_ == 0) here().fail("the header says no width");
        return;
      }
      if (word == "type") {
        once(type_line, word);
        if (value != "octile") here().fail("type " + detail::quoted(value) + " is not known, only octile");
      } else if (word == "height") {
        once(height_line_, word);
        grid_.height = side(value, "height");
      } else if (word == "width") {
        once(width_line_, word);
        grid_.width = side(value, "width");
      } else {
        here().fail(detail::quoted(lines_.line()) + " is none of type, height, width and map");
      }
    }
    here().fail("there is no line `map`, and no rows after it");
  }

  void once(int& line, std::string_view word) const {
    if (line != 0) here().fail(fmt::format("a second {}; the first is in line {}", word, line));
    line = lines_.number();
  }

  std::uint32_t side(std::string_view value, const char* what) const {
    return static_cast<std::uint32_t>(detail::whole(value, 1, kLargestSide, what, here()));
  }

  void read_row(std::string_view row) {
    if (row.size() != grid_.width)
      here().fail(fmt::format("a row of {} cells; line {} says width {}", row.size(), width_line_, grid_.width));
    for (std::size_t i = 0; i < row.size(); ++i) switch (row[i]) {
        case '.':
        case 'G':
        case 'S': grid_.blocked.push_back(0); break;
        case '@':
        case 'O':
        case 'T':
        case 'W': grid_.blocked.push_back(1); break;
        default:
          here().fail(fmt::format("{} in column {} is none of . G S @ O T W", detail::quoted(row.substr(i, 1)), i));
      }
  }

  Lines lines_;
  const std::string& source_;
  OccupancyGrid grid_;
  int height_line_ = 0, width_line_ = 0;
};

class ScenarioLine {
 public:
  ScenarioLine(std::string_view line, const SourceLine& place) : fields_(line, place), place_(place) {}

  std::string_view field(const char* what) {
    std::string_view field;
    if (!fields_.next(field))
      place_.fail(
          fmt::format("{} is missing; a line is bucket map width height start-x start-y goal-x goal-y length", what));
    return field;
  }
  std::uint32_t number(const char* what, int largest = std::numeric_limits<int>::max()) {
    return static_cast<std::uint32_t>(detail::whole(field(what), 0, largest, what, place_));
  }
  void end() {
    if (std::string_view rest; fields_.next(rest)) place_.fail(detail::quoted(rest) + " follows the length");
  }

 private:
  detail::Fields fields_;
  const SourceLine& place_;
};

int digits_after_point(std::string_view number) {
  const std::size_t point = number.find('.');
  return point == std::string_view::npos ? 0 : static_cast<int>(number.size() - point - 1);
}

int digits_before_point(std::string_view number) { return static_cast<int>(std::min(number.find('.'), number.size())); }

/// Unless all lengths have as many digits after the point, zeros at their ends were left out: then each has as many
/// digits as the longest.
void restore_zeros(std::vector<Scenario>& scenarios) {
  int most = 6;
  bool is_even = true;
  for (const Scenario& s : scenarios) {
    const int places = digits_after_point(s.optimal_text);
    most = std::max(most, places + digits_before_point(s.optimal_text));
    is_even = is_even && places > 0 && places == digits_after_point(scenarios.front().optimal_text);
  }
  if (is_even) return;
  for (Scenario& s : scenarios)
    s.places = std::max(digits_after_point(s.optimal_text), most - digits_before_point(s.optimal_text));
}

}  // namespace

double Scenario::unit() const { return std::pow(10.0, -std::min(places, 15)); }

bool Scenario::says_none() const { return optimal == 0 && (start_column != goal_column || start_row != goal_row); }

bool looks_like_scenario(std::string_view line) {
  static const std::string nowhere;
  const SourceLine place{nowhere, 0};
  detail::Fields fields(line, place);
  std::string_view field;
  int n = 0;
  if (line.find(',') != std::string_view::npos) return false;
  for (; fields.next(field); ++n) {
    const bool is_number = field.find_first_not_of("0123456789.") == std::string_view::npos;
    if (n < 8 && is_number == (n == 1)) return false;
  }
  return n == 9;
}

Scenario movingai_scenario(std::string_view line, const std::string& source, int number, ScenarioPlaces places) {
  const SourceLine place{source, number};
  ScenarioLine in(line, place);
  Scenario s{};
  s.line = static_cast<std::size_t>(place.line);
  s.bucket = in.number("the bucket");
  s.map = in.field("the map");
  s.width = in.number("the width", kLargestSide);
  s.height = in.number("the height", kLargestSide);
  s.start_column = in.number("the start's column", kLargestSide);
  s.start_row = in.number("the start's row", kLargestSide);
  s.goal_column = in.number("the goal's column", kLargestSide);
  s.goal_row = in.number("the goal's row", kLargestSide);
  s.optimal_text = in.field("the length");
  s.optimal = detail::coordinate(s.optimal_text, place);
  if (s.optimal < 0) place.fail("the length " + s.optimal_text + " is negative");
  s.places = digits_after_point(s.optimal_text) == 0 ? 6 : digits_after_point(s.optimal_text);
  in.end();
  if (s.width > 0 && s.height > 0) {
    const std::uint32_t more = places == ScenarioPlaces::corners ? 1 : 0;
    const auto is_outside = [&](std::uint32_t column, std::uint32_t row) {
      return column >= s.width + more || row >= s.height + more;
    };
    if (is_outside(s.start_column, s.start_row)) place.fail("the start lies outside the map");
    if (is_outside(s.goal_column, s.goal_row)) place.fail("the goal lies outside the map");
  }
  return s;
}

void require_movingai_version(std::string_view line, const std::string& source, int number) {
  const auto [word, value] = split(line);
  const SourceLine place{source, number};
  if (word != "version") place.fail("a scenario begins with `version 1`, not " + detail::quoted(line));
  if (value != "1" && value != "1.0") place.fail("version " + detail::quoted(value) + " is not known, only 1");
}

OccupancyGrid read_movingai_map(std::string_view text, const std::string& source) {
  return MapReader(text, source).read();
}

OccupancyGrid scaled(const OccupancyGrid& grid, std::uint32_t w, std::uint32_t h) {
  OccupancyGrid result{w, h, {}};
  result.blocked.reserve(std::size_t{w} * h);
  for (std::uint64_t y = 0; y < h; ++y)
    for (std::uint64_t x = 0; x < w; ++x)
      result.blocked.push_back(grid.blocked[y * grid.height / h * grid.width + x * grid.width / w]);
  return result;
}

std::vector<Scenario> read_movingai_scenarios(std::string_view text, const std::string& source) {
  std::vector<Scenario> scenarios;
  bool versioned = false;
  for (Lines lines(text); lines.next();) {
    if (detail::trimmed(lines.line()).empty()) continue;
    if (std::exchange(versioned, true) || looks_like_scenario(lines.line()))
      scenarios.push_back(movingai_scenario(lines.line(), source, lines.number(), ScenarioPlaces::cells));
    else
      require_movingai_version(lines.line(), source, lines.number());
  }
  if (!versioned) throw InputError(source, 0, "file is empty");
  restore_zeros(scenarios);
  return scenarios;
}

std::string movingai_scenario_text(const std::vector<Scenario>& scenarios) {
  std::string text = "version 1\n";
  for (const Scenario& s : scenarios)
    text += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", s.bucket, s.map, s.width, s.height, s.start_column,
                        s.start_row, s.goal_column, s.goal_row,
                        s.optimal_text.empty() ? fmt::format("{}", s.optimal) : s.optimal_text);
  return text;
}

std::string movingai_map_text(const OccupancyGrid& grid) {
  std::string text = fmt::format("type octile\nheight {}\nwidth {}\nmap\n", grid.height, grid.width);
  for (std::uint32_t row = 0; row < grid.height; ++row) {
    for (std::uint32_t column = 0; column < grid.width; ++column) text += grid.free(column, row) ? '.' : '@';
    text += '\n';
  }
  return text;
}

}  // namespace taut
