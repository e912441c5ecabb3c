// What a vertex sees to its right. Private.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <taut/roadmaps/detail/sight_steps.h>

namespace taut::detail {

/// Finds the rows of a visibility graph, full or reduced; VisibilityRows says which.
///
/// A view is a cone between two rays that shrinks at every vertex it meets and is never empty. In a full graph a vertex
/// on a bounding ray is seen past those before it on the side where the cone lies; where its obstacle lies on that side
/// only, the line itself goes on. In a reduced graph a vertex where paths bend hides what lies behind it.
template <class Sight, bool kReduced>
class SightRow {
 public:
  using Step = SightStep<typename Sight::Place>;
  using Place = typename Sight::Place;
  using Ray = typename Sight::Ray;

  SightRow(const Triangulation& tri, const Sight& sight, const std::vector<Step>& steps,
           const std::vector<std::uint32_t>& sectors)
      : tri_(tri), steps_(steps), sectors_(sectors), sight_(sight), listed_for_(sectors.size(), kNone) {}

  /// What the vertex sees to its right.
  const std::vector<std::uint32_t>& find(std::uint32_t vertex) {
    row_.clear();
    self_ = listed_for_[vertex] = vertex;
    const Triangulation::Sector& sector = tri_.sectors[sectors_[vertex]];
    sight_.stand_at(sector.vertex);
    if constexpr (kReduced) {
      right_end_ = sight_.at(sector.right), left_end_ = sight_.at(sector.left);
      is_all_tangent_ = sector.right == sector.left;
    }
    each_step_around(sector.triangle, tri_.corner(sector.triangle, sector.vertex), [&](std::uint32_t t, int i) {
      wedge(t, i);
      return true;
    });
    return row_;
  }

  /// What a point that is no vertex sees all around: `places` are the triangles that it lies in or on a side of, which
  /// is the second number (else 3). Not to be mixed with the other.
  const std::vector<std::uint32_t>& find(Place origin, std::span<const std::pair<std::uint32_t, int>> places) {
    row_.clear();
    if (++self_ == kNone) {
      std::fill(listed_for_.begin(), listed_for_.end(), kNone);
      self_ = 0;
    }
    sight_.stand_at(origin);
    for (const auto& [t, own_side] : places) {
      for (int i = 0; i < 3; ++i) {
        list(steps_[of(t, i)]);
        if (i == own_side) continue;
        const Step &a = steps_[of(t, Triangulation::ccw(i))], &b = steps_[of(t, Triangulation::cw(i))];
        spread({out_of(t, i), {sight_.through(a.apex), hides(a)}, {sight_.through(b.apex), hides(b)}});
      }
    }
    return row_;
  }

 private:
  struct Bound {
    Ray ray;
    bool hides = false;
  };
  struct View {
    std::uint32_t step;
    Bound right, left;
  };

  static std::uint32_t of(std::uint32_t t, int corner) { return 3 * t + static_cast<std::uint32_t>(corner); }

  /// The step out of triangle t by its side i.
  std::uint32_t out_of(std::uint32_t t, int i) const { return steps_[of(t, Triangulation::ccw(i))].left; }

  int side(const Ray& ray, Place p) const { return sight_.side(ray, p); }
  /// +1 when b lies to the left of the ray through a.
  int turn(Place a, Place b) const { return side(sight_.through(a), b); }

  /// The triangles around corner i of t, counter-clockwise up to the end of the sector, as long as `visit(t, i)`.
  template <class Visit>
  void each_step_around(std::uint32_t t, int i, Visit visit) const {
    const std::uint32_t first = t;
    do {
      if (!visit(t, i)) return;
      const std::uint32_t beyond = out_of(t, Triangulation::ccw(i));
      if (beyond == kNone) return;
      t = beyond / 3;
      i = Triangulation::ccw(static_cast<int>(beyond % 3));
    } while (t != first);
  }

  /// What is seen out of one triangle at the origin.
  void wedge(std::uint32_t t, int i) {
    const Step &a = steps_[of(t, Triangulation::ccw(i))], &b = steps_[of(t, Triangulation::cw(i))];
    const std::uint32_t out = out_of(t, i);
    const Bound right{sight_.through(a.apex), hides(a)}, left{sight_.through(b.apex), hides(b)};
    if constexpr (kReduced) {
      if (!is_all_tangent_) return tangent_wedge(a, b, out, right, left);
    }
    list_corner(a);
    list_corner(b);
    spread_rightward(out, right, left);
  }

  /// Of a reflex sector only the tangent directions: a path that bends there does not start strictly between the
  /// backward continuations of its left and its right side.
  void tangent_wedge(const Step& a, const Step& b, std::uint32_t out, const Bound& right, const Bound& left) {
    const bool a_bends = bends_around(a.apex), b_bends = bends_around(b.apex);
    if (a_bends) list_corner(a);
    if (b_bends) list_corner(b);
    if (!a_bends && !b_bends) return;
    const int a_first = turn(a.apex, left_end_), b_second = turn(right_end_, b.apex);
    const bool between = a_first <= 0 && turn(left_end_, b.apex) < 0;
    if (a_bends && b_bends && !between) return spread_rightward(out, right, left);
    if (a_bends && a_first != 0) spread_rightward(out, right, {sight_.away_from(left_end_)});
    if (b_bends && b_second != 0) spread_rightward(out, {sight_.away_from(right_end_)}, left);
  }

