#include <algorithm>
#include <fstream>
#include <limits>

#include <fmt/format.h>

#include <taut/io/saved/index_file.h>
#include <taut/python/asker.h>

namespace taut::python {

namespace {

constexpr std::size_t kAtOnce = 4096;  // queries, before it is looked whether to end

/// An index, and for what it leaves open (ends on walls that were moved, proofs that there is no path) an Asker.
class IndexAsker {
 public:
  explicit IndexAsker(Index index)
      : index_(std::move(index)), asker_(Polyanya(index_.space())), places_(index_.space()) {}

  const Index& index() const { return index_; }

  std::optional<FoundPath> find(Point from, Point to) const {
    IndexSearch search(index_);
    if (!asks_index(from, to) || search.find(from, to) != SearchStatus::found) return asker_.find(from, Goal{to, {}});
    return FoundPath{index_.space(), from,
                     {to, {}},       {search.points(), Length(search.points())},
                     true,           within_of(index_.space()),
                     "index",        search.scanned()};
  }

  /// Of rows first to last - 1.
  void answer(IndexSearch& search, const Doubles& rows, std::size_t first, std::size_t last, bool with_paths,
              Answers& answers) const {
    for (std::size_t i = first; i < last; ++i) {
      const double* row = rows.data(static_cast<py::ssize_t>(i), 0);
      const Ends ends{{row[0], row[1]}, {row[2], row[3]}};
      if (asks_index(ends.first, ends.second) && search.find(ends.first, ends.second) == SearchStatus::found) {
        answers.status.push_back(static_cast<std::uint8_t>(QueryStatus::found));
        answers.length.push_back(Length(search.points()).value());
        if (with_paths) answers.points.insert(answers.points.end(), search.points().begin(), search.points().end());
      } else {
        const Answers other = asker_.find_many({&ends, 1}, with_paths, 1, [] { return false; });
        answers.status.push_back(other.status[0]);
        answers.length.push_back(other.length[0]);
        answers.points.insert(answers.points.end(), other.points.begin(), other.points.end());
      }
      if (with_paths) answers.offsets.push_back(static_cast<std::int64_t>(answers.points.size()));
    }
  }

 private:
  bool asks_index(Point from, Point to) const {
    const auto is_known = [&](Point p) {
      return index_.space().locate(p).kind != Location::Kind::outside && !places_.is_moved(p);
    };
    return is_known(from) && is_known(to);
  }

  Index index_;
  Asker asker_;
  WrittenPlaces places_;
};

Answers many(const IndexAsker& asker, const py::object& given, bool with_paths) {
  const Doubles rows = rows_of(given, 4, "queries");
  const auto count = static_cast<std::size_t>(rows.shape(0));
  for (std::size_t i = 0; i < count; ++i) {
    const double* row = rows.data(static_cast<py::ssize_t>(i), 0);
    if (!is_in_reach({row[0], row[1]}) || !is_in_reach({row[2], row[3]}))
      throw InputError("", 0, fmt::format("queries: row {} holds what is no coordinate", i));
  }
  Answers answers;
  if (with_paths) answers.offsets.push_back(0);
  IndexSearch search(asker.index());
  for (std::size_t first = 0; first < count; first += kAtOnce) {
    {
      const py::gil_scoped_release unlocked;
      asker.answer(search, rows, first, std::min(count, first + kAtOnce), with_paths, answers);
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return answers;
}

void save(const IndexAsker& asker, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  file << index_file(asker.index());
  if (!file.flush()) throw InputError(path, 0, "cannot be written");
}

}  // namespace

void bind_indexes(py::module_& m) {
  py::class_<IndexAsker>(m, "Index",
                         "A free space prepared for queries of microseconds, in so many bytes at most. For thousands "
                         "of queries.")
      .def(py::init([](const FreeSpace& space, std::size_t memory) {
             return about(space.world().source(), [&] { return IndexAsker(Index(space, memory)); });
           }),
           Unlocked(), py::arg("space"), py::arg("memory") = Index::kMemory)
      .def_static(
          "load", [](const std::string& path, const FreeSpace& space) { return IndexAsker(load_index(path, space)); },
          Unlocked(), py::arg("path"), py::arg("space"),
          "What save() wrote, mapped, for the same world and robot. Raises InputError when it is another's or damaged.")
      .def("save", &save, Unlocked(), py::arg("path"), "Keeps it in a file, for load().")
      .def_property_readonly("space", [](const IndexAsker& asker) { return asker.index().space(); })
      .def_property_readonly(
          "bends", [](const IndexAsker& asker) { return asker.index().bend_count(); },
          "How many places there are where a path can bend.")
      .def_property_readonly(
          "nbytes", [](const IndexAsker& asker) { return asker.index().bytes().size(); }, "How large it is.")
      .def("find", &IndexAsker::find, Unlocked(), py::arg("start"), py::arg("goal"),
           "The shortest Path, as Polyanya's find; None when there is none, proven. Raises InputError when an end is "
           "not free, Unproven.")
      .def("find_many", &many, py::arg("queries"), py::kw_only(), py::arg("paths") = false,
           "Answers to queries (n, 4): start x y, goal x y; without Python's lock. paths: their points as well. Ctrl-C "
           "stops it.");
}

}  // namespace taut::python
