#include <taut/search/boost_graph.h>

#include <gtest/gtest.h>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_concepts.hpp>

#include <vector>

namespace taut {
namespace {

BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Roadmap>));
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

}  // namespace
}  // namespace taut
