// Wrong input is a typed exception with one readable line.
#pragma once

#include <stdexcept>
#include <string>

namespace taut {

/// The input is wrong. what() is one line that names file, line and culprit, as far as each is known:
/// `cellar.csv:7: cell (3,6) says open to the right, cell (4,6) says wall`.
class InputError : public std::runtime_error {
 public:
  /// `source` is a file name or empty; `line` counts from 1, 0 means no line.
  InputError(const std::string& source, int line, const std::string& message)
      : std::runtime_error(prefix(source, line) + message) {}

 private:
  static std::string prefix(const std::string& source, int line) {
    std::string text = source;
    if (line > 0) text.append(text.empty() ? "line " : ":").append(std::to_string(line));
    if (!text.empty()) text.append(": ");
    return text;
  }
};

/// The input is sound, but too fine for double coordinates: what is built from it can't be rounded. One readable line.
class TooFine : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace taut
