// disc MAZE RADIUS: the widest passage, and the shortest way of a disc of that radius, with its arcs.
#include <cstdio>
#include <cstdlib>

#include <taut/io/worlds/read_world.h>
#include <taut/roadmaps/tangent_graph.h>
#include <taut/search/arc_search.h>
#include <taut/search/verify_arcs.h>

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: disc MAZE RADIUS\n"), 2;
  const taut::World world = taut::read_world_file(argv[1]);
  const taut::FreeSpace space(world);
  const taut::TangentGraph graph(space, std::atof(argv[2]));
  const auto found = taut::arc_search(graph, world.start().value(), world.goal().point.value());
  if (found.status != taut::DiscStatus::found) return std::puts("it does not get through"), 1;
  for (const taut::ArcPiece& piece : taut::pieces(found.path))
    std::printf("%s (%.6f, %.6f) to (%.6f, %.6f)\n", piece.turn == 0 ? "straight" : "arc     ", piece.from.x,
                piece.from.y, piece.to.x, piece.to.y);
  std::printf("length %.9f\n", found.path.value());
}
