#include <taut/io/worlds/read_fleet.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <unordered_map>
#include <utility>

#include <taut/geometry/text.h>
#include <taut/io/worlds/detail/text_input.h>

namespace taut {

namespace {

using detail::SourceLine;

bool is_heading(const std::vector<std::string_view>& fields) {
  const auto same = [](std::string_view field, char letter) {
    return !field.empty() && std::tolower(static_cast<unsigned char>(field.front())) == letter;
  };
  return fields.size() >= 4 && same(fields[1], 't') && same(fields[2], 'x') && same(fields[3], 'y');
}

bool is_number(std::string_view field) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  return error == std::errc() && end == field.data() + field.size();
}

class FleetReader {
 public:
  FleetReader(std::optional<double> radius, const std::string& source) : radius_(radius), source_(source) {}

  std::vector<fleet::Robot> read(std::string_view bytes) {
    bool first = true;
    for (detail::Lines lines(bytes); lines.next();) {
      const SourceLine place{source_, lines.number()};
      const std::string_view line = detail::without_comment(lines.line());
      if (line.empty()) continue;
      const std::vector<std::string_view> fields = detail::fields_of(line, place);
      if (!std::exchange(first, false) || !is_heading(fields)) add(fields, place);
    }
    if (robots_.empty()) SourceLine{source_, 0}.fail("holds no plans");
    for (const fleet::Robot& robot : robots_)
      if (robot.radius == 0)
        SourceLine{source_, 0}.fail("robot " + detail::quoted(robot.id) + " has no radius; say --robot disc:R");
    return std::move(robots_);
  }

 private:
  void add(const std::vector<std::string_view>& fields, const SourceLine& place) {
    if (fields.size() != 4 && fields.size() != 5) place.fail("a line is `id t x y` or `id t x y r`");
    fleet::Robot& robot = named(std::string(fields[0]));
    const double time = detail::coordinate(fields[1], place);
    const Point at{detail::coordinate(fields[2], place), detail::coordinate(fields[3], place)};
    if (!robot.points.empty() && !(robot.points.back().time < time))
      place.fail("robot " + detail::quoted(robot.id) + " is at time " + text(time) + " after " +
                 text(robot.points.back().time));
    robot.points.push_back({time, at});
    if (fields.size() == 5) take_radius(robot, detail::coordinate(fields[4], place), place);
  }

  void take_radius(fleet::Robot& robot, double radius, const SourceLine& place) const {
    if (!(radius > 0)) place.fail("a radius is above 0");
    if (robot.points.size() > 1 && robot.radius != radius)
      place.fail("robot " + detail::quoted(robot.id) + " has another radius than before");
    robot.radius = radius;
  }

  fleet::Robot& named(std::string id) {
    const auto [found, is_new] = numbers_.try_emplace(std::move(id), robots_.size());
    if (is_new) robots_.push_back({found->first, radius_.value_or(0), {}});
    return robots_[found->second];
  }

  std::optional<double> radius_;
  const std::string& source_;
  std::vector<fleet::Robot> robots_;
  std::unordered_map<std::string, std::size_t> numbers_;
};

}  // namespace

bool holds_fleet(std::string_view bytes) {
  const std::string source;
  for (detail::Lines lines(bytes); lines.next();) {
    const std::string_view line = detail::without_comment(lines.line());
    if (line.empty()) continue;
    if (line.find_first_of("{}[]():") != std::string_view::npos || line.find(",,") != std::string_view::npos)
      return false;
    if (line.front() == ',' || line.back() == ',') return false;
    const auto fields = detail::fields_of(line, {source, lines.number()});
    return is_heading(fields) ||
           (fields.size() >= 4 && is_number(fields[1]) && is_number(fields[2]) && is_number(fields[3]));
  }
  return false;
}

std::vector<fleet::Robot> read_fleet(std::string_view bytes, std::optional<double> radius, const std::string& source) {
  return FleetReader(radius, source).read(bytes);
}

}  // namespace taut
