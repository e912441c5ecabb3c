#include <taut/search/kept_path.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include <taut/roadmaps/disc_places.h>
#include <taut/search/arc_search.h>
#include <taut/search/disc_reach.h>
#include <taut/search/verify_arcs.h>

namespace taut {

namespace {

/// How an end is left: to `place`, where the disc can be.
struct Leaving {
  std::vector<ArcPath> parts;
  PassagePlace place;
  double length = 0;
  double rounding = 0;
};

using Leavings = std::vector<Leaving>;

bool keeps(const PassageIndex& index, const ArcPath& leg) {
  if (leg.radius > 0) return verify_arcs(leg, index.gates(), leg.start, leg.goal).valid;
  return leg.bends.empty() && index.gates().space().sees(leg.start, leg.goal);
}

ArcPath straight(double radius, Point from, Point to) {
  ArcPath leg{radius, from, to, {}, {}};
  leg.length = length_of(pieces(leg));
  return leg;
}

ArcPath backwards(const ArcPath& path) {
  ArcPath back{path.radius, path.goal, path.start, {}, path.length};
  for (auto bend = path.bends.rbegin(); bend != path.bends.rend(); ++bend)
    back.bends.push_back({bend->corner, -bend->turn});
  return back;
}

class Keeper {
 public:
  Keeper(const PassageIndex& index, double c) : index_(index), c_(c) {}

  KeptPath find(Point start, Point goal) {
    KeptPath found;
    found.clearance = c_;
    const PassagePlace s = index_.place(start), g = index_.place(goal);
    if (s.outside || g.outside) {
      found.status = s.outside ? KeptPath::Status::start_blocked : KeptPath::Status::goal_blocked;
      return found;
    }
    if (auto both = pair_of(s, g)) fill(found, both->first, both->second);
    return found;
  }

 private:
  using Pair = std::pair<Leaving, Leaving>;

  const DiscPlaces& places(double r) {
    const auto at = places_.try_emplace(r, index_.gates().space(), r);
    return at.first->second;
  }
  const TangentGraph& graph(double r) {
    const auto at = graphs_.try_emplace(r, index_.gates().space(), r);
    return at.first->second;
  }

  /// Rule 2, the shortest first. Of an end that is a place: itself.
  Leavings straight_from(const PassagePlace& end, double r) {
    const double own = index_.radius_at(end);
    if (own >= r) return {{{}, end, 0, 0}};
    Leavings found;
    const auto add = [&](Point near) {
      const auto place = places(r).nearest(near);
      if (!place || std::ranges::any_of(found, [&](const Leaving& l) { return l.place.point == place->point; })) return;
      const ArcPath leg = straight(own, end.point, place->point);
      if (keeps(index_, leg)) found.push_back({{leg}, index_.place(place->point), leg.length.hi, place->rounding});
    };
    add(end.point);
    for (int k = 0; k < 8; ++k)
      add({end.point.x + r * std::cos(k * M_PI / 4), end.point.y + r * std::sin(k * M_PI / 4)});
    std::ranges::stable_sort(found, {}, &Leaving::length);
    return found;
  }

  std::optional<Pair> pair_of(const PassagePlace& s, const PassagePlace& g) {
    const Leavings from = straight_from(s, c_), to = straight_from(g, c_);
    std::optional<Pair> best;
    const auto offer = [&](const Leaving& a, const Leaving& b) {
      if (!best || a.length + b.length < best->first.length + best->second.length) best = Pair{a, b};
    };
    for (const Leaving& a : from)
      for (const Leaving& b : to)
        if (passes(a.place, b.place, c_)) offer(a, b);
    if (best) return best;
    const bool s_may = index_.radius_at(s) < c_, g_may = index_.radius_at(g) < c_;
    for (const Leaving& b : to)
      if (const auto a = s_may ? from_pocket(s, b.place) : std::nullopt) offer(*a, b);
    for (const Leaving& a : from)
      if (const auto b = g_may ? from_pocket(g, a.place) : std::nullopt) offer(a, *b);
    return best || !s_may || !g_may ? best : both_from_pockets(s, g);
  }