  /// Does a path along this direction have its obstacle on one side of the line only?
  bool bends_around(Place p) const { return turn(left_end_, p) >= 0 || turn(right_end_, p) <= 0; }

  void list_corner(const Step& corner) {
    if (sight_.is_rightward(sight_.through(corner.apex))) list(corner);
  }

  /// Cuts the cone, narrower than half a turn, at the bounds of what lies to the right.
  void spread_rightward(std::uint32_t step, const Bound& right, const Bound& left) {
    const bool right_in = sight_.is_rightward(right.ray), left_in = sight_.is_rightward(left.ray);
    if (!right_in && !left_in) return;
    spread({step, right_in ? right : Bound{sight_.down()}, left_in ? left : Bound{sight_.up()}});
  }

  void spread(View view) {
    for (;;) {
      while (view.step != kNone) {
        const Step& step = steps_[view.step];
        const int r = side(view.right.ray, step.apex);
        if (r < 0) {
          view.step = step.left;
          continue;
        }
        const int l = side(view.left.ray, step.apex);
        if (l > 0) {
          view.step = step.right;
          continue;
        }
        meet(view, r, l);
      }
      if (open_.empty()) return;
      view = open_.back();
      open_.pop_back();
    }
  }

  /// The view meets a vertex, which lies within it or on a bounding ray: goes on to the right of it, or else to the
  /// left.
  void meet(View& view, int r, int l) {
    const Step& step = steps_[view.step];
    const bool hidden = kReduced && ((r == 0 && view.right.hides) || (l == 0 && view.left.hides));
    const Bound middle{sight_.through(step.apex), hides(step)};
    if (!hidden && list(step) && !kReduced && r * l == 0) follow_past(view.step, middle.ray, r == 0 ? 1 : -1);
    if (r == 0) {
      if (!hidden) view.right = middle;
      view.step = step.left;
      return;
    }
    if (l < 0 && step.left != kNone) open_.push_back({step.left, middle, view.left});
    if (l < 0 || !hidden) view.left = middle;
    view.step = step.right;
  }

  bool hides(const Step& step) const { return kReduced && step.vertex != kNone; }

  /// Adds the vertex, unless it is there; says whether it was added.
  bool list(const Step& step) {
    if (step.vertex == kNone || listed_for_[step.vertex] == self_) return false;
    if (kReduced && !is_tangent_at(step)) return false;
    listed_for_[step.vertex] = self_;
    row_.push_back(step.vertex);
    return true;
  }

  /// Does the line from the origin have the obstacle at the vertex on one side?
  bool is_tangent_at(const Step& step) const {
    const Triangulation::Sector& sector = tri_.sectors[sectors_[step.vertex]];
    const Ray ray = sight_.through(step.apex);
    return side(ray, sight_.at(sector.right)) * side(ray, sight_.at(sector.left)) >= 0;
  }

  /// The vertices behind one on the bound of a cone (`open` +1: the cone lies to the left of the ray), when a path can
  /// go straight on there on the other side only.
  void follow_past(std::uint32_t step, const Ray& ray, int open) {
    const Triangulation::Sector& sector = tri_.sectors[tri_.sector_of[step]];
    if (!sector.reflex) return;
    const int right = side(ray, sight_.at(sector.right)), left = side(ray, sight_.at(sector.left));
    if (right * open < 0 || left * open < 0) return;
    lines_.push_back(tri_.sector_of[step]);
    while (!lines_.empty()) {
      const std::uint32_t from = lines_.back();
      lines_.pop_back();
      follow(tri_.sectors[from], ray);
    }
  }

  /// The next vertices on the ray from one on it, by all ways that the sector has there.
  void follow(const Triangulation::Sector& sector, const Ray& ray) {
    const Place from = sight_.at(sector.vertex);
    each_step_around(sector.triangle, tri_.corner(sector.triangle, sector.vertex), [&](std::uint32_t t, int i) {
      const int a = Triangulation::ccw(i), b = Triangulation::cw(i);
      const int r = side(ray, steps_[of(t, a)].apex), l = side(ray, steps_[of(t, b)].apex);
      if (r < 0 && l > 0) return go_through(out_of(t, i), ray), false;
      if (r == 0 && sight_.is_ahead(ray, from, steps_[of(t, a)].apex)) arrive(of(t, a));
      if (l == 0 && sight_.is_ahead(ray, from, steps_[of(t, b)].apex)) arrive(of(t, b));
      return true;
    });
  }

  void go_through(std::uint32_t step, const Ray& ray) {
    while (step != kNone) {
      const int turn = side(ray, steps_[step].apex);
      if (turn == 0) return arrive(step);
      step = turn > 0 ? steps_[step].right : steps_[step].left;
    }
  }

  /// Also at a vertex that no constraint meets, where the ray goes on unseen.
  void arrive(std::uint32_t step) {
    if (steps_[step].vertex == kNone || list(steps_[step])) lines_.push_back(tri_.sector_of[step]);
  }

  const Triangulation& tri_;
  const std::vector<Step>& steps_;
  const std::vector<std::uint32_t>& sectors_;
  Sight sight_;
  std::uint32_t self_ = kNone;
  Place right_end_{}, left_end_{};
  bool is_all_tangent_ = true;
  std::vector<std::uint32_t> row_;
  std::vector<std::uint32_t> listed_for_;  // by vertex: in whose row it was listed last
  std::vector<View> open_;
  std::vector<std::uint32_t> lines_;
};

}  // namespace taut::detail
