// Files of queries: a start and a goal a line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <taut/geometry/point.h>

namespace taut {

/// A query and, where its line says so, the answer to compare with.
struct QueryLine {
  Point from;
  Point to;
  bool expects = false;              ///< the line says what the answer is
  std::optional<double> expected{};  ///< the length; absent when it says `none`
  int line = 0;
  double tolerance = 1e-6;  ///< how far from `expected` a length may be, absolute
  Point map{};              ///< the size of the map that it is for; 0 when not said
  double radius = 0;        ///< of the disc, where the line has one
};

/// `sx sy gx gy`, then nothing, the expected length, or `none`; separated by blanks or commas. Nothing for an empty
/// line and one that is a comment only (`#` starts one). Throws InputError with `source` and `number`.
std::optional<QueryLine> query_line(std::string_view line, const std::string& source, int number);

/// The same with a radius > 0 after the goal: `sx sy gx gy r`.
std::optional<QueryLine> disc_query_line(std::string_view line, const std::string& source, int number);

/// The lines of a file, one after the other. One that begins with `version` is a MovingAI scenario file of the
/// any-angle sets, whose columns and rows are corners of cells, that is points of the map; its lengths count as far as
/// their digits go.
class QueryReader {
 public:
  explicit QueryReader(std::string source) : source_(std::move(source)) {}

  /// Nothing for a line that holds no query. Throws InputError.
  std::optional<QueryLine> read(std::string_view line, int number);

 private:
  enum class Kind { unknown, queries, scenario };

  std::string source_;
  Kind kind_ = Kind::unknown;
};

}  // namespace taut
