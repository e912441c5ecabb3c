#include <taut/python/bind.h>

namespace taut::python {

namespace {

// The number that the text begins with, before a colon and a blank; cut off with them.
int cut_line(std::string& text) {
  const std::size_t end = text.find_first_not_of("0123456789");
  if (end == 0 || end == std::string::npos || text.compare(end, 2, ": ") != 0) return 0;
  const int line = std::stoi(text.substr(0, end));
  text.erase(0, end + 2);
  return line;
}

// taut/_errors.py says what they are, with docstrings.
void raise(const char* name, const py::tuple& arguments) {
  const py::object type = py::module_::import("taut._errors").attr(name);
  PyErr_SetObject(type.ptr(), type(*arguments).ptr());
}

void raise(const Refusal& refusal) {
  const py::object none = py::none();
  raise("InputError", py::make_tuple(refusal.what(), refusal.file.empty() ? none : py::str(refusal.file),
                                     refusal.line == 0 ? none : py::int_(refusal.line), refusal.culprit));
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Refusal& refusal) {
    raise(refusal);
  } catch (const InputError& error) {
    raise(Refusal(error, ""));
  } catch (const TooFine& error) {
    raise("TooFine", py::make_tuple(error.what()));
  } catch (const py::cast_error&) {
    PyErr_SetString(PyExc_TypeError, "an argument is of a type that cannot be");
  } catch (const Unproven& error) {
    raise("Unproven", py::make_tuple(error.what()));
  }
}

}  // namespace

Refusal::Refusal(const InputError& error, const std::string& source)
    : std::runtime_error(error.what()), culprit(error.what()) {
  if (!source.empty() && culprit.starts_with(source + ":")) {
    file = source;
    culprit.erase(0, source.size() + 1);
    if (culprit.starts_with(" "))
      culprit.erase(0, 1);
    else
      line = cut_line(culprit);
  } else if (source.empty() && culprit.starts_with("line ")) {
    std::string rest = culprit.substr(5);
    line = cut_line(rest);
    if (line > 0) culprit = rest;
  }
}

void bind_errors(py::module_&) { py::register_exception_translator(translate); }

}  // namespace taut::python
