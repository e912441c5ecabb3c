#include <taut/geometry/detail/noding.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include <taut/geometry/box_index.h>
#include <taut/geometry/detail/axis_noding.h>
#include <taut/geometry/detail/box_pairs.h>
#include <taut/geometry/detail/quick_crossing.h>
#include <taut/geometry/exact/exact_point.h>
#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

constexpr int kRounds = 32;
constexpr std::size_t kFew = 16;  // points that need no index

Segment segment(const Edge& c) { return {c.a, c.b}; }

/// Turned so that a < b.
Edge ordered(Edge c) {
  if (c.b < c.a) {
    std::swap(c.a, c.b);
    c.turn = -c.turn;
  }
  return c;
}

/// Those with a length, ordered. Walls on one axis-parallel line that overlap or touch become one.
std::vector<Edge> merged_runs(std::vector<Edge> pieces) {
  std::erase_if(pieces, [](const Edge& c) { return c.a == c.b; });
  for (Edge& c : pieces) c = ordered(c);
  const auto is_straight_wall = [](const Edge& c) { return c.turn == 0 && is_axis_parallel(c); };
  const auto straight = std::partition(pieces.begin(), pieces.end(), is_straight_wall);
  const auto key = [](const Edge& c) {
    const bool vertical = c.a.x == c.b.x;
    return vertical ? std::tuple(true, c.a.x, c.a.y, c.wall) : std::tuple(false, c.a.y, c.a.x, c.wall);
  };
  std::sort(pieces.begin(), straight, [&](const auto& c, const auto& d) { return key(c) < key(d); });
  std::vector<Edge> merged;
  merged.reserve(pieces.size());
  for (auto c = pieces.begin(); c != straight; ++c) {
    const bool vertical = c->a.x == c->b.x;
    if (!merged.empty()) {
      Edge& run = merged.back();
      const bool same_line = vertical ? run.a.x == c->a.x && run.b.x == c->a.x : run.a.y == c->a.y && run.b.y == c->a.y;
      if (same_line && (vertical ? c->a.y <= run.b.y : c->a.x <= run.b.x)) {
        run.b = std::max(run.b, c->b);
        continue;
      }
    }
    merged.push_back(*c);
  }
  merged.insert(merged.end(), straight, pieces.end());
  return merged;
}

/// Equal pieces become one.
std::vector<Edge> unite_equal(std::vector<Edge> pieces) {
  std::sort(pieces.begin(), pieces.end(),
            [](const Edge& c, const Edge& d) { return std::tie(c.a, c.b, c.wall) < std::tie(d.a, d.b, d.wall); });
  std::vector<Edge> united;
  united.reserve(pieces.size());
  for (const Edge& c : pieces) {
    if (!united.empty() && united.back().a == c.a && united.back().b == c.b) {
      united.back().turn += c.turn;
    } else {
      united.push_back(c);
    }
  }
  return united;
}

/// One round of splitting.
class Splitting {
 public:
  Splitting(const std::vector<Edge>& pieces, const DecimalUnit& unit, std::span<const Point> fixed, Rounding rounding,
            Noded& log)
      : pieces_(pieces), unit_(unit), fixed_(fixed), rounding_(rounding), cuts_(), log_(log) {}

  /// Was a crossing no pair of doubles? Then the pieces have moved and may meet anew.
  bool rounded() const { return rounded_; }

  /// Finds all contacts; false when there is none.
  bool find() {
    std::vector<Box> boxes(pieces_.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = box_around(pieces_[i].a, pieces_[i].b);
    each_meeting_pair(boxes, [&](std::uint32_t i, std::uint32_t j) { meet(i, j); });
    if (rounded_ && !fixed_.empty()) hold_fixed(std::move(boxes));
    return !cuts_.empty();
  }

  std::vector<Edge> split() {
    std::sort(cuts_.begin(), cuts_.end(),
              [&](const Cut& c, const Cut& d) { return c.first != d.first ? c.first < d.first : along(c) < along(d); });
    cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
    std::vector<Edge> result;
    result.reserve(pieces_.size() + cuts_.size());
    auto cut = cuts_.begin();
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      Edge rest = pieces_[i];
      for (; cut != cuts_.end() && cut->first == i; ++cut) emit(result, rest, cut->second);
      emit(result, rest, pieces_[i].b);
    }
    return result;
  }

 private:
  using Cut = std::pair<std::uint32_t, Point>;  // which piece, where

  /// Does a rounded crossing stay on the piece? On axis-parallel ones whose line is a multiple of the unit.
  bool keeps_straight(const Edge& c) const {
    if (!is_axis_parallel(c)) return false;
    const double line = c.a.x == c.b.x ? c.a.x : c.a.y;
    return unit_.nearest(meaning(line)) == line;
  }

