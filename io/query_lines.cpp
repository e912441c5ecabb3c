#include <taut/io/query_lines.h>

#include <array>

#include <taut/io/detail/text_input.h>

namespace taut {

std::optional<QueryLine> query_line(std::string_view line, const std::string& source, int number) {
  const detail::Place place{source, number};
  if (number == 1) line = detail::stripped(line);
  line = detail::trimmed(line.substr(0, line.find('#')));
  if (line.empty()) return std::nullopt;
  detail::Fields fields(line, place);
  std::array<double, 4> v{};
  std::string_view field;
  for (double& value : v) {
    if (!fields.next(field)) place.fail("too few numbers; a query is sx sy gx gy, and the length when it is known");
    value = detail::coordinate(field, place);
  }
  QueryLine query{{v[0], v[1]}, {v[2], v[3]}, false, std::nullopt, number};
  if (!fields.next(field)) return query;
  query.expects = true;
  if (field != "none") query.expected = detail::coordinate(field, place);
  if (query.expected && *query.expected < 0) place.fail("the length " + std::string(field) + " is negative");
  if (fields.next(field)) place.fail(detail::quoted(field) + " follows the length");
  return query;
}

}  // namespace taut
