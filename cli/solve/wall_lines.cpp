#include <taut/cli/solve/wall_lines.h>

#include <taut/geometry/errors.h>
#include <taut/io/worlds/query_lines.h>

namespace taut::cli {

std::optional<WallLine> wall_line(std::string_view line, const std::string& source, int number) {
  constexpr std::string_view kWord = "wall";
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == std::string_view::npos || (line[first] != '+' && line[first] != '-')) return std::nullopt;
  const bool adds = line[first] == '+';
  line.remove_prefix(first + 1);
  if (!line.starts_with(kWord)) return std::nullopt;
  line.remove_prefix(kWord.size());
  // Four numbers, as in a query.
  const std::optional<QueryLine> ends = query_line(line, source, number);
  if (!ends || ends->expects) throw InputError(source, number, "a wall is four numbers: its ends x1 y1 x2 y2");
  return WallLine{adds, {ends->from, ends->to}};
}

}  // namespace taut::cli
