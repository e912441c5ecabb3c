// The lines of a file of options.
#pragma once

#include <string>
#include <vector>

namespace taut::cli {

/// One line `name = value` of such a file.
struct Setting {
  std::string section{};  ///< `grid.solve`; empty before the first
  std::string name{};
  std::vector<std::string> values{};  ///< more than one, or none, only of a list
  bool is_word = false;               ///< neither a list nor in quotes
  int line = 0;                       ///< from 1
};

/// What of TOML and INI such files need, a line each: `[section]`, `name = value`, `section.name = value`, comments
/// after `#` or `;`. A value is a word up to the comment or the end (`3,4`, `true`), a text in "" (with \", \\, \n, \t)
/// or in '', or a list of these in [], with commas, on one line.
///
/// Throws InputError that names `source` and the line: what is none of these, a name without a value, a name that is
/// there twice.
std::vector<Setting> settings_of(const std::string& text, const std::string& source);

}  // namespace taut::cli