  /// Pieces that may bend keep the fixed points on them.
  void hold_fixed(std::vector<Box> boxes) {
    const auto hold = [&](std::uint32_t i, Point p) {
      if (!keeps_straight(pieces_[i])) touch(i, p, written::orientation(pieces_[i].a, pieces_[i].b, p));
    };
    if (fixed_.size() <= kFew) {
      for (std::uint32_t i = 0; i < boxes.size(); ++i)
        for (const Point p : fixed_)
          if (boxes[i].contains(p)) hold(i, p);
      return;
    }
    const BoxIndex index(std::move(boxes));
    for (const Point p : fixed_) index.meeting({p, p}, [&](std::uint32_t i) { hold(i, p); });
  }

  static void emit(std::vector<Edge>& result, Edge& rest, Point end) {
    Edge c = rest;
    c.b = end;
    if (c.a != c.b) result.push_back(ordered(c));
    rest.a = end;
  }

  /// A key that grows along the piece; rounding to nearest keeps its order.
  std::pair<double, double> along(const Cut& cut) const {
    const Edge& c = pieces_[cut.first];
    const double dx = c.b.x - c.a.x, dy = c.b.y - c.a.y;
    if (std::abs(dx) >= std::abs(dy)) return {cut.second.x, dy < 0 ? -cut.second.y : cut.second.y};
    return dy > 0 ? std::pair(cut.second.y, cut.second.x) : std::pair(-cut.second.y, cut.second.x);
  }

  void cut(std::uint32_t i, Point p) {
    if (p != pieces_[i].a && p != pieces_[i].b) cuts_.emplace_back(i, p);
  }

  void meet(std::uint32_t i, std::uint32_t j) {
    const Edge &s = pieces_[i], &t = pieces_[j];
    const int o1 = written::orientation(s.a, s.b, t.a), o2 = written::orientation(s.a, s.b, t.b);
    if (o1 * o2 > 0) return;
    const int o3 = written::orientation(t.a, t.b, s.a), o4 = written::orientation(t.a, t.b, s.b);
    if (o3 * o4 > 0) return;
    if (o1 * o2 < 0 && o3 * o4 < 0) return cross(i, j);
    touch(i, t.a, o1);
    touch(i, t.b, o2);
    touch(j, s.a, o3);
    touch(j, s.b, o4);
  }

  void touch(std::uint32_t i, Point p, int side) {
    if (side == 0 && written::on_segment(p, pieces_[i].a, pieces_[i].b)) cut(i, p);
  }

  void cross(std::uint32_t i, std::uint32_t j) {
    const Point p = crossing(pieces_[i], pieces_[j]);
    // A rounded crossing can coincide with an end of one piece; the other must be cut there all the same.
    cut(i, p);
    cut(j, p);
  }

  Point crossing(const Edge& s, const Edge& t) {
    ++log_.crossings;
    if (s.a.x == s.b.x && t.a.y == t.b.y) return {s.a.x, t.a.y};
    if (t.a.x == t.b.x && s.a.y == s.b.y) return {t.a.x, s.a.y};
    if (rounding_ == Rounding::nearest || (s.turn == 0 && t.turn == 0))
      if (const auto quick = quick_crossing(segment(s), segment(t), unit_))
        return rounded_to(quick->point, quick->displacement);
    const ExactPoint exact = line_crossing(segment(s), segment(t));
    if (const auto p = exactly(exact)) return *p;
    const Point p = round(exact, s, t);
    return rounded_to(p, displacement(exact, p));
  }

  Point rounded_to(Point p, double displacement) {
    rounded_ = true;
    log_.displacement = std::max(log_.displacement, displacement);
    return p;
  }

  Point round(const ExactPoint& exact, const Edge& s, const Edge& t) const {
    std::vector<Segment> outlines;
    for (const Edge& c : {s, t})
      if (c.turn != 0 && rounding_ == Rounding::outward)
        outlines.push_back(c.turn > 0 ? segment(c) : Segment{c.b, c.a});
    return outlines.empty() ? unit_.nearest(exact) : round_outward_or_nearest(exact, outlines, unit_);
  }

  const std::vector<Edge>& pieces_;
  const DecimalUnit& unit_;
  std::span<const Point> fixed_;
  Rounding rounding_;
  std::vector<Cut> cuts_;
  Noded& log_;
  bool rounded_ = false;
};

}  // namespace

Noded node(std::vector<Edge> edges, const DecimalUnit& unit, std::span<const Point> fixed, Rounding rounding) {
  if (std::all_of(edges.begin(), edges.end(), is_axis_parallel)) return node_axis_parallel(edges);
  return node_general(std::move(edges), unit, fixed, rounding);
}

Noded node_general(std::vector<Edge> edges, const DecimalUnit& unit, std::span<const Point> fixed, Rounding rounding) {
  Noded result;
  std::vector<Edge> pieces = unite_equal(merged_runs(std::move(edges)));
  for (int round = 0; round < kRounds; ++round) {
    Splitting splitting(pieces, unit, fixed, rounding, result);
    const bool contacts = splitting.find();
    if (contacts) pieces = unite_equal(splitting.split());
    if (!contacts || !splitting.rounded()) {
      result.edges = std::move(pieces);
      return result;
    }
  }
  throw TooFine("walls meet at angles too sharp for double coordinates");
}

}  // namespace taut::detail
