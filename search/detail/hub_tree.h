// Dijkstra's algorithm along taut turns, from one vertex after the other in the same memory.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <taut/search/detail/hub_graph.h>
#include <taut/search/detail/sight_lists.h>

namespace taut::detail {

/// The shortest ways from a root along turns that a taut string makes. Their lengths are compared as twofold sums,
/// where those do not tell by prints, and by roots where prints differ: of equal ones the first found stays.
///
/// Not all are shortest paths: where the true one to a vertex, or out of the root, is not tangent there, the taut way
/// is longer. No shortest path goes on behind such a vertex or came to such a root, so nobody needs them. Half legs
/// recognise them: what is_needed() denies may be left out; what it does not deny may be needless.
class HubTree {
 public:
  /// All outlive it; `sights` may be absent. `bend_places`: three of their places a vertex, its own and the far ends of
  /// its sector's right and left side.
  HubTree(const HubGraph& graph, const SightLists* sights, std::span<const std::uint32_t> bend_places);

  /// Calls settle(v, length) for the vertices by length, again for one that turns out to be nearer; it tells whether to
  /// go on behind v.
  template <class Settle>
  void grow(std::uint32_t root, Settle&& settle) {
    begin(root);
    while (!open_.empty()) {
      const Open next = open_.front();
      std::pop_heap(open_.begin(), open_.end(), kLater);
      open_.pop_back();
      if (next.length != high_[next.vertex] || is_settled(next.vertex)) continue;
      set_settled(next.vertex);
      if (is_cut_short(next.vertex)) continue;
      shorten_halves(next.vertex);
      if (settle(next.vertex, ways_[next.vertex].length)) follow(next.vertex);
    }
  }

  /// The vertex before v on its way; of the root the root itself.
  std::uint32_t before(std::uint32_t v) const { return ways_[v].before; }
  /// The edge that leads to v on its way, kNone at the root and behind a half leg.
  std::uint32_t via(std::uint32_t v) const { return ways_[v].via; }
  bool is_needed(std::uint32_t v) const { return !ways_[v].is_half; }
  /// Appends the legs of the way to v.
  void legs(std::uint32_t v, std::vector<Segment>& out) const;

 private:
  struct Way {
    PrintedLength length;
    std::uint32_t before = kNone, via = kNone;
    bool is_half = false;  // began with a half leg
    bool is_settled = false;
  };
  struct Open {
    double length;
    std::uint32_t vertex;
  };
  /// Which turns are taut where the way arrives at a vertex.
  struct Turns {
    IntegerPlaces::Place from, here;
    bool right = false, left = false;

    int side(IntegerPlaces::Place p) const { return IntegerPlaces::side(from, here, p); }
  };
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  static constexpr auto kLater = [](const Open& a, const Open& b) { return a.length > b.length; };
  static constexpr double kMargin = 1e-12;  // of double lengths that need not be compared exactly

  bool is_settled(std::uint32_t v) const { return ways_[v].is_settled; }
  void set_settled(std::uint32_t v) { ways_[v].is_settled = true; }
  bool is_cut_short(std::uint32_t v) const { return half_[v] < high_[v] * (1 - kMargin); }

  IntegerPlaces::Place place(std::uint32_t v) const { return sights_->places[places_[3 * v]]; }
  Turns turns(std::uint32_t v) const;
  void begin(std::uint32_t root);
  void follow(std::uint32_t v);
  void follow(std::uint32_t v, std::uint32_t first, std::uint32_t last);
  void follow_half(std::uint32_t v, std::uint32_t first, std::uint32_t last);
  void reach(std::uint32_t v, const Way& way);
  bool is_shorter_exactly(const Way& way, std::uint32_t v);
  void shorten_halves(std::uint32_t v);
  void shorten_half(std::uint32_t to, double length);

  const HubGraph& graph_;
  const SightLists* sights_;
  std::span<const std::uint32_t> places_;  // three a vertex: its own, its sector's right and left side's
  std::uint32_t root_ = 0;
  std::vector<double> high_, half_;  // by vertex: of the way; of a shorter one that is not tangent
  std::vector<Way> ways_;
  std::vector<std::uint32_t> reached_, halved_;
  std::vector<Open> open_;
  std::vector<Segment> legs_a_, legs_b_;
};

}  // namespace taut::detail
