// The readers of all files that are no worlds: paths, points, queries, robots' mazes and maps, certificates, speed models,
// saved roadmaps. The first byte says which.
#include <sstream>

#include <taut/geometry/free_space.h>
#include <taut/io/saved/planned_roadmap.h>
#include <taut/io/worlds/certificate_file.h>
#include <taut/io/worlds/movingai.h>
#include <taut/io/worlds/query_lines.h>
#include <taut/io/worlds/read_chase_map.h>
#include <taut/io/worlds/read_path.h>
#include <taut/io/worlds/read_points.h>
#include <taut/io/worlds/read_world.h>
#include <taut/io/worlds/roadblock_map.h>
#include <taut/io/worlds/speed_model_file.h>

#include "fuzz/fuzzed.h"

namespace {

using namespace taut;

const FreeSpace& room() {
  static const FreeSpace space(read_world("0 0 4 0\n4 0 4 4\n4 4 0 4\n0 4 0 0\n2 0 2 3\nstart 1 2\ngoal 3 2\n"));
  return space;
}

void read_queries(const std::string& text) {
  QueryReader reader("queries");
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) reader.read(line, number);
}

// A scenario of a map that is scaled or not.
void read_scenarios(const std::string& text) {
  const auto scenarios = read_movingai_scenarios(text, "a.scen");
  fuzz::require(read_movingai_scenarios(movingai_scenario_text(scenarios), "b.scen").size() == scenarios.size(),
                "scenarios are lost");
}

void read_roadblocks(const std::string& text) {
  const auto map = read_roadblock_map(text, "map");
  read_roadblock_map(roadblock_map_text(map), "again");
}

void (*const kReaders[])(const std::string&) = {
    [](const std::string& text) { read_paths(text, "path"); },
    [](const std::string& text) { read_points(text, "points"); },
    read_queries,
    read_scenarios,
    [](const std::string& text) { read_movingai_map(text, "map"); },
    [](const std::string& text) { pursuit::read_chase_map(text, "chase"); },
    read_roadblocks,
    [](const std::string& text) { read_certificate(text, "certificate"); },
    [](const std::string& text) { read_speed_model(text, "model"); },
    [](const std::string& text) { load_roadmap(text, "saved", room()); },
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  fuzz::read([&] { kReaders[data[0] % std::size(kReaders)](text); });
  return 0;
}
