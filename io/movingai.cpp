#include <taut/io/movingai.h>

#include <fmt/format.h>

#include <taut/io/detail/text_input.h>

namespace taut {

namespace {

std::uint32_t number_after(std::string_view line, std::string_view word, const detail::Place& place) {
  if (!line.starts_with(word)) place.fail(fmt::format("{} where '{}' should be", detail::quoted(line), word));
  return static_cast<std::uint32_t>(
      detail::whole(detail::trimmed(line.substr(word.size())), 1, 20000, std::string(word).c_str(), place));
}

}  // namespace

OccupancyGrid read_movingai_map(std::string_view text, const std::string& source) {
  detail::Lines lines(text);
  const auto next = [&] {
    if (!lines.next()) detail::Place{source, lines.number()}.fail("ends too early");
    return detail::Place{source, lines.number()};
  };
  OccupancyGrid grid;
  if (const auto place = next(); !lines.line().starts_with("type")) place.fail("does not begin with 'type'");
  if (const auto place = next(); true) grid.height = number_after(lines.line(), "height", place);
  if (const auto place = next(); true) grid.width = number_after(lines.line(), "width", place);
  if (const auto place = next(); lines.line() != "map") place.fail("no 'map'");
  for (std::uint32_t row = 0; row < grid.height; ++row) {
    const auto place = next();
    if (lines.line().size() != grid.width) place.fail("wrong number of characters");
    for (const char c : lines.line()) {
      const bool free = c == '.' || c == 'G' || c == 'S';
      if (!free && std::string_view("@OTW").find(c) == std::string_view::npos) place.fail("unknown character");
      grid.blocked.push_back(!free);
    }
  }
  return grid;
}

std::vector<Scenario> read_movingai_scenarios(std::string_view text, const std::string& source) {
  std::vector<Scenario> scenarios;
  for (detail::Lines lines(text); lines.next();) {
    const detail::Place place{source, lines.number()};
    if (lines.line().empty() || lines.line().starts_with("version")) continue;
    std::vector<std::string_view> fields;
    detail::Fields rest(lines.line(), place);
    for (std::string_view field; rest.next(field);) fields.push_back(field);
    if (fields.size() != 9) place.fail("not 9 fields");
    const auto number = [&](std::size_t i) {
      return static_cast<std::uint32_t>(detail::whole(fields[i], 0, 1 << 30, "number", place));
    };
    scenarios.push_back({number(0), std::string(fields[1]), number(2), number(3), number(4), number(5), number(6),
                         number(7), detail::coordinate(fields[8], place), std::string(fields[8]),
                         static_cast<std::size_t>(lines.number())});
  }
  return scenarios;
}

std::string movingai_scenario_text(const std::vector<Scenario>& scenarios) {
  std::string out = "version 1\n";
  for (const Scenario& s : scenarios)
    out += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", s.bucket, s.map, s.width, s.height, s.start_column,
                       s.start_row, s.goal_column, s.goal_row, s.optimal_text);
  return out;
}

std::string movingai_map_text(const OccupancyGrid& grid) {
  std::string out = fmt::format("type octile\nheight {}\nwidth {}\nmap\n", grid.height, grid.width);
  for (std::uint32_t row = 0; row < grid.height; ++row) {
    for (std::uint32_t column = 0; column < grid.width; ++column) out += grid.free(column, row) ? '.' : '@';
    out += '\n';
  }
  return out;
}

}  // namespace taut
