// taut._taut: the library, as the package in python/taut shows it.
#include <taut/python/bind.h>
#include <taut/python/proofs.h>

PYBIND11_MODULE(_taut, m) {
  m.doc() = "Exact motion planning in the plane. Use the package `taut`, not this.";
  m.attr("__version__") = TAUT_VERSION;
  taut::python::bind_errors(m);
  taut::python::bind_lengths(m);
  taut::python::bind_worlds(m);
  taut::python::bind_reading(m);
  taut::python::bind_free_spaces(m);
  taut::python::bind_paths(m);
  taut::python::bind_polyanya(m);
  taut::python::bind_indexes(m);
  taut::python::bind_roadmaps(m);
  taut::python::bind_planners(m);
  taut::python::bind_discs(m);
  taut::python::bind_passage_index(m);
  taut::python::bind_clearance(m);
  taut::python::bind_tradeoff(m);
  taut::python::bind_snapping(m);
  taut::python::bind_grids(m);
  taut::python::bind_mice(m);
  taut::python::bind_chases(m);
  taut::python::bind_meetings(m);
  taut::python::bind_bugs(m);
  taut::python::bind_cars(m);
  taut::python::bind_proofs(m);
}
