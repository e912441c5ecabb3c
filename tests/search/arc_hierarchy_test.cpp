#include <taut/search/detail/arc_hierarchy_query.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <queue>
#include <set>

#include "support/random_world.h"

namespace taut {
namespace {

using detail::ArcDoor;
using detail::ArcHierarchy;
using detail::ArcHierarchyQuery;
using detail::TurnableGraph;

/// Each pair of nodes (2 i, 2 i + 1) is one turned, and some nodes are their own turned ones; edges at random.
TurnableGraph any_graph(std::uint32_t pairs, std::uint32_t edges, bool alone) {
  TurnableGraph graph;
  for (std::uint32_t i = 0; i < pairs; ++i) {
    graph.turned.push_back(2 * i + 1);
    graph.turned.push_back(2 * i);
  }
  if (alone)
    for (std::uint32_t n = 2 * pairs; n < 2 * pairs + 3; ++n) graph.turned.push_back(n);
  const int last = static_cast<int>(graph.size()) - 1;
  std::vector<std::vector<TurnableGraph::Edge>> out(graph.size());
  for (std::uint32_t e = 0; e < edges; ++e) {
    const auto from = static_cast<std::uint32_t>(test::any(0, last)),
               to = static_cast<std::uint32_t>(test::any(0, last));
    const double length = test::any(1, 1000);
    out[from].push_back({to, length});
    out[graph.turned[to]].push_back({graph.turned[from], length});
  }
  graph.first.push_back(0);
  for (const auto& list : out) {
    graph.edges.insert(graph.edges.end(), list.begin(), list.end());
    graph.first.push_back(static_cast<std::uint32_t>(graph.edges.size()));
  }
  return graph;
}

struct Plain {
  double length = std::numeric_limits<double>::infinity();
  bool passes_twice = false;  // a node and its turned one
};

Plain plain_way(const TurnableGraph& graph, const std::vector<ArcDoor>& entries, const std::vector<ArcDoor>& exits) {
  std::vector<double> at(graph.size(), std::numeric_limits<double>::infinity());
  std::vector<std::uint32_t> before(graph.size(), kNone);
  std::priority_queue<std::pair<double, std::uint32_t>, std::vector<std::pair<double, std::uint32_t>>, std::greater<>>
      open;
  const auto reach = [&](std::uint32_t n, double length, std::uint32_t from) {
    if (length >= at[n]) return;
    at[n] = length;
    before[n] = from;
    open.emplace(length, n);
  };
  for (const ArcDoor& door : entries) reach(door.node, door.length, kNone);
  while (!open.empty()) {
    const auto [length, n] = open.top();
    open.pop();
    if (length > at[n]) continue;
    for (std::uint32_t e = graph.first[n]; e < graph.first[n + 1]; ++e)
      reach(graph.edges[e].to, length + graph.edges[e].length, n);
  }
  Plain result;
  std::uint32_t last = kNone;
  for (const ArcDoor& door : exits)
    if (at[door.node] + door.length < result.length) {
      result.length = at[door.node] + door.length;
      last = door.node;
    }
  std::set<std::uint32_t> passed;
  for (; last != kNone; last = before[last]) {
    result.passes_twice |= passed.count(graph.turned[last]) > 0;
    passed.insert(last);
  }
  return result;
}

void leads_along_edges(const TurnableGraph& graph, const ArcHierarchyQuery::Way& way,
                       const std::vector<ArcDoor>& entries, const std::vector<ArcDoor>& exits) {
  RC_ASSERT(way.nodes.front() == entries[way.entry].node);
  RC_ASSERT(way.nodes.back() == exits[way.exit].node);
  double length = entries[way.entry].length + exits[way.exit].length;
  for (std::size_t i = 0; i + 1 < way.nodes.size(); ++i) {
    double shortest = std::numeric_limits<double>::infinity();
    for (std::uint32_t e = graph.first[way.nodes[i]]; e < graph.first[way.nodes[i] + 1]; ++e)
      if (graph.edges[e].to == way.nodes[i + 1]) shortest = std::min(shortest, graph.edges[e].length);
    length += shortest;
  }
  RC_ASSERT(length == way.length);
}

// Dense ones keep a core, thin ones none.
RC_GTEST_PROP(ArcHierarchy, FindsWaysAsShortAsASearchWithoutIt, ()) {
  const int pairs = test::any(2, 60);
  const TurnableGraph graph = any_graph(pairs, pairs * test::any(1, 12), test::any(0, 1) == 1);
  const ArcHierarchy hierarchy(graph);
  ArcHierarchyQuery query(hierarchy);
  const auto doors = [&] {
    std::vector<ArcDoor> result;
    for (int n = test::any(1, 3); n > 0; --n)
      result.push_back({static_cast<std::uint32_t>(test::any(0, int(graph.size()) - 1)), double(test::any(0, 100))});
    return result;
  };
  for (int n = 0; n < 5; ++n) {
    const std::vector<ArcDoor> entries = doors(), exits = doors();
    const Plain wanted = plain_way(graph, entries, exits);
    const ArcHierarchyQuery::Way way = query.find(entries, exits);
    RC_ASSERT(way.length >= wanted.length);
    RC_ASSERT(way.nodes.empty() == (way.length == std::numeric_limits<double>::infinity()));
    if (!way.nodes.empty()) leads_along_edges(graph, way, entries, exits);
    if (!wanted.passes_twice) RC_ASSERT(way.length == wanted.length);
  }
}

}  // namespace
}  // namespace taut