  bool passes(const PassagePlace& a, const PassagePlace& b, double r) const {
    return index_.passes(a, b, r) == DiscStatus::found;
  }

  /// The radius of the largest disc that gets from the end to the place, were it not for walls near the end.
  double room(const PassagePlace& end, const PassagePlace& place) const {
    if (end.component != place.component && !end.on_wall) return 0;
    const std::uint32_t gate = index_.bottleneck(end, place);
    return gate == kNone ? c_ : std::min(c_, index_.gate_radius(gate));
  }

  /// Rule 3: to the part of the disc's places that `target` is in.
  std::optional<Leaving> from_pocket(const PassagePlace& end, const PassagePlace& target) {
    Leavings doors;  // `length`: the room to it
    for (const std::uint32_t i : closed_gates(index_, target, c_)) {
      const Gate& gate = index_.gates().gates()[i];
      const auto near =
          places(c_).nearest({std::midpoint(gate.end.x, gate.foot.x), std::midpoint(gate.end.y, gate.foot.y)});
      if (!near) continue;
      Leaving door{{}, index_.place(near->point), 0, near->rounding};
      door.length = room(end, door.place);
      if (door.length > 0 && passes(door.place, target, c_)) doors.push_back(std::move(door));
    }
    if (doors.empty()) return std::nullopt;
    const double rho = std::ranges::max_element(doors, {}, &Leaving::length)->length;
    if (rho >= c_) return std::nullopt;
    std::erase_if(doors, [&](const Leaving& door) { return door.length < rho; });
    return through(end, doors, rho);
  }

  std::optional<Leaving> through(const PassagePlace& end, const Leavings& doors, double rho) {
    std::optional<Leaving> best;
    for (const Leaving& out : straight_from(end, rho)) {
      for (const Leaving& door : doors) {
        if (!passes(out.place, door.place, rho)) continue;
        const ArcSearchResult way = arc_search(graph(rho), out.place.point, door.place.point);
        if (way.status != DiscStatus::found) continue;
        const double length = out.length + way.path.length.hi;
        if (best && best->length <= length) continue;
        best = Leaving{out.parts, door.place, length, std::max(out.rounding, door.rounding)};
        best->parts.push_back(way.path);
      }
      if (best) return best;
    }
    return best;
  }

  /// Both ends in pockets: the part of the places that the larger disc gets to.
  std::optional<Pair> both_from_pockets(const PassagePlace& s, const PassagePlace& g) {
    std::vector<PassagePlace> parts;
    std::optional<Pair> best;
    double best_rho = 0;
    for (auto i = static_cast<std::uint32_t>(index_.gates().gates().size()); i-- > 0;) {
      if (index_.gate_radius(i) >= c_ || index_.gate_radius(i) < best_rho) continue;
      const Gate& gate = index_.gates().gates()[i];
      const auto near =
          places(c_).nearest({std::midpoint(gate.end.x, gate.foot.x), std::midpoint(gate.end.y, gate.foot.y)});
      if (!near) return std::nullopt;
      const PassagePlace at = index_.place(near->point);
      if (std::ranges::any_of(parts, [&](const PassagePlace& p) { return passes(p, at, c_); })) continue;
      parts.push_back(at);
      auto a = from_pocket(s, at);
      auto b = a ? from_pocket(g, at) : std::nullopt;
      if (!b) continue;
      const double rho = std::min(a->parts.back().radius, b->parts.back().radius);
      if (best && rho <= best_rho) continue;
      best_rho = rho;
      best = Pair{std::move(*a), std::move(*b)};
    }
    return best;
  }

