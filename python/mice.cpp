#include <fmt/format.h>

#include <taut/io/pictures/mouse_svg.h>
#include <taut/io/results/words.h>
#include <taut/python/bind.h>
#include <taut/robots/micromouse/explorers.h>
#include <taut/robots/micromouse/trial.h>

namespace taut::python {

namespace {

using namespace micromouse;

struct Run {
  std::shared_ptr<const GridMaze> maze;
  Record record;
  std::string title;
};

bool is_reset(const py::object& action) {
  const auto says = [](const py::handle& word) {
    return py::isinstance<py::str>(word) && py::str(word.attr("lower")()).equal(py::str("reset"));
  };
  if (says(action)) return true;
  return py::isinstance<py::sequence>(action) && py::len(action) == 2 && says(py::object(action[py::int_(0)]));
}

int whole_of(const py::handle& number) {
  const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(number.ptr()));
  if (!index) throw py::error_already_set();
  // What is far out of range is as illegal as what is a little.
  return static_cast<int>(std::clamp<long long>(index.cast<long long>(), -1000, 1000));
}

/// A robot that a Python object is: its next_move gets (left, front, right) and gives (rotation, movement).
class PythonRobot : public Robot {
 public:
  explicit PythonRobot(py::object robot) : next_move_(robot.attr("next_move")) {}

  Action next(const SensorReading& sight) override {
    const py::object action = next_move_(py::make_tuple(sight.left, sight.front, sight.right));
    if (is_reset(action)) return kReset;
    if (!py::isinstance<py::sequence>(action) || py::len(action) != 2)
      throw py::type_error("next_move gives rotation, movement, or 'reset', not " + std::string(py::repr(action)));
    const py::sequence pair = action;
    return {whole_of(py::object(pair[0])), whole_of(py::object(pair[1]))};
  }

 private:
  py::object next_move_;
};

std::shared_ptr<const GridMaze> maze_of(const World& world) {
  if (!world.grid()) throw Refusal(InputError(world.source(), 0, "is no maze of cells"), world.source());
  return world.grid();
}

Run run_named(const std::shared_ptr<const GridMaze>& maze, const std::string& name, int max_steps, std::uint64_t seed) {
  const auto explorer = explorer_named(name);
  if (!explorer) throw py::value_error("robot: there is no explorer '" + name + "'");
  const py::gil_scoped_release unlocked;
  const auto robot = make_explorer(*explorer, task_of(*maze, max_steps), seed);
  return {maze, run_trial(*maze, *robot, max_steps), name};
}

Run run_python(const std::shared_ptr<const GridMaze>& maze, py::object robot, int max_steps) {
  const Task task = task_of(*maze, max_steps);
  const std::string title = PyType_Check(robot.ptr()) ? robot.attr("__name__").cast<std::string>()
                                                      : py::type::of(robot).attr("__name__").cast<std::string>();
  if (PyType_Check(robot.ptr())) robot = robot(task.width);
  PythonRobot driven(robot);
  return {maze, run_trial(*maze, driven, max_steps), title};
}

Run run(const World& world, const py::object& robot, int max_steps, std::uint64_t seed) {
  if (max_steps < 1) throw py::value_error("max_steps: at least 1");
  const auto maze = maze_of(world);
  return about(world.source(), [&] {
    return py::isinstance<py::str>(robot) ? run_named(maze, robot.cast<std::string>(), max_steps, seed)
                                          : run_python(maze, robot, max_steps);
  });
}

py::array steps_of(const Run& run) {
  std::vector<std::int32_t> rows;
  for (const Step& s : run.record.steps)
    rows.insert(rows.end(),
                {s.run, s.before.cell.x, s.before.cell.y, 90 * static_cast<int>(s.before.heading), s.sight.left,
                 s.sight.front, s.sight.right, s.action.rotation, s.moved, static_cast<int>(s.action.reset)});
  return moved(std::move(rows), {static_cast<py::ssize_t>(run.record.steps.size()), 10});
}

py::list offences_of(const Run& run) {
  py::list offences;
  for (std::size_t i = 0; i < run.record.steps.size(); ++i)
    if (const Offence offence = run.record.steps[i].offence; offence != Offence::none)
      offences.append(py::make_tuple(i, std::string(name(offence))));
  return offences;
}

std::string text(const Run& run) {
  if (const auto score = run.record.score()) return fmt::format("score {}", number_text(*score));
  return std::string(name(run.record.status));
}

std::string picture(const Run& run) {
  return mouse_svg(*run.maze, run.record, {.title = run.title, .facts = {text(run)}});
}

py::list names() {
  py::list all;
  for (const Explorer explorer : all_explorers()) all.append(std::string(name(explorer)));
  return all;
}

}  // namespace

void bind_mice(py::module_& m) {
  py::class_<Run>(m, "MouseRun", "A micromouse trial as it went.")
      .def_property_readonly("finished", [](const Run& r) { return r.record.status == TrialStatus::finished; })
      .def_property_readonly(
          "status", [](const Run& r) { return std::string(name(r.record.status)); }, "In words.")
      .def_property_readonly(
          "score", [](const Run& r) { return r.record.score(); },
          "Steps of run 2, and a thirtieth of those of run 1; None unless finished.")
      .def_property_readonly(
          "run1", [](const Run& r) { return r.record.run1; }, "Steps, the reset included.")
      .def_property_readonly("run2", [](const Run& r) { return r.record.run2; })
      .def_property_readonly(
          "steps", &steps_of,
          "(n, 10) int32, a row a step: run, x, y, heading in degrees clockwise from north, what was "
          "seen left, ahead, right, the rotation asked for, cells moved, 1 for a reset.")
      .def_property_readonly("offences", &offences_of, "(step, what): actions that the rules do not know.")
      .def("_repr_svg_", &picture, Unlocked())
      .def("__repr__", [](const Run& r) {
        return fmt::format("<taut.MouseRun {}: {}, {} + {} steps>", r.title, text(r), r.record.run1, r.record.run2);
      });
  m.def(
      "run_mouse", &run, py::arg("maze"), py::arg("robot"), py::kw_only(), py::arg("max_steps") = kMaxSteps,
      py::arg("seed") = 1,
      "A contest of two runs in a maze, a World that came from cells. robot: the name of one of mouse_explorers(), an "
      "object with next_move((left, front, right)) -> (rotation, movement), or a class of such, made from the maze's "
      "width. rotation: -90, 0, 90; movement: -3 to 3 cells; 'reset', or a pair that begins with it, ends run 1. "
      "Raises InputError when the maze has openings or no cells, and what next_move raises.");
  m.def("mouse_explorers", &names, "The names of the robots that come with taut.");
}

}  // namespace taut::python
