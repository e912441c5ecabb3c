// Files of queries: a start and a goal a line.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <taut/geometry/point.h>

namespace taut {

struct QueryLine {
  Point from;
  Point to;
  bool expects = false;              ///< the line says what the answer is
  std::optional<double> expected{};  ///< the length; absent when it says `none`
  int line = 0;
};

/// `sx sy gx gy`, then nothing, the expected length, or `none`; separated by blanks or commas. Nothing for an empty line and one that is a comment only (`#` starts
/// one). Throws InputError with `source` and `number`.
std::optional<QueryLine> query_line(std::string_view line, const std::string& source, int number);

}  // namespace taut
