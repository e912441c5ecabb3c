#include <taut/geometry/snap.h>
#include <taut/python/bind.h>
#include <taut/python/reading.h>

namespace taut::python {

namespace {

py::tuple joined(const World& world, const py::object& snap) {
  const Snap wanted = snap_of(snap);
  Snapped done = [&] {
    const py::gil_scoped_release unlocked;
    return about(world.source(), [&] { return snapped(world, wanted); });
  }();
  py::dict report;
  report["tolerance"] = done.report.tolerance;
  report["joined"] = done.report.joined;
  report["displacement"] = done.report.displacement;
  report["remaining"] = done.report.remaining.size();
  return py::make_tuple(std::move(done.world), report);
}

py::tuple contacts(const World& world) {
  std::vector<Point> ends;
  std::vector<Segment> walls;
  std::vector<double> distances;
  for (const NearContact& near : near_contacts(world)) {
    ends.push_back(near.end);
    walls.push_back(near.wall);
    distances.push_back(near.distance);
  }
  return py::make_tuple(points_array(std::move(ends)), segments_array(walls), moved(std::move(distances)));
}

}  // namespace

void bind_snapping(py::module_& m) {
  m.def("snapped", &joined, py::arg("world"), py::arg("snap"),
        "The world with what nearly touches joined, and a report: tolerance, joined, displacement, remaining. snap: a "
        "distance, 'auto', or None for what lies within rounding. Raises InputError when contacts remain.");
  m.def("near_contacts", &contacts, py::arg("world"),
        "What nearly touches: ends (n, 2), the wall or side that each is near (n, 4), distances (n,).");
}

}  // namespace taut::python
