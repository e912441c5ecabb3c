// solve MAZE: the shortest path, checked, a point a line.
#include <cstdio>

#include <taut/io/worlds/read_world.h>
#include <taut/search/shortest_path.h>
#include <taut/search/verify.h>

int main(int argc, char** argv) try {
  if (argc != 2) return std::fprintf(stderr, "usage: solve MAZE\n"), 2;
  const taut::World world = taut::read_world_file(argv[1]);
  const taut::FreeSpace space(world);
  const auto path = taut::shortest_path(space, world.start().value(), world.goal());
  if (!path) return std::puts("no path"), 1;
  for (const taut::Point p : path->points) std::printf("%.17g %.17g\n", p.x, p.y);
  std::printf("# length %s\n", path->length.decimals(9).c_str());
  return taut::verify(*path, space, *world.start(), world.goal()).valid ? 0 : 70;
} catch (const taut::InputError& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 3;
}
