#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <taut/geometry/written_places.h>
#include <taut/io/pictures/interception_svg.h>
#include <taut/io/results/words.h>
#include <taut/python/answers.h>
#include <taut/python/timed.h>
#include <taut/robots/pursuit/verify_meeting.h>
#include <taut/search/query_ends.h>

namespace taut::python {

namespace {

using namespace pursuit;

struct Meeting {
  FreeSpace space;
  Interception question;
  MeetingPlace place;
};

/// The space, or where rounding moved a wall away from one of the places on it, one that knows them.
FreeSpace space_with(const FreeSpace& space, const Interception& question) {
  if (space.footprint().kind() != Footprint::Kind::point) return space;
  std::vector<Point> places{question.start};
  for (const TimedPoint& p : question.way) places.push_back(p.at);
  const WrittenPlaces written(space);
  const bool is_any_moved = std::any_of(places.begin(), places.end(), [&](Point p) { return written.is_moved(p); });
  return is_any_moved ? FreeSpace(space.world(), space.footprint(), places) : space;
}

void require_way(const FreeSpace& space, const std::vector<TimedPoint>& way) {
  const auto leg = blocked_leg(space, way);
  if (!leg) return;
  if (!space.holds(way[*leg].at))
    throw InputError("", 0, fmt::format("way: in row {} the target is in a wall, or outside", *leg));
  throw InputError("", 0, fmt::format("way: a wall is in the target's way from row {} to row {}", *leg, *leg + 1));
}

std::optional<Meeting> meeting(const FreeSpace& given, const py::object& rows, const std::optional<Point>& start,
                               double speed, bool stays) {
  if (!(speed > 0 && speed <= World::kLargest)) throw py::value_error("speed: above 0");
  const Interception question{start_of(given.world(), start), speed, timed_points_of(rows, "way"), stays};
  const py::gil_scoped_release unlocked;
  const FreeSpace space = space_with(given, question);
  return about(space.world().source(), [&]() -> std::optional<Meeting> {
    require_free(space, question.start, "start");
    require_way(space, question.way);
    auto place = earliest_meeting(VisibilityGraph(space), question);
    if (!place) return std::nullopt;
    return Meeting{space, question, std::move(*place)};
  });
}

std::string picture(const Meeting& m) {
  return interception_svg(m.space, m.question, m.place,
                          {title_of(m.space.world().source()), {"caught after " + number_text(m.place.time.hi)}, {}});
}

}  // namespace

void bind_meetings(py::module_& m) {
  py::class_<Meeting>(m, "Meeting", "Where a robot meets a moving target, as early as can be.")
      .def_property_readonly(
          "time", [](const Meeting& x) { return x.place.time.hi; }, "They can be at one place then.")
      .def_property_readonly(
          "time_bounds", [](const Meeting& x) { return py::make_tuple(x.place.time.lo, x.place.time.hi); },
          "Two neighbouring doubles around the exact time, or that time twice.")
      .def_property_readonly("at", [](const Meeting& x) { return x.place.at; })
      .def_property_readonly(
          "leg", [](const Meeting& x) { return x.place.leg; }, "Of the target's way, from that row on.")
      .def_property_readonly(
          "points", [](const py::object& self) { return points_view(self.cast<const Meeting&>().place.path, self); },
          "(n, 2): the robot's path, the shortest.")
      .def_property_readonly("length", [](const Meeting& x) { return x.place.length; })
      .def_property_readonly(
          "waits", [](const Meeting& x) { return x.place.waits; }, "How long the robot stands there before.")
      .def(
          "verify", [](const Meeting& x) { return meeting_fault(x.space, x.question, x.place).empty(); }, Unlocked(),
          "Is the path one, and short enough? By code that shares nothing with the search.")
      .def("_repr_svg_", &picture, Unlocked())
      .def("__repr__", [](const Meeting& x) {
        return fmt::format("<taut.Meeting after {} at ({}, {})>", number_text(x.place.time.hi),
                           number_text(x.place.at.x), number_text(x.place.at.y));
      });
  m.def("earliest_meeting", &meeting, py::arg("space"), py::arg("way"), py::arg("start") = py::none(), py::kw_only(),
        py::arg("speed") = 1.0, py::arg("stays") = false,
        "The earliest Meeting of a robot, from start at time 0 and with speed at most, and a target on its way: rows "
        "time, x, y (n, 3), straight and even in between; after the last one it is gone, or stays. None when there is "
        "none, proven. The target may be faster. Raises InputError when the start is not free, or a wall is in the "
        "target's way.");
}

}  // namespace taut::python
