#include <taut/cli/solve/clearance_report.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <taut/cli/report.h>
#include <taut/io/pictures/svg.h>
#include <taut/io/pictures/svg_front.h>

namespace taut::cli {

namespace {

using Kind = ClearanceQuery::Kind;

constexpr const char* kAlong = "along the Voronoi diagram";

std::string at_least_text(const ClearanceAnswer& answer, const FreeSpace& space) {
  const ClearancePath& way = answer.found.front().path;
  return fmt::format("length {} {} (the shortest there, not in the plane) with clearance >= {}; {}, {}",
                     plain_length(way.length), kAlong, number_text(answer.query.clearance),
                     pinch_text(way.pinch, space), seconds_text(answer.seconds.total));
}

std::string widest_text(const ClearanceAnswer& answer, const FreeSpace& space) {
  const ClearancePath& way = answer.found.front().path;
  return fmt::format("the largest disc that gets through has radius {}; {}; its way has length {} {}, {}",
                     number_text(way.pinch.clearance), pinch_text(way.pinch, space, answer.width.value_or("")),
                     plain_length(way.length), kAlong, seconds_text(answer.seconds.total));
}

std::string place_text(const Pinch& pinch) {
  if (pinch.where == Pinch::Where::gate)
    return fmt::format("between {} and {}", point_text(pinch.posts[0]), point_text(pinch.posts[1]));
  return fmt::format("at the {}, from {}", pinch.where == Pinch::Where::start ? "start" : "goal",
                     point_text(pinch.posts[0]));
}

std::string table(const ClearanceAnswer& answer) {
  using Row = std::array<std::string, 3>;
  std::vector<Row> rows{{"radius up to", "length", "narrowest"}};
  for (const ClearanceTrade& t : answer.found)
    rows.push_back({number_text(t.clearance), plain_length(t.path.length), place_text(t.path.pinch)});
  std::array<std::size_t, 3> widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string out;
  for (const Row& row : rows) out += fmt::format("{:>{}}  {:>{}}  {}\n", row[0], widths[0], row[1], widths[1], row[2]);
  return out;
}

std::vector<std::string> facts(const ClearanceAnswer& answer) {
  const std::string seconds = seconds_text(answer.seconds.total);
  if (answer.status == SearchStatus::stopped) return {answer.reason, seconds};
  if (answer.status == SearchStatus::none) {
    const std::string asked = answer.query.kind == Kind::at_least && answer.query.clearance > 0
                                  ? "no path with clearance " + number_text(answer.query.clearance)
                                  : "no path";
    const bool narrow = !answer.barrier.gates.empty();
    return {asked, narrow ? count_text(answer.barrier.gates.size(), "gate") + " too narrow" : answer.reason, seconds};
  }
  if (answer.query.kind == Kind::tradeoff)
    return {count_text(answer.found.size(), "path") + " along the Voronoi diagram", seconds};
  const ClearancePath& way = answer.found.front().path;
  return {fmt::format("length {} {}", plain_length(way.length), kAlong),
          answer.query.kind == Kind::widest ? "largest disc: radius " + number_text(way.pinch.clearance)
                                            : "least clearance " + number_text(way.pinch.clearance),
          seconds};
}

std::vector<SvgShade> shades(const ClearanceAnswer& answer) {
  const double least = answer.found.front().clearance, most = answer.found.back().clearance;
  std::vector<SvgShade> all;
  for (const ClearanceTrade& t : answer.found)
    all.push_back({t.path.curves, most > least ? (t.clearance - least) / (most - least) : 1});
  return all;
}

SvgPicture picture_of(const ClearanceAnswer& answer) {
  SvgPicture picture;
  picture.title = title_of(answer.source);
  picture.facts = facts(answer);
  picture.start = answer.start;
  picture.goal.point = answer.goal;
  if (answer.status != SearchStatus::found) {
    picture.separation = answer.barrier.walls;
    picture.gates = answer.barrier.gate_segments();
    return picture;
  }
  for (const ClearanceTrade& t : answer.found) picture.gates.push_back({t.path.pinch.posts[0], t.path.pinch.posts[1]});
  if (answer.query.kind == Kind::tradeoff)
    picture.shades = shades(answer);
  else
    picture.curves = answer.found.front().path.curves;
  return picture;
}

std::string front_picture(const ClearanceAnswer& answer, const FreeSpace& space) {
  std::vector<SvgStep> steps;
  for (const ClearanceTrade& t : answer.found) steps.push_back({t.clearance, t.path.length, place_text(t.path.pinch)});
  return svg_front(space, picture_of(answer), steps);
}

}  // namespace

std::string plain_length(double length) {
  return length == 0 || (length >= 1e-3 && length < 1e12) ? fmt::format("{:.6f}", length)
                                                          : fmt::format("{:.9g}", length);
}

std::string clearance_text(const ClearanceAnswer& answer, const FreeSpace& space) {
  if (answer.status == SearchStatus::found && answer.query.kind == Kind::tradeoff) return table(answer);
  std::string line = answer.reason;
  if (answer.status == SearchStatus::none) line = facts(answer).front() + ": " + answer.reason;
  if (answer.status == SearchStatus::found)
    line = answer.query.kind == Kind::widest ? widest_text(answer, space) : at_least_text(answer, space);
  return answer.source + ": " + line + "\n";
}

std::string clearance_svg(const ClearanceAnswer& answer, const FreeSpace& space, const VoronoiRoadmap& map) {
  if (answer.status == SearchStatus::found && answer.query.kind == Kind::tradeoff) return front_picture(answer, space);
  SvgPicture picture = picture_of(answer);
  picture.diagram = &map;
  return svg(space, picture);
}

}  // namespace taut::cli
