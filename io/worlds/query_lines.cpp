#include <taut/io/worlds/query_lines.h>

#include <algorithm>
#include <array>

#include <taut/io/worlds/detail/text_input.h>
#include <taut/io/worlds/movingai.h>

namespace taut {

namespace {

std::optional<QueryLine> parsed(std::string_view line, const detail::SourceLine& place, int number, bool has_radius) {
  if (number == 1) line = detail::stripped(line);
  line = detail::without_comment(line);
  if (line.empty()) return std::nullopt;
  detail::Fields fields(line, place);
  std::array<double, 5> v{};
  std::string_view field;
  for (std::size_t i = 0; i < (has_radius ? 5 : 4); ++i) {
    if (!fields.next(field))
      place.fail(has_radius ? "too few numbers; a query is sx sy gx gy r, and the length when it is known"
                            : "too few numbers; a query is sx sy gx gy, and the length when it is known");
    v[i] = detail::coordinate(field, place);
  }
  QueryLine query{{v[0], v[1]}, {v[2], v[3]}, false, std::nullopt, number};
  query.radius = v[4];
  if (has_radius && !(query.radius > 0)) place.fail("the radius " + std::string(field) + " is not above 0");
  if (!fields.next(field)) return query;
  query.expects = true;
  if (field != "none") query.expected = detail::coordinate(field, place);
  if (query.expected && *query.expected < 0) place.fail("the length " + std::string(field) + " is negative");
  if (fields.next(field)) place.fail(detail::quoted(field) + " follows the length");
  return query;
}

}  // namespace

std::optional<QueryLine> query_line(std::string_view line, const std::string& source, int number) {
  return parsed(line, {source, number}, number, false);
}

std::optional<QueryLine> disc_query_line(std::string_view line, const std::string& source, int number) {
  return parsed(line, {source, number}, number, true);
}

namespace {

QueryLine corner_query(const Scenario& s, int number) {
  const auto point = [](std::uint32_t column, std::uint32_t row) {
    return Point{static_cast<double>(column), static_cast<double>(row)};
  };
  return {point(s.start_column, s.start_row),
          point(s.goal_column, s.goal_row),
          true,
          s.says_none() ? std::nullopt : std::optional(s.optimal),
          number,
          std::max(1e-6, 0.5 * s.unit()),
          point(s.width, s.height)};
}

}  // namespace

std::optional<QueryLine> QueryReader::read(std::string_view line, int number) {
  const std::string_view text = detail::trimmed(number == 1 ? detail::stripped(line) : line);
  if (kind_ == Kind::unknown && text.starts_with("version")) {
    require_movingai_version(text, source_, number);
    kind_ = Kind::scenario;
    return std::nullopt;
  }
  if (kind_ == Kind::unknown && looks_like_scenario(text)) kind_ = Kind::scenario;
  if (kind_ == Kind::scenario) {
    if (text.empty()) return std::nullopt;
    return corner_query(movingai_scenario(text, source_, number, ScenarioPlaces::corners), number);
  }
  const std::optional<QueryLine> query = query_line(line, source_, number);
  if (query) kind_ = Kind::queries;
  return query;
}

}  // namespace taut
