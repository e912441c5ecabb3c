#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include <taut/io/pictures/car_svg.h>
#include <taut/io/results/barrier_words.h>
#include <taut/io/results/words.h>
#include <taut/python/answers.h>
#include <taut/robots/car/car_planner.h>
#include <taut/robots/car/verify_drive.h>
#include <taut/search/voronoi_search.h>

namespace taut::python {

namespace {

using namespace car;

constexpr double kDegree = std::numbers::pi / 180;

struct Driven {
  FreeSpace space;
  CarShape shape;
  Point start;
  std::vector<Point> goals;
  PlannedDrive drive;
};

std::optional<int> heading_of(std::optional<double> degrees) {
  if (!degrees) return std::nullopt;
  if (!std::isfinite(*degrees)) throw py::value_error("headings are degrees");
  return nearest_heading(std::remainder(*degrees, 360) * kDegree);
}

// Of a point robot's path the legs are free of what is thinner than a car.
bool is_shut(const Driven& d) {
  return std::ranges::all_of(d.goals, [&](Point goal) { return apart(d.space, d.start, Goal{goal, {}}).has_value(); });
}

std::optional<Driven> drive(const FreeSpace& space, const CarShape& shape, const std::optional<Point>& start,
                            const Goal& goal, std::optional<double> heading, std::optional<double> goal_heading,
                            double weight, std::size_t most_poses) {
  if (space.footprint().kind() != Footprint::Kind::point)
    throw py::value_error("the space is a robot's that is no point; make it without a footprint");
  if (!(weight >= 1 && weight <= 1e6)) throw py::value_error("weight: 1 or more");
  DriveQuery query{.start = start_of(space.world(), start),
                   .heading = heading_of(heading),
                   .goal_heading = heading_of(goal_heading),
                   .weight = weight};
  query.limits.expansions = most_poses;
  const Goal to = goal_of_query(space.world(), goal);
  const py::gil_scoped_release unlocked;
  require_ends(space, query.start, to);
  query.goals = goal_points(space, to);
  if (query.goals.empty()) throw Refusal(InputError("", 0, "the middles of the goal room are no free places"), "");
  Driven driven{space, shape, query.start, query.goals, {}};
  about(space.world().source(), [&] { driven.drive = planned_drive(CarSpace(space, shape), query); });
  if (driven.drive.status == SearchStatus::found) return driven;
  const bool proven = driven.drive.status == SearchStatus::none && (driven.drive.barrier || is_shut(driven));
  if (!proven) throw Unproven("no drive found, which does not prove that there is none");
  return std::nullopt;
}

// Poses along the drive, none farther from the next than `step`: x, y, heading in degrees, 1 where it reverses.
py::array poses_of(const Driven& d, double step) {
  if (!(step > 0)) throw py::value_error("step: above 0");
  std::vector<double> rows;
  const auto add = [&](const Pose& pose, bool backward) {
    rows.insert(rows.end(), {pose.x, pose.y, pose.heading / kDegree, backward ? 1.0 : 0.0});
  };
  for (const Leg& leg : d.drive.legs) {
    const double pieces = std::min(std::ceil(curve_of(leg).length() / step), 1e6);
    for (double i = rows.empty() ? 0 : 1; i <= pieces; ++i)
      add(pose_on(leg, pieces > 0 ? i / pieces : 0), leg.backward);
  }
  const auto n = static_cast<py::ssize_t>(rows.size() / 4);
  return moved(std::move(rows), {n, 4});
}

std::string picture(const Driven& d) {
  return car_svg(d.space.world(), d.shape,
                 {.title = title_of(d.space.world().source()),
                  .facts = {"length " + plain_length(d.drive.length)},
                  .legs = d.drive.legs,
                  .start_pose = d.drive.start,
                  .start = d.start,
                  .goals = d.goals,
                  .barrier = {}});
}

}  // namespace

void bind_cars(py::module_& m) {
  py::class_<CarShape>(m, "Car", "A rectangular car; its reference point is the middle of the rear axle.")
      .def(py::init([](double length, double width, double radius, double rear, bool reverse) {
             return car_shape(length, width, radius, rear, reverse);
           }),
           py::arg("length"), py::arg("width"), py::arg("radius"), py::arg("rear") = 0.0, py::arg("reverse") = true,
           "radius: the least turning radius. rear: from the rear end to the rear axle. Raises InputError.")
      .def_readonly("front", &CarShape::front)
      .def_readonly("back", &CarShape::back)
      .def_readonly("half_width", &CarShape::half_width)
      .def_readonly("radius", &CarShape::radius)
      .def_readonly("reverse", &CarShape::reverse);
  py::class_<Driven>(m, "Drive", "A drive of a car: exact legs, straight ones and arcs.")
      .def_property_readonly("length", [](const Driven& d) { return d.drive.length; })
      .def_property_readonly(
          "lower_bound", [](const Driven& d) { return d.drive.lower_bound; }, "No car of this size drives less.")
      .def_property_readonly("legs", [](const Driven& d) { return d.drive.legs.size(); })
      .def_property_readonly("reversals", [](const Driven& d) { return reversals_of(d.drive.legs); })
      .def("poses", &poses_of, py::arg("step"),
           "(n, 4): x, y, heading in degrees, 1 where it goes back; no farther apart than step.")
      .def(
          "verify", [](const Driven& d) { return !verify_drive(d.drive.legs, d.space, d.shape).has_value(); },
          Unlocked(), "A check that shares nothing with the planner but the legs: True when the car meets no wall.")
      .def("_repr_svg_", &picture, Unlocked())
      .def("__repr__", [](const Driven& d) {
        return fmt::format("<taut.Drive length {}, {}>", plain_length(d.drive.length),
                           count_text(d.drive.legs.size(), "leg"));
      });
  m.def("drive", &drive, py::arg("space"), py::arg("car"), py::arg("start") = py::none(), py::arg("goal") = py::none(),
        py::kw_only(), py::arg("heading") = py::none(), py::arg("goal_heading") = py::none(), py::arg("weight") = 1.0,
        py::arg("most_poses") = 3'000'000,
        "A Drive from start to goal; headings in degrees counter-clockwise from x, any when None. At most weight times "
        "as "
        "long as the shortest on its lattice. None when there is none, proven. Raises InputError when the car cannot "
        "stand there, Unproven.");
}

}  // namespace taut::python
