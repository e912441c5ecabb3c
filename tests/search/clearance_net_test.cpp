// The searches behind ClearanceSearch, beside loops of one's own: the same ways, not only the same lengths.
#include <taut/search/detail/clearance_net.h>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <boost/graph/graph_concepts.hpp>

#include "support/random_world.h"

namespace taut::detail {
namespace {

using test::any;

BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<WideArcs>));
BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<WideArcs>));

/// Few lengths and ranks, zero and parallel arcs and loops among them, so that nearly everything is tied.
ClearanceNet any_net() {
  ClearanceNet net;
  net.nodes = static_cast<std::uint32_t>(any(2, 12));
  const auto node = [&] { return static_cast<std::uint32_t>(any(0, static_cast<int>(net.nodes) - 1)); };
  for (int n = any(0, 30); n > 0; --n) {
    const std::uint32_t from = node(), to = node(),
                        rank = any(0, 4) == 0 ? kNone : static_cast<std::uint32_t>(any(0, 3));
    net.arcs.push_back({from, to, 0, rank, any(0, 3) / 10.0, {}});
  }
  net.index();
  return net;
}

std::vector<ArcFrom> arcs_from(const WideArcs& arcs, std::uint32_t v) {
  const auto [first, last] = out_edges(v, arcs);
  return {first, last};
}

ArcTree ways_by_a_loop(const WideArcs& arcs, std::uint32_t start, std::uint32_t goal) {
  const std::size_t n = num_vertices(arcs);
  ArcTree tree{std::vector<std::uint32_t>(n, kNone), std::vector<double>(n, HUGE_VAL)};
  std::set<std::pair<double, std::uint32_t>> open{{0, start}};
  tree.length[start] = 0;
  while (!open.empty()) {
    const auto [length, v] = *open.begin();
    open.erase(open.begin());
    if (v == goal) {
      tree.reached = true;
      break;
    }
    ++tree.expanded;
    for (const ArcFrom& e : arcs_from(arcs, v)) {
      const double longer = length + arcs.net().arcs[e.arc].length;
      if (longer >= tree.length[e.to]) continue;
      open.erase({tree.length[e.to], e.to});
      tree.length[e.to] = longer;
      tree.arc[e.to] = e.arc;
      open.insert({longer, e.to});
    }
  }
  return tree;
}

RC_GTEST_PROP(ClearanceNet, IsSearchedAsByAPlainLoop, ()) {
  const ClearanceNet net = any_net();
  for (std::uint32_t rank = 0; rank < 5; ++rank) {
    const ArcTree found = shortest_ways(WideArcs(net, rank), 0, net.nodes - 1);
    const ArcTree expected = ways_by_a_loop(WideArcs(net, rank), 0, net.nodes - 1);
    RC_ASSERT(found.reached == expected.reached);
    RC_ASSERT(found.length == expected.length);
    RC_ASSERT(found.arc == expected.arc);
    RC_ASSERT(found.expanded == expected.expanded);
  }
}

RC_GTEST_PROP(ClearanceNet, HasItsBottleneckWhereWiderArcsDoNotConnect, ()) {
  const ClearanceNet net = any_net();
  const auto connects = [&](std::uint32_t rank) {
    return ways_by_a_loop(WideArcs(net, rank), 0, net.nodes - 1).reached;
  };
  const auto bottleneck = widest_bottleneck(net, 0, net.nodes - 1);
  RC_ASSERT(bottleneck.has_value() == connects(0));
  if (!bottleneck) return;
  RC_ASSERT(connects(*bottleneck));
  RC_ASSERT(*bottleneck == kNone || !connects(*bottleneck + 1));
}

TEST(ClearanceNet, LeavesNarrowArcsOut) {
  ClearanceNet net;
  net.nodes = 2;
  net.arcs = {{0, 1, 0, 3, 1, {}}, {1, 0, 0, 7, 2, {}}, {0, 1, 0, kNone, 5, {}}};
  net.index();
  EXPECT_EQ(out_degree(0, WideArcs(net, 3)), 3u);
  EXPECT_EQ(arcs_from(WideArcs(net, 4), 1), (std::vector<ArcFrom>{{1, 0, 1}, {1, 0, 2}}));
  EXPECT_EQ(shortest_ways(WideArcs(net, 8), 0, 1).length[1], 5);
}

}  // namespace
}  // namespace taut::detail
