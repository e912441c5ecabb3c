#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graphml.hpp>
#include <boost/property_map/dynamic_property_map.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <sstream>
#include <string>

#include <taut/geometry/length.h>
#include <taut/io/results/detail/graphml_number.h>
#include <taut/io/results/roadmap_export.h>

namespace taut {

namespace {

using Number = detail::GraphmlNumber;

}  // namespace

// write_graphml wants a list of edges, each once; a Roadmap lists them from both ends.
std::string roadmap_graphml(const Roadmap& roadmap) {
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
  using Node = Graph::vertex_descriptor;
  using Edge = Graph::edge_descriptor;
  Graph graph(roadmap.vertex_count());
  for (Roadmap::Vertex v = 0; v < roadmap.vertex_count(); ++v)
    for (const Roadmap::Vertex w : roadmap.neighbours(v))
      if (v < w) add_edge(v, w, graph);
  const auto point = [&](Node v) { return roadmap.point(static_cast<Roadmap::Vertex>(v)); };
  const auto x = [=](Node v) { return Number{point(v).x}; };
  const auto y = [=](Node v) { return Number{point(v).y}; };
  const auto length = [&](const Edge& e) {
    return Number{distance_interval(point(source(e, graph)), point(target(e, graph))).lo};
  };
  boost::dynamic_properties properties;
  properties.property("x", boost::make_function_property_map<Node>(x));
  properties.property("y", boost::make_function_property_map<Node>(y));
  properties.property("length", boost::make_function_property_map<Edge>(length));
  std::ostringstream out;
  boost::write_graphml(out, graph, properties, true);
  return detail::with_doubles(out.str());
}

}  // namespace taut
