// Certificates, their judge, audits of anybody's paths and of fleets.
#include <taut/python/proofs.h>

#include <fmt/format.h>

#include <array>

#include <taut/geometry/plain_world.h>
#include <taut/geometry/walled_world.h>
#include <taut/io/results/arc_proof.h>
#include <taut/io/results/path_certificate_text.h>
#include <taut/io/worlds/write_world.h>
#include <taut/python/answers.h>
#include <taut/python/timed.h>
#include <taut/robots/fleet/fleet.h>
#include <taut/search/arc_search.h>
#include <taut/search/clearance_search.h>
#include <taut/search/disc_worlds.h>
#include <taut/search/path_audit.h>
#include <taut/search/path_certificate.h>
#include <taut/search/shortest_path.h>
#include <taut/verify/judge.h>

namespace taut::python {

namespace {

// ---- certificates ---------------------------------------------------------------------------------------------------

std::string shortest(const FreeSpace& space, Point from, const Goal& to) {
  if (!is_certifiable(to)) throw InputError("", 0, "a certificate is for a goal that is a point or a rectangle");
  const FreeSpace plain = is_plain(space.world(), space.footprint()) ? space : FreeSpace(plain_world(space));
  const auto path = shortest_path(space, from, to);
  const VisibilityGraph graph(plain);
  const auto certificate = path ? shortest_certificate(graph, *path, to) : none_certificate(graph, from, to);
  if (!certificate) throw Unproven("no certificate: crossings of walls were rounded where paths bend");
  return certificate_text(*certificate, write_plain_integers(plain.world()));
}

std::string widest(const FreeSpace& space, Point from, const Goal& to) {
  if (!to.point) throw InputError("", 0, "a certificate is for a goal that is a point, not for a room");
  const FreeSpace walled(walled_world(space.world(), {from, *to.point}));
  const Gates gates(walled);
  const auto limit = widest_passage(gates, from, *to.point);
  const auto way = limit ? ClearanceSearch(VoronoiRoadmap(walled), from, *to.point).widest() : std::nullopt;
  const auto certificate = way ? widest_certificate(gates, *limit, from, *to.point, way->curves) : std::nullopt;
  if (!certificate) throw Unproven("no certificate: there is no widest disc, or crossings of walls were rounded");
  return certificate_text(*certificate, write_plain_integers(plain_world(walled)), {from, *to.point});
}

std::string arcs(const FreeSpace& space, Point from, const Goal& to, double radius) {
  if (!to.point) throw InputError("", 0, "a certificate of a disc is for a goal that is a point, not for a room");
  const std::array ends{from, *to.point};
  const ArcSearchResult found = arc_search(TangentGraph(space, radius), from, *to.point);
  if (found.status != DiscStatus::found) throw Unproven("no certificate: no path of the disc was found");
  const auto certificate = ArcProver(disc_ground(space.world(), from, *to.point), radius).certificate(found.path);
  if (!certificate) throw Unproven("no certificate: the disc's radius is too fine for the world's numbers");
  return certificate_text(*certificate, arc_texts(space.world(), radius, ends));
}

std::string certificate(const FreeSpace& space, const std::optional<Point>& start, const Goal& goal, bool wants_widest,
                        const std::optional<double>& radius) {
  if (radius && !(*radius >= World::kSmallest && *radius <= World::kLargest))
    throw py::value_error("a disc's radius is above 0");
  if (radius && wants_widest) throw py::value_error("of a radius or of the widest, not both");
  if (space.footprint().kind() == Footprint::Kind::disc ||
      ((wants_widest || radius) && !is_plain(space.world(), space.footprint())))
    throw py::value_error("the space is a robot's of which nothing can be proven; make it without a footprint");
  const Point from = start_of(space.world(), start);
  const Goal to = goal_of_query(space.world(), goal);
  const py::gil_scoped_release unlocked;
  require_ends(space, from, to);
  return about(space.world().source(), [&] {
    return radius ? arcs(space, from, to, *radius) : wants_widest ? widest(space, from, to) : shortest(space, from, to);
  });
}

proof::Judgement judged_arcs(const World& world, const ArcClaim& claim) {
  const ArcJudgement said = judge_arcs(
      claim, arc_texts(world, claim.radius, claim.ends), [](const std::string& text, const std::string& part) {
        const proof::Judgement one = proof::judge(text, part);
        return ArcJudgement{one.proven, one.words, static_cast<double>(one.length), static_cast<double>(one.bound), 0};
      });
  return {said.proven, "arcs", said.words, said.length, said.bound};
}

proof::Judgement judged(const FreeSpace& space, const std::string& text) {
  const auto ends = disc_ends(text);
  const FreeSpace asked = ends ? FreeSpace(walled_world(space.world(), {(*ends)[0], (*ends)[1]})) : space;
  try {
    if (const auto claim = arc_claim(text)) return judged_arcs(space.world(), *claim);
    return proof::judge(write_plain_integers(plain_world(asked)), text);
  } catch (const proof::BadInput& error) {
    throw InputError("", 0, error.what());
  }
}

void bind_certificates(py::module_& m) {
  using proof::Judgement;
  py::class_<Judgement>(m, "Judgement", "What the judge of certificates says.")
      .def_readonly("proven", &Judgement::proven)
      .def_readonly("kind", &Judgement::kind, "'shortest', 'none', 'widest', 'arcs'.")
      .def_readonly("words", &Judgement::words, "What is proven, or what refutes it.")
      .def_property_readonly(
          "length", [](const Judgement& j) { return static_cast<double>(j.length); },
          "Of the path given; of the widest how far its path keeps from walls.")
      .def_property_readonly(
          "bound", [](const Judgement& j) { return static_cast<double>(j.bound); },
          "No path is shorter; no disc of a greater radius gets through.")
      .def("__bool__", [](const Judgement& j) { return j.proven; })
      .def("__repr__", [](const Judgement& j) {
        return fmt::format("<taut.Judgement {}: {}>", j.proven ? "proven" : "not proven", j.words);
      });
  m.def("certificate", &certificate, py::arg("space"), py::arg("start") = py::none(), py::arg("goal") = py::none(),
        py::kw_only(), py::arg("widest") = false, py::arg("radius") = py::none(),
        "A proof, as text, that no path is shorter, or that there is none; with widest that no larger disc gets "
        "through; with a radius what no path of that disc is shorter than. Of a point or a square. Raises InputError "
        "when an end is not free, Unproven.");
  m.def(
      "judge", &judged, Unlocked(), py::arg("space"), py::arg("certificate"),
      "Does the certificate, as text, prove what it says of the space? A Judgement, by signs of integers alone. Raises "
      "InputError when it cannot be read.");
}

// ---- audits ---------------------------------------------------------------------------------------------------------

struct Audited {
  PathAudit audit;
  std::optional<ShortestLength> shortest;