  void fill(KeptPath& found, Leaving& from, Leaving& to) {
    const Point start = from.parts.empty() ? from.place.point : from.parts.front().start,
                goal = to.parts.empty() ? to.place.point : to.parts.front().start;
    if (is_direct(start, goal, from.length + to.length, found)) return;
    ArcSearchResult middle = arc_search(graph(c_), from.place.point, to.place.point);
    if (middle.status != DiscStatus::found) return;
    found.parts = std::move(from.parts);
    found.first = found.parts.size();
    found.parts.push_back(std::move(middle.path));
    found.last = found.parts.size();
    for (auto part = to.parts.rbegin(); part != to.parts.rend(); ++part) found.parts.push_back(backwards(*part));
    found.rounding = std::max(from.rounding, to.rounding);
    finish(found);
  }

  bool is_direct(Point start, Point goal, double around, KeptPath& found) const {
    if (around == 0 || std::hypot(goal.x - start.x, goal.y - start.y) >= around) return false;
    const double own = std::min(index_.radius_at(index_.place(start)), index_.radius_at(index_.place(goal)));
    const ArcPath leg = straight(own, start, goal);
    if (!keeps(index_, leg)) return false;
    found.parts = {leg};
    found.first = own < c_ ? 1 : 0;
    found.last = 1;
    finish(found);
    return true;
  }

  static void finish(KeptPath& found) {
    found.status = KeptPath::Status::found;
    found.length = Interval(0);
    for (const ArcPath& part : found.parts) found.length = found.length + part.length;
    found.length.lo = std::max(0.0, found.length.lo);
  }

  const PassageIndex& index_;
  double c_;
  std::map<double, DiscPlaces> places_;
  std::map<double, TangentGraph> graphs_;
};

}  // namespace

KeptPath kept_path(const PassageIndex& index, Point start, Point goal, double c) {
  return Keeper(index, c).find(start, goal);
}

std::string kept_path_fault(const KeptPath& path, const PassageIndex& index, Point start, Point goal) {
  if (path.parts.empty()) return "it has no part";
  if (path.parts.front().start != start || path.parts.back().goal != goal) return "it does not lead from start to goal";
  double rest = 0;
  for (std::size_t i = 0; i < path.parts.size(); ++i) {
    const ArcPath& part = path.parts[i];
    if (i > 0 && part.start != path.parts[i - 1].goal) return fmt::format("part {} begins elsewhere", i);
    if (part.radius > 0) {
      const ArcVerdict verdict = verify_arcs(part, index.gates(), part.start, part.goal);
      if (!verdict.valid) return fmt::format("part {}: {}", i, verdict.reason);
    } else if (!keeps(index, part)) {
      return fmt::format("part {} meets a wall", i);
    }
    const bool middle = i >= path.first && i < path.last;
    if (middle && part.radius != path.clearance) return fmt::format("part {} keeps another clearance", i);
    if (!middle && part.radius >= path.clearance) return fmt::format("part {} could keep the clearance", i);
    rest += part.length.middle();
  }
  const auto radius = [&](std::size_t i) { return path.parts[i].radius; };
  for (std::size_t i = 1; i < path.parts.size(); ++i)
    if (i <= path.first ? radius(i) < radius(i - 1) : radius(i) > radius(i - 1))
      return fmt::format("part {} is narrower than the part nearer to the end", i);
  const bool direct = path.first == path.last;
  const auto room = [&](Point end, Point place) {
    const auto widest = index.widest(end, direct ? end : place);
    return std::min(path.clearance, widest ? widest->radius : 0);
  };
  const double from = room(start, direct ? start : path.parts[path.first].start),
               to = room(goal, direct ? goal : path.parts[path.last - 1].goal);
  if (radius(0) < (direct ? std::min(from, to) : from)) return "it comes nearer to walls than it has to at the start";
  if (radius(path.parts.size() - 1) < (direct ? std::min(from, to) : to))
    return "it comes nearer to walls than it has to at the goal";
  if (std::abs(rest - path.length.middle()) > 1e-9 * (rest + 1)) return "its length is another";
  return {};
}

}  // namespace taut
