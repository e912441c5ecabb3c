// Lines of `taut batch`: queries, and walls that come and go between them. Each answer is that of the changed world,
// prepared anew, and by two searches.
#include <cmath>
#include <sstream>

#include <taut/cli/solve/wall_lines.h>
#include <taut/geometry/free_space.h>
#include <taut/io/worlds/query_lines.h>
#include <taut/io/worlds/read_world.h>
#include <taut/search/changing_world.h>
#include <taut/search/index.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

#include "fuzz/fuzzed.h"

namespace {

using namespace taut;

constexpr int kMostLines = 12;

const Index& room() {
  static const Index index(
      FreeSpace(read_world("boundary 0 0 8 8\n4 0 4 5\n2 2 2 8\n5 6 8 6\nsolid 5 1 7 1 7 3 5 3\n")));
  return index;
}

bool is_place(const FreeSpace& space, Point p) { return space.locate(p).kind != Location::Kind::outside; }

void ask(ChangingWorld& world, const QueryLine& query, const std::string& text) {
  if (!is_place(world.space(), query.from) || !is_place(world.space(), query.to)) return;
  // Where crossings were rounded, an end may stand on the other side of a wall.
  if (world.space().report().displacement > 0) return;
  const bool is_found = world.find(query.from, query.to) == SearchStatus::found;
  const auto anew = shortest_path(world.space(), query.from, query.to);
  fuzz::require(is_found == anew.has_value(), "found in one world alone\n" + text);
  if (!is_found) return;
  const Length length(world.points());
  fuzz::require(length == anew->length, "of another length\n" + text);
  const Verdict verdict = verify(Path{world.points(), length}, world.space(), query.from, Goal{query.to, {}});
  fuzz::require(verdict.valid, "a path that is none: " + verdict.reason + "\n" + text);
}

void read_lines(const std::string& text, bool is_indexed) {
  ChangingWorld world = is_indexed ? ChangingWorld(room()) : ChangingWorld(room().space());
  QueryReader reader("queries");
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; number <= kMostLines && std::getline(lines, line); ++number) {
    if (const auto wall = cli::wall_line(line, "queries", number)) {
      if (wall->adds)
        world.add({wall->wall.a, wall->wall.b, 0, number});
      else
        world.remove(wall->wall);
    } else if (const auto query = reader.read(line, number)) {
      ask(world, *query, text);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  fuzz::read([&] { read_lines(text, data[0] % 2U == 0); });
  return 0;
}
