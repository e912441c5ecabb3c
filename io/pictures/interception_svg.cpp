#include <taut/io/pictures/interception_svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <taut/io/pictures/svg.h>

namespace taut::pursuit {

namespace {

constexpr double kFilmSeconds = 12, kRuns = 0.95;

/// The robot's path as a way with times: straight on, then it waits.
std::vector<TimedPoint> robot_way(const Interception& question, const std::optional<MeetingPlace>& meeting,
                                  double end) {
  if (!meeting) return {{0, question.start}, {end, question.start}};
  std::vector<TimedPoint> way;
  const double goes = std::max(meeting->time.hi - meeting->waits, 1e-300);
  double gone = 0, whole = 0;
  const std::vector<Point>& path = meeting->path;
  const auto leg = [&](std::size_t i) { return std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y); };
  for (std::size_t i = 1; i < path.size(); ++i) whole += leg(i);
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) gone += leg(i);
    way.push_back({whole > 0 ? goes * gone / whole : 0, path[i]});
  }
  if (way.back().time < end) way.push_back({end, path.back()});
  return way;
}

/// 1, 2 or 5 times a power of ten: not more than eight marks.
double mark_step(double end) {
  double step = std::pow(10, std::floor(std::log10(end)) - 1);
  for (const double times : {2.0, 2.5, 2.0, 2.0}) {
    if (end / step <= 8) break;
    step *= times;
  }
  return step;
}

std::vector<SvgLabel> marks(const std::vector<TimedPoint>& robot, const std::vector<TimedPoint>& target, double end) {
  std::vector<SvgLabel> labels;
  const double step = end > 0 ? mark_step(end) : 1;
  for (int k = 0; k * step < end - step / 3; ++k) {
    const double t = k * step;
    if (t > 0 && t <= robot.back().time) labels.push_back({place_at(robot, t), fmt::format("{:.12g}", t)});
    if (t >= target.front().time && t <= target.back().time)
      labels.push_back({place_at(target, t), fmt::format("{:.12g}", t)});
  }
  return labels;
}

SvgTraveller traveller(const std::vector<TimedPoint>& way, double end, const char* kind) {
  SvgTraveller who{{{0, place_at(way, 0)}}, kind};
  for (const TimedPoint& p : way)
    if (p.time > 0 && p.time < end) who.places.emplace_back(kRuns * p.time / end, p.at);
  who.places.emplace_back(kRuns, place_at(way, end));
  who.places.emplace_back(1, place_at(way, end));
  return who;
}

}  // namespace

std::string interception_svg(const FreeSpace& space, const Interception& question,
                             const std::optional<MeetingPlace>& meeting, const InterceptionPicture& what) {
  const double end = std::max(meeting ? meeting->time.hi : question.way.back().time, 1e-9);
  const std::vector<TimedPoint> robot = robot_way(question, meeting, end);
  SvgPicture picture;
  picture.title = what.title;
  picture.facts = what.facts;
  picture.moves = what.end_moves;
  picture.start = question.start;
  Path path;
  if (meeting) {
    path.points = meeting->path;
    picture.path = &path;
    picture.goal.point = meeting->at;
  }
  for (std::size_t i = 1; i < question.way.size(); ++i)
    picture.guides.push_back({question.way[i - 1].at, question.way[i].at});
  picture.guide_label = "the target's way";
  picture.labels = marks(robot, question.way, end);
  picture.label_keys = {{"1", "time, on both ways"}};
  if (what.moves) {
    picture.seconds = kFilmSeconds;
    picture.travellers = {traveller(question.way, end, "goal"), traveller(robot, end, "runner")};
  }
  return svg(space, picture);
}

}  // namespace taut::pursuit
