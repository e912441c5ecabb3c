#include <taut/search/boost_graph.h>

#include <gtest/gtest.h>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <vector>

namespace taut {
namespace {

BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Roadmap>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<Roadmap>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Roadmap>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<Roadmap>));

TEST(BoostGraph, RunsAUsersOwnDijkstraOnARoadmap) {
  using Edges = std::vector<std::pair<Roadmap::Vertex, Roadmap::Vertex>>;
  const Roadmap map({{0, 0}, {3, 4}, {3, 5}, {9, 9}}, Edges{{0, 1}, {1, 2}});
  std::vector<double> distance(map.vertex_count());
  std::vector<Roadmap::Vertex> predecessor(map.vertex_count());
  const auto index = get(boost::vertex_index, map);
  boost::dijkstra_shortest_paths(map, Roadmap::Vertex{0},
                                 boost::weight_map(get(boost::edge_weight, map))
                                     .distance_map(boost::make_iterator_property_map(distance.begin(), index))
                                     .predecessor_map(boost::make_iterator_property_map(predecessor.begin(), index)));
  EXPECT_EQ(distance[2], 6);
  EXPECT_EQ(predecessor[2], 1u);
  EXPECT_EQ(distance[3], std::numeric_limits<double>::max());
}

TEST(BoostGraph, ListsEveryEdgeFromBothItsEnds) {
  using Edges = std::vector<std::pair<Roadmap::Vertex, Roadmap::Vertex>>;
  const Roadmap map({{0, 0}, {1, 0}, {9, 9}, {2, 0}, {5, 5}}, Edges{{0, 1}, {1, 3}, {0, 3}});
  const auto [begin, end] = edges(map);
  const std::vector<RoadmapEdge> all(begin, end);
  EXPECT_EQ(all, (std::vector<RoadmapEdge>{{0, 1}, {0, 3}, {1, 0}, {1, 3}, {3, 0}, {3, 1}}));
  EXPECT_EQ(num_edges(map), all.size());
  const Roadmap empty;
  EXPECT_TRUE(edges(empty).first == edges(empty).second);
}

TEST(BoostGraph, RunsKruskalOnARoadmap) {
  using Edges = std::vector<std::pair<Roadmap::Vertex, Roadmap::Vertex>>;
  const Roadmap map({{0, 0}, {3, 0}, {3, 4}, {9, 9}}, Edges{{0, 1}, {1, 2}, {0, 2}});
  std::vector<RoadmapEdge> tree;
  boost::kruskal_minimum_spanning_tree(map, std::back_inserter(tree));
  double length = 0;
  for (const RoadmapEdge& e : tree) length += get(boost::edge_weight, map, e);
  EXPECT_EQ(tree.size(), 2u);
  EXPECT_EQ(length, 7);
}

}  // namespace
}  // namespace taut
