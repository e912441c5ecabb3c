#include <taut/io/worlds/read_timed_way.h>

#include <cctype>
#include <utility>

#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut {

namespace {

using detail::SourceLine;

bool is_heading(const std::vector<std::string_view>& fields) {
  return !fields.empty() && std::tolower(static_cast<unsigned char>(fields.front().front())) == 't';
}

}  // namespace

std::vector<ReadTimedPoint> read_timed_way(std::string_view bytes, const std::string& source) {
  std::vector<ReadTimedPoint> way;
  bool is_first = true;
  for (detail::Lines lines(bytes); lines.next();) {
    const std::string_view line = detail::without_comment(lines.line());
    if (line.empty()) continue;
    const SourceLine place{source, lines.number()};
    const std::vector<std::string_view> fields = detail::fields_of(line, place);
    if (std::exchange(is_first, false) && is_heading(fields)) continue;
    if (fields.size() != 3) place.fail("a line is `t x y`, not " + std::to_string(fields.size()) + " numbers");
    const fleet::TimedPoint point{detail::coordinate(fields[0], place),
                                  {detail::coordinate(fields[1], place), detail::coordinate(fields[2], place)}};
    if (!way.empty() && !(way.back().point.time < point.time))
      place.fail("time " + text(point.time) + " comes after " + text(way.back().point.time));
    way.push_back({point, lines.number()});
  }
  if (way.empty()) SourceLine{source, 0}.fail("holds no way: lines `t x y`");
  return way;
}

}  // namespace taut
