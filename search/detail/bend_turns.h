// How strings turn at bends, exactly: in integers where the world has them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/integer_places.h>
#include <taut/geometry/written.h>
#include <taut/roadmaps/visibility_graph.h>

namespace taut::detail {

/// On which sides of a string that arrives at a bend the obstacle lies: bits. It may turn to those sides.
enum TurnBits : std::uint32_t { kMayTurnRight = 1, kMayTurnLeft = 2 };

/// A place that a string comes from or goes to: as it is written, and as integers where there are any.
struct TurnPlace {
  Point point;
  IntegerPlaces::Place at{};
};

class BendTurns {
 public:
  /// `places` may be absent; else all points of the triangulation are on them.
  BendTurns(const VisibilityGraph& graph, const IntegerPlaces* places) : is_integer_(places != nullptr) {
    const Triangulation& tri = graph.space().triangulation();
    const auto place = [&](std::uint32_t vertex) {
      TurnPlace made{tri.points[vertex], {}};
      if (places) places->find(made.point, made.at);
      return made;
    };
    for (std::uint32_t v = 0; v < graph.roadmap().vertex_count(); ++v) {
      const Triangulation::Sector& sector = tri.sectors[graph.sector(v)];
      bends_.push_back({place(sector.vertex), place(sector.right), place(sector.left)});
    }
  }

  const TurnPlace& at(std::uint32_t bend) const { return bends_[bend].at; }

  /// +1 when c lies to the left of a -> b. `exact_in_integers`: all three have integers.
  int side(const TurnPlace& a, const TurnPlace& b, const TurnPlace& c, bool in_integers = true) const {
    return is_integer_ && in_integers ? IntegerPlaces::side(a.at, b.at, c.at)
                                      : written::orientation(a.point, b.point, c.point);
  }

  /// TurnBits of a string from `from`.
  std::uint32_t arriving(const TurnPlace& from, std::uint32_t bend, bool in_integers = true) const {
    const Bend& b = bends_[bend];
    const int right = side(from, b.at, b.right, in_integers), left = side(from, b.at, b.left, in_integers);
    return (right <= 0 && left <= 0 ? kMayTurnRight : 0u) | (right >= 0 && left >= 0 ? kMayTurnLeft : 0u);
  }

  /// May a string from `from`, which arrives so, go on to bend `to`, from where it would arrive as `back` says?
  bool is_taut(const TurnPlace& from, std::uint32_t arriving, std::uint32_t bend, std::uint32_t to, std::uint32_t back,
               bool in_integers = true) const {
    const int turn = side(from, bends_[bend].at, bends_[to].at, in_integers);
    return ((arriving & kMayTurnLeft) && (back & kMayTurnRight) && turn >= 0) ||
           ((arriving & kMayTurnRight) && (back & kMayTurnLeft) && turn <= 0);
  }

  /// Sorts what goes out of a bend, `hop(x)` being the bend it goes to first, counter-clockwise from the obstacle's one
  /// side to its other; around the free end of a wall what runs along the wall is first and, again, last.
  template <class Out, class Hop>
  void sort_around(std::uint32_t bend, std::vector<Out>& out, Hop hop) const {
    const Bend& b = bends_[bend];
    const auto turn = [&](const TurnPlace& p, const TurnPlace& q) { return side(b.at, p, q); };
    const auto is_beyond = [&](const TurnPlace& p) {
      const int s = turn(b.right, p);
      return s < 0 || (s == 0 && written::on_segment(b.at.point, b.right.point, p.point));
    };
    std::stable_sort(out.begin(), out.end(), [&](const Out& x, const Out& y) {
      const TurnPlace &p = at(hop(x)), &q = at(hop(y));
      const bool p_beyond = is_beyond(p), q_beyond = is_beyond(q);
      return p_beyond != q_beyond ? q_beyond : turn(p, q) > 0;
    });
    if (b.right.point != b.left.point) return;
    for (std::size_t i = 0, size = out.size(); i < size; ++i)
      if (!is_beyond(at(hop(out[i]))) && turn(b.right, at(hop(out[i]))) == 0) out.push_back(Out(out[i]));
  }

 private:
  struct Bend {
    TurnPlace at, right, left;
  };

  bool is_integer_;
  std::vector<Bend> bends_;
};

}  // namespace taut::detail
