#include <taut/python/reading.h>

#include <taut/io/worlds/read_world.h>

namespace taut::python {

namespace {

ReadOptions::Polygons polygons_named(const std::string& word) {
  if (word == "free") return ReadOptions::Polygons::free;
  if (word == "obstacles") return ReadOptions::Polygons::obstacles;
  if (word == "nested") return ReadOptions::Polygons::nested;
  throw py::value_error("polygons: 'free', 'obstacles' or 'nested', not '" + word + "'");
}

template <class T>
void take(const py::kwargs& given, const char* name, T& into) {
  if (given.contains(name)) into = given[name].cast<T>();
}

ReadOptions options_of(const py::kwargs& given) {
  static constexpr std::array kNames{"format", "polygons",  "repair",  "cell_size", "resolution", "unknown_is_free",
                                     "snap",   "thickness", "project", "start",     "goal",       "source",
                                     "notes"};
  for (const auto& [name, value] : given)
    if (std::ranges::find(kNames, name.cast<std::string>()) == kNames.end())
      throw py::type_error("read_world: no such option '" + name.cast<std::string>() + "'");
  ReadOptions options;
  if (given.contains("format") && !given["format"].is_none()) {
    options.format = format_named(given["format"].cast<std::string>());
    if (!options.format) throw py::value_error("format: no such format " + std::string(py::repr(given["format"])));
  }
  if (given.contains("polygons")) options.polygons = polygons_named(given["polygons"].cast<std::string>());
  if (given.contains("repair") && given["repair"].cast<bool>()) options.crossings = Crossings::even_odd;
  if (given.contains("snap")) options.snap = snap_of(given["snap"]);
  take(given, "cell_size", options.cell_size);
  take(given, "resolution", options.resolution);
  take(given, "unknown_is_free", options.unknown_is_free);
  take(given, "thickness", options.wall_thickness);
  take(given, "project", options.project);
  take(given, "start", options.start);
  take(given, "goal", options.goal);
  take(given, "source", options.source);
  return options;
}

// `read` without the lock; what it has to remark goes to the list `notes`.
template <class Read>
World reading(const py::kwargs& given, const std::string& source, Read&& read) {
  ReadNotes notes;
  World world = [&] {
    const py::gil_scoped_release unlocked;
    return about(source, [&] { return read(notes); });
  }();
  if (given.contains("notes") && !given["notes"].is_none()) {
    py::list list = given["notes"];
    for (const std::string& remark : notes.remarks) list.append(remark);
  }
  return world;
}

World world_of_bytes(const std::string& bytes, const py::kwargs& given) {
  const ReadOptions options = options_of(given);
  return reading(given, options.source, [&](ReadNotes& notes) { return read_world(bytes, options, &notes); });
}

World world_of_file(const py::object& path, const py::kwargs& given) {
  const auto name = py::module_::import("os").attr("fspath")(path).cast<std::string>();
  const ReadOptions options = options_of(given);
  return reading(given, name, [&](ReadNotes& notes) { return read_world_file(name, options, &notes); });
}

constexpr const char* kText = R"(The world that a text, or bytes, of any format describes; found out from the content.

Options: format: 'segments', 'drawing', 'blocks', 'wkt', 'geojson', 'svg', 'movingai', 'ros', 'picture', 'maz', 'num',
'cells'. polygons without a role are 'free' (floor plans), 'obstacles' or 'nested'. repair: also rings that cross.
cell_size of grid mazes; resolution of a picture: metres a pixel; unknown_is_free of ROS maps. snap: as of World.
thickness of every wall. project: coordinates are longitude and latitude. start, goal instead of what is written.
source: a file's name for messages. notes: a list that takes a line for what one may wish to know.
Raises InputError with file, line and culprit.)";

}  // namespace

Snap snap_of(py::handle value) {
  if (value.is_none()) return {};
  if (py::isinstance<py::str>(value) && value.cast<std::string>() == "auto") return {Snap::What::automatic, 0};
  const double tolerance = py::isinstance<py::str>(value) ? -1 : value.cast<double>();
  if (!(tolerance >= 0 && tolerance <= World::kLargest)) throw py::value_error("snap: None, a distance, 0 or 'auto'");
  return tolerance == 0 ? Snap{Snap::What::nothing, 0} : Snap{Snap::What::within, tolerance};
}

void bind_reading(py::module_& m) {
  m.def("read_world", &world_of_bytes, py::arg("text"), kText);
  m.def("read_world_file", &world_of_file, py::arg("path"),
        "The world that a file, gzipped or not, describes; options as of read_world.");
}

}  // namespace taut::python
