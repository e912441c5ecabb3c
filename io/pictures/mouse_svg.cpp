#include <taut/io/pictures/colour_scale.h>
#include <taut/io/pictures/mouse_svg.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <taut/io/pictures/detail/mouse_film.h>
#include <taut/io/pictures/detail/mouse_sheet.h>
#include <taut/io/pictures/detail/mouse_values.h>
#include <taut/io/pictures/detail/svg_path.h>
#include <taut/io/pictures/svg_sheet.h>

namespace taut {

namespace {

using detail::MouseFilm;
using detail::MouseSheet;
using detail::svg_number;
using micromouse::CellSide;
using micromouse::MousePose;
using micromouse::Record;
using micromouse::Step;

constexpr int kShades = 24;
constexpr double kBeside = 0.1;  // run 1 is drawn that much off the middle, so that both routes can be seen

/// When what came into view: indices of steps, felt ones half a step later.
struct Sights {
  std::map<Cell, int> cells;
  std::map<CellSide, double> walls;
};

void see_along(Sights& sights, const Step& step, int quarters, int open, int at) {
  const Side side = micromouse::turned(step.before.heading, quarters);
  for (int i = 0; i <= open; ++i) sights.cells.emplace(micromouse::ahead(step.before.cell, side, i), at);
}

Sights sights_of(const Record& record) {
  Sights sights;
  for (std::size_t k = 0; k < record.steps.size(); ++k) {
    const Step& step = record.steps[k];
    const int at = static_cast<int>(k);
    see_along(sights, step, -1, step.sight.left, at);
    see_along(sights, step, 0, step.sight.front, at);
    see_along(sights, step, 1, step.sight.right, at);
    sights.cells.emplace(step.after.cell, at);
    for (const auto& w : step.seen)
      if (w.closed) sights.walls.emplace(w.wall, at);
    for (const auto& w : step.felt)
      if (w.closed) sights.walls.emplace(w.wall, at + 0.7);
  }
  return sights;
}

bool is_border(const GridMaze& maze, const CellSide& wall) {
  return !maze.contains(GridMaze::neighbour(wall.cell, wall.side));
}

/// The border is known from the start.
std::string walls_text(const MouseSheet& sheet, const GridMaze& maze, const Sights& sights, bool seen) {
  std::string data;
  for (const CellSide& w : detail::standing_walls(maze))
    if ((sights.walls.contains(w) || is_border(maze, w)) == seen) data += sheet.wall(w);
  return MouseSheet::group(seen ? "seen" : "unseen", MouseSheet::path(data));
}

int shade_of(int step, int steps) { return steps <= 1 ? 0 : std::min(kShades - 1, step * kShades / steps); }

std::string shade_name(int shade) { return shade_colour(shade / (kShades - 1.0)); }

int exploring_steps(const Record& record) { return std::max(record.run1, 1); }

std::string floor_text(const MouseSheet& sheet, const Record& record, const Sights& sights) {
  std::map<int, std::string> shades;
  for (const auto& [cell, step] : sights.cells)
    shades[shade_of(std::min(step, record.run1), exploring_steps(record))] += sheet.square(cell);
  std::string out;
  for (const auto& [shade, data] : shades) out += fmt::format("<path fill=\"{}\" d=\"{}\"/>", shade_name(shade), data);
  return MouseSheet::group("sight", out);
}

Point place(Cell cell, int run) {
  const Point p = detail::middle(cell);
  return run == 1 ? Point{p.x + kBeside, p.y - kBeside} : p;
}

std::string route_text(const MouseSheet& sheet, const Record& record, int run) {
  std::vector<Point> points;
  for (const Step& step : record.steps) {
    if (step.run != run) continue;
    if (points.empty()) points.push_back(place(step.before.cell, run));
    if (!step.action.reset && step.moved != 0) points.push_back(place(step.after.cell, run));
  }
  return points.size() < 2 ? "" : MouseSheet::group(run == 1 ? "run1" : "run2", MouseSheet::path(sheet.line(points)));
}

MouseSheet sheet_of(const GridMaze& maze, const MousePicture& picture) {
  using enum detail::SvgKey::Sample;
  std::vector<std::string> colours;
  colours.reserve(kShades);
  for (int i = 0; i < kShades; ++i) colours.push_back(shade_name(i));
  std::vector<detail::SvgKey> keys{
      {"run1", "run 1", line, {}},       {"run2", "run 2", line, {}},
      {"seen", "wall seen", line, {}},   {"unseen", "wall not seen", line, {}},
      {"start", "start", marker, {}},    {"goal", "goal", marker, {}},
      {"rooms", "goal room", patch, {}}, {"sight", "first seen: early to late", scale, std::move(colours)}};
  if (picture.flood) keys.push_back({"flood", "fewest steps to the goal, unknown walls open", digit, {}});
  return {maze, picture.title, picture.facts, keys};
}

std::string film_floor(const MouseSheet& sheet, const Record& record, const Sights& sights, const MouseFilm& film) {
  std::map<int, std::string> by_step;
  for (const auto& [cell, step] : sights.cells) by_step[step] += sheet.square(cell);
  std::string out;
  for (const auto& [step, data] : by_step)
    out +=
        fmt::format("<path class=\"appears\" fill=\"{}\" d=\"{}\">{}</path>\n",
                    shade_name(shade_of(std::min(step, record.run1), exploring_steps(record))), data, film.from(step));
  return MouseSheet::group("sight", out);
}

std::string film_walls(const MouseSheet& sheet, const GridMaze& maze, const Sights& sights, const MouseFilm& film) {
  std::map<double, std::string> by_moment;
  for (const CellSide& w : detail::standing_walls(maze))
    if (is_border(maze, w)) by_moment[0] += sheet.wall(w);
  for (const auto& [wall, moment] : sights.walls) by_moment[moment] += sheet.wall(wall);
  std::string out;
  for (const auto& [moment, data] : by_moment)
    out += fmt::format("<path class=\"appears\" d=\"{}\">{}</path>\n", data, film.from(moment));
  return MouseSheet::group("seen", out);
}

std::string film_route(const MouseSheet& sheet, const Record& record, int run, const MouseFilm& film) {
  std::string out;
  for (std::size_t i = 0; i < record.steps.size(); ++i) {
    const Step& s = record.steps[i];
    if (s.run != run || s.action.reset || s.moved == 0) continue;
    out += fmt::format("<path class=\"appears\" d=\"{}\">{}</path>\n",
                       sheet.line({place(s.before.cell, run), place(s.after.cell, run)}),
                       film.from(static_cast<double>(i) + 1));
  }
  return MouseSheet::group(run == 1 ? "run1" : "run2", out);
}

std::string film_counter(const MouseSheet& sheet, const Record& record, const MouseFilm& film) {
  std::string out;
  const Point at = sheet.pixel(Point{0, static_cast<double>(record.task.height)});
  for (std::size_t i = 0; i < record.steps.size(); ++i) {
    const Step& s = record.steps[i];
    const int step = static_cast<int>(i) + 1 - (s.run == 2 ? record.run1 : 0);
    const double begin = static_cast<double>(i);
    const bool last = i + 1 == record.steps.size();
    out += fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\"{}>run {} \xC2\xB7 step {}{}{}</text>\n",
                       last ? "appears" : "moving", svg_number(at.x), svg_number(at.y - 8),
                       last ? "" : " opacity=\"0\"", s.run, step, s.action.reset ? " \xC2\xB7 reset" : "",
                       last ? film.from(begin) : film.between(begin, begin + 1));
  }
  return MouseSheet::group("counter", out);
}

}  // namespace

