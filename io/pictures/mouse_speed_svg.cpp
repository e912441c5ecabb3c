#include <taut/io/pictures/mouse_svg.h>

#include <fmt/format.h>

#include <taut/io/pictures/detail/mouse_sheet.h>

namespace taut {

namespace {

using detail::MouseSheet;
using micromouse::SpeedRun;

std::string line_of(const MouseSheet& sheet, const SpeedRun& run) {
  std::vector<Point> points;
  for (const micromouse::Drive& d : run.drives) {
    const auto line = micromouse::trace(d, 0.1);
    points.insert(points.end(), line.begin(), line.end());
  }
  return points.size() < 2 ? "" : MouseSheet::path(sheet.line(points));
}

std::string fact(const char* what, const SpeedRun& run) {
  return fmt::format("{} {:.3f} s, {:.2f} m, {} cells", what, run.seconds, run.metres, run.cells.size() - 1);
}

}  // namespace

std::string mouse_speed_svg(const GridMaze& maze, const SpeedRun& fastest, const SpeedRun& shortest,
                            const std::string& title) {
  using enum detail::SvgKey::Sample;
  const MouseSheet sheet(maze, title, {fact("fastest", fastest), fact("shortest", shortest)},
                         {{"fastest", "fastest", line, {}},
                          {"shortest", "shortest", line, {}},
                          {"start", "start", marker, {}},
                          {"goal", "goal", marker, {}},
                          {"rooms", "goal room", patch, {}}});
  std::string walls;
  for (const auto& w : detail::standing_walls(maze)) walls += sheet.wall(w);
  return sheet.head() + sheet.goal_room() + MouseSheet::group("seen", MouseSheet::path(walls)) + sheet.posts() +
         MouseSheet::group("shortest", line_of(sheet, shortest)) +
         MouseSheet::group("fastest", line_of(sheet, fastest)) + sheet.ends() + sheet.foot();
}

}  // namespace taut
