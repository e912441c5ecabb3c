// spanning_tree MAZE: Boost.Graph's Kruskal on taut's visibility graph, which is not copied.
#include <cstdio>
#include <iterator>
#include <vector>

#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <taut/io/worlds/read_world.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/boost_graph.h>

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: spanning_tree MAZE\n"), 2;
  const taut::VisibilityGraph graph(taut::FreeSpace(taut::read_world_file(argv[1])), taut::VisibilityKind::full);
  const taut::Roadmap& roadmap = graph.roadmap();
  std::vector<taut::RoadmapEdge> tree;
  boost::kruskal_minimum_spanning_tree(roadmap, std::back_inserter(tree));
  double length = 0;
  for (const taut::RoadmapEdge& edge : tree) length += get(boost::edge_weight, roadmap, edge);
  std::printf("%zu corners, %zu legs, spanned by %zu of length %.6f\n", roadmap.vertex_count(), roadmap.edge_count(),
              tree.size(), length);
}