std::string mouse_svg(const GridMaze& maze, const Record& record, const MousePicture& picture) {
  const MouseSheet sheet = sheet_of(maze, picture);
  const Sights sights = sights_of(record);
  const MousePose last = detail::last_pose(record);
  return sheet.head() + floor_text(sheet, record, sights) + sheet.goal_room() +
         (picture.flood ? detail::mouse_values(sheet, record) : "") + detail::mouse_marks(sheet, picture.marks) +
         walls_text(sheet, maze, sights, false) + walls_text(sheet, maze, sights, true) + sheet.posts() +
         route_text(sheet, record, 1) + route_text(sheet, record, 2) + sheet.ends() +
         fmt::format("<g transform=\"{}\">{}</g>\n", sheet.placed(last.cell, detail::degrees(last.heading)),
                     sheet.wedge()) +
         sheet.foot();
}

std::string mouse_animation(const GridMaze& maze, const Record& record, const MousePicture& picture) {
  const MouseSheet sheet = sheet_of(maze, picture);
  const Sights sights = sights_of(record);
  const MouseFilm film(record);
  return sheet.head() + film_floor(sheet, record, sights, film) + sheet.goal_room() +
         (picture.flood ? detail::film_values(sheet, record, film) : "") +
         MouseSheet::group("unseen", MouseSheet::path([&] {
                             std::string data;
                             for (const CellSide& w : detail::standing_walls(maze)) data += sheet.wall(w);
                             return data;
                           }())) +
         film_walls(sheet, maze, sights, film) + sheet.posts() + film_route(sheet, record, 1, film) +
         film_route(sheet, record, 2, film) + sheet.ends() + film.mouse(sheet) + film_counter(sheet, record, film) +
         sheet.controls() + sheet.foot();
}

std::string mouse_values_svg(const GridMaze& maze, const Record& record, const MousePicture& picture) {
  const auto at = [&](const char* when, int steps) {
    Record part = record;
    part.steps.resize(std::min(part.steps.size(), static_cast<std::size_t>(steps)));
    part.run1 = static_cast<int>(part.steps.size());
    return mouse_svg(maze, part, {picture.title + ": " + when, {fmt::format("step {}", steps)}, true});
  };
  const int goal = record.goal_at.value_or(record.run1);
  const bool is_late = goal + 1 >= record.run1;
  return svg_sheet(std::vector{at("before the first step", 0),
                               is_late ? at("half way through run 1", record.run1 / 2) : at("at the goal", goal),
                               at("at the end of run 1", record.run1)},
                   3);
}

}  // namespace taut
