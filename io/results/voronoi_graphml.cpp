#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graphml.hpp>
#include <boost/property_map/dynamic_property_map.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <sstream>
#include <string>

#include <taut/io/results/detail/graphml_number.h>
#include <taut/io/results/voronoi_export.h>

namespace taut {

namespace {

using Number = detail::GraphmlNumber;

}  // namespace

std::string voronoi_graphml(const VoronoiRoadmap& map) {
  using Index = boost::property<boost::edge_index_t, std::size_t>;
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Index>;
  using Node = Graph::vertex_descriptor;
  using Edge = Graph::edge_descriptor;
  Graph graph(map.vertices().size());
  for (std::size_t e = 0; e < map.edges().size(); ++e) add_edge(map.edges()[e].from, map.edges()[e].to, e, graph);
  const auto edge = [&](const Edge& e) -> const VoronoiEdge& { return map.edges()[get(boost::edge_index, graph, e)]; };
  const auto x = [&](Node v) { return Number{map.vertices()[v].at.x}; };
  const auto y = [&](Node v) { return Number{map.vertices()[v].at.y}; };
  const auto room = [&](Node v) { return Number{std::sqrt(map.vertices()[v].clearance_squared)}; };
  const auto length = [&](const Edge& e) { return Number{edge(e).length}; };
  const auto least = [&](const Edge& e) { return Number{edge(e).clearance}; };
  boost::dynamic_properties properties;
  properties.property("x", boost::make_function_property_map<Node>(x));
  properties.property("y", boost::make_function_property_map<Node>(y));
  properties.property("clearance", boost::make_function_property_map<Node>(room));
  properties.property("length", boost::make_function_property_map<Edge>(length));
  properties.property("clearance", boost::make_function_property_map<Edge>(least));
  std::ostringstream out;
  boost::write_graphml(out, graph, properties, true);
  return detail::with_doubles(out.str());
}

}  // namespace taut