  std::optional<double> gap() const {
    if (!shortest) return std::nullopt;
    return std::max(0.0, audit.length.value() - shortest->value);
  }
};

Audited audit(const World& world, const py::object& points, const Footprint& robot, bool gap) {
  const std::vector<Point> path = points_of(points, "points");
  for (const Point p : path)
    if (!is_in_reach(p)) throw InputError("", 0, "points: not all are points");
  const py::gil_scoped_release unlocked;
  const PathAuditor auditor(world, robot, path);
  Audited audited{auditor.audit(path), std::nullopt};
  if (gap && audited.audit.valid) audited.shortest = auditor.shortest(path.front(), path.back());
  return audited;
}

template <class Take>
auto of_contact(Take take) {
  return [take](const Audited& a) {
    using Value = decltype(take(*a.audit.contact));
    return a.audit.contact ? std::optional<Value>(take(*a.audit.contact)) : std::nullopt;
  };
}

void bind_audits(py::module_& m) {
  py::class_<Audited>(m, "Audit", "What there is to say of anybody's path.")
      .def_property_readonly("valid", [](const Audited& a) { return a.audit.valid; })
      .def_property_readonly(
          "reason", [](const Audited& a) { return a.audit.reason; }, "Empty when valid.")
      .def_property_readonly("leg", of_contact([](const PathContact& c) { return c.leg; }),
                             "The first that meets a wall, from 0; None where none does.")
      .def_property_readonly("at", of_contact([](const PathContact& c) { return c.at; }),
                             "Where the robot's reference point is then.")
      .def_property_readonly("on", of_contact([](const PathContact& c) { return c.on; }), "The wall's point.")
      .def_property_readonly("wall", of_contact([](const PathContact& c) { return text(c.wall); }),
                             "The wall in words, with its line in the file.")
      .def_property_readonly(
          "clearance", [](const Audited& a) { return a.audit.clearance; },
          "The least distance between robot and walls; inf without walls, 0 when not valid.")
      .def_property_readonly("length", [](const Audited& a) { return a.audit.length.value(); })
      .def_property_readonly("exact_length", [](const Audited& a) { return a.audit.length; })
      .def_property_readonly(
          "shortest", [](const Audited& a) { return a.shortest ? std::optional(a.shortest->value) : std::nullopt; },
          "The length of the shortest path between its ends; None without one.")
      .def_property_readonly("gap", &Audited::gap, "How much longer it is than that.")
      .def("__bool__", [](const Audited& a) { return a.audit.valid; })
      .def("__repr__", [](const Audited& a) {
        return a.audit.valid ? std::string("<taut.Audit valid>") : "<taut.Audit: " + a.audit.reason + ">";
      });
  m.def(
      "audit", &audit, py::arg("world"), py::arg("points"), py::arg("robot") = Footprint::point(), py::kw_only(),
      py::arg("gap") = true,
      "Can the robot follow the points (n, 2), where does it first meet a wall, how near does it come, how much longer "
      "than the shortest is it? An Audit; a disc is taken for the disc itself.");
}

// ---- fleets ---------------------------------------------------------------------------------------------------------

fleet::Robot robot_of(const py::handle& rows, double radius, std::size_t number) {
  return {std::to_string(number), radius, timed_points_of(rows, fmt::format("robot {}", number))};
}

std::vector<fleet::Collision> collisions(const py::sequence& given, const py::object& radius, bool stay) {
  std::vector<fleet::Robot> robots;
  const bool is_one = py::isinstance<py::float_>(radius) || py::isinstance<py::int_>(radius);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const double r = is_one ? radius.cast<double>() : radius.cast<std::vector<double>>().at(i);
    if (!(r > 0 && r <= World::kLargest)) throw InputError("", 0, "a disc's radius is above 0");
    robots.push_back(robot_of(given[i], r, i));
  }
  const py::gil_scoped_release unlocked;
  return fleet::collisions(robots, stay ? fleet::Ends::stay : fleet::Ends::vanish);
}

void bind_fleets(py::module_& m) {
  using fleet::Collision;
  py::class_<Collision>(m, "Collision", "Two robots that are nearer than the sum of their radii.")
      .def_property_readonly(
          "robots", [](const Collision& c) { return std::pair(c.first, c.second); }, "By number.")
      .def_property_readonly("legs", [](const Collision& c) { return std::pair(c.first_leg, c.second_leg); })
      .def_property_readonly(
          "times", [](const Collision& c) { return std::pair(c.from, c.to); }, "From, to.")
      .def_property_readonly(
          "at", [](const Collision& c) { return std::pair(c.first_at, c.second_at); }, "Their centres when it begins.")
      .def("__repr__", [](const Collision& c) {
        return fmt::format("<taut.Collision of {} and {} from {} to {}>", c.first, c.second, c.from, c.to);
      });
  m.def("collisions", &collisions, py::arg("robots"), py::arg("radius"), py::kw_only(), py::arg("stay") = true,
        "All collisions of discs, by time. robots: for each rows time, x, y (n, 3), straight and even in between; "
        "radius: "
        "of all, or one each. Without stay they are nowhere before their first and after their last time. Exact.");
}

}  // namespace

void bind_proofs(py::module_& m) {
  bind_certificates(m);
  bind_audits(m);
  bind_fleets(m);
}

}  // namespace taut::python
