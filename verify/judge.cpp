#include <taut/verify/judge.h>

#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace taut::proof {

namespace {

/// `(0.5, 1)`, in the world's own unit.
std::string text(const World& w, Place p) { return fmt::format("({:.12g}, {:.12g})", w.unit * p.x, w.unit * p.y); }

constexpr Int kMost = Int{1} << 61, kFar = 2 * kMost;  // of potentials; what is unreached has kFar

Wide root(Wide square) {  // rounded down
  Wide root = static_cast<Wide>(std::sqrt(static_cast<Real>(square)));
  while (root * root > square) --root;
  while ((root + 1) * (root + 1) <= square) ++root;
  return root;
}

// The sides, 1 left and 2 right, around which a path from u gets no further into the room, at whose border v is: what
// stands at v, and does not point into the room, is in the way. Along the border the path comes outside, for inside it
// would have been in the room before.
int barred(const World& world, const Box& room, Place u, Place v) {
  const Place back = u - v, in = (room.min - v) - (v - room.max), near = least(most(u, room.min), room.max);
  const auto is_between = [](Place p, Place d, Place q) {  // on the turn to the left from p to q
    const bool from = cross(p, d) > 0, to = cross(d, q) > 0;
    return cross(p, q) > 0 ? from && to : from || to;
  };
  const bool is_along = near != v && cross(near - v, back) == 0;
  bool left = is_along && cross(back, in) < 0, right = is_along && cross(back, in) > 0;
  for (const Edge& e : world.leaving(v)) {
    const Place d = e.b - v;
    const bool x = (v.x > room.min.x || d.x > 0) && (v.x < room.max.x || d.x < 0);
    const bool y = (v.y > room.min.y || d.y > 0) && (v.y < room.max.y || d.y < 0);
    left |= !(x && y) && is_between(in, d, back), right |= !(x && y) && is_between(back, d, in);
  }
  return room.min == room.max ? 0 : left + 2 * right;
}

// Where a shortest path can end: the room's corners, feet of perpendiculars from its last bend, and where edges meet
// the border. Feet of all ends of edges, as those that lie on the border are their own.
std::vector<Corner> ends(const World& world, const Box& room, Place start, Int number) {
  std::vector<Corner> found;
  const auto add = [&](Place p, Place q) {  // or what lies between them
    if (room.holds(p) && room.holds(q))     // nothing leads away from there
      found.push_back({p == q ? p : throw BadInput("an edge meets the room between units"), {}, {}, kFar, number});
  };
  std::vector<Edge> all = world.edges.items;
  all.insert(all.end(), {{start, start}, {room.min, room.max}});
  for (const Edge& e : all)
    for (const bool is_turned : {false, true})
      for (const Place corner : {room.min, room.max}) {
        const auto turned = [&](Place p) { return is_turned ? Place{p.y, p.x} : p; };
        const Place a = turned(e.a), b = turned(e.b), s = turned(corner);
        const auto at = [&](Place p, Place q) {  // the line x = s.x, rounded towards p
          return turned({s.x, p.y + static_cast<Int>(Wide{q.y - p.y} * (s.x - p.x) / (q.x - p.x))});
        };
        for (const Place p : {a, b}) add(turned({s.x, p.y}), turned({s.x, p.y}));
        if (sign(s.x - a.x) * sign(b.x - s.x) > 0) add(at(a, b), at(b, a));
      }
  return found;
}

// A leg from a listed node that a shortest path could have, while the potentials of its ends differ by more than it is
// long.
std::string refutation(const World& world, const Box& room, const Tree<Corner>& nodes, int bits) {
  for (const Corner& from : nodes.items) {
    const Place u = from.at;
    std::vector<Edge> blockers;  // u lies to their left
    // Potentials in the box differ by less than it is away; or no leg into it is tangent at the node; or it lies wholly
    // behind edges that were in the way of other legs.
    const auto is_settled = [&](const Box& box) {
      const Int differ = std::max(from.high - box.low, box.high - from.low);
      const Place d = box.away(u), l = from.left, r = from.right, o{};
      if (differ <= 0 || Wide{differ} * differ <= dot(d, d) << (2 * bits)) return true;
      if ((box.is_left(u, r) && box.is_left(u, o - l)) || (box.is_left(u, l) && box.is_left(u, o - r))) return true;
      return is_hidden(box, u, blockers);
    };
    const auto is_open = [&](const Corner& to) {
      const Place d = to.at - u;
      if (d == Place{} || !from.is_tangent(d) || !to.is_tangent(d)) return false;
      const Edge* const e = world.leg(from, to, 0, to.is_end() ? barred(world, room, u, to.at) : 0);
      if (e && e != &world.closed) blockers.push_back(side(e->a, e->b, u) > 0 ? *e : Edge{e->b, e->a});
      return !e;
    };
    if (const Corner* const to = from.is_listed ? nodes.find(u, is_settled, is_open) : nullptr)
      return "nothing stops the leg " + text(world, u) + "-" + text(world, to->at) + ", shorter than potentials say";
  }
  return {};
}

// Of discs. A path keeps r from an edge if its legs' ends do, and the edge's ends from the legs, and none crosses it.
bool is_near(Place p, const Edge& e, Int r) {
  const Place d = e.b - e.a, v = p - e.a, w = p - e.b;
  if (dot(d, v) <= 0 || dot(d, w) >= 0) return std::min(dot(v, v), dot(w, w)) < Wide{r} * r;
  Wide square = dot(d, d), away = cross(d, v) * sign(cross(d, v));
  while (square >> 122 == 0) square *= 4, away *= 2;  // as many digits as there is room for
  return away < r * (root(square) + 1);
}

// Why the path cannot be followed, or comes nearer to edges than it says. It bends around corners, and where nothing
// stands.
std::string fault(const std::vector<Place>& path, const World& world, const Box& room, Int keeps) {
  const std::size_t last = path.size() - 1;
  int turn = 0;  // at u, to the left 1
  for (std::size_t i = 0; i == 0 || i < last; ++i) {
    const bool ends = i + 1 >= last;
    // Ends have no directions.
    const Corner u{path[i], Place{i > 0, 0}}, v{path[std::min(i + 1, last)], Place{!ends, 0}};
    const int next = ends ? barred(world, room, u.at, v.at) : (3 + side(u.at, v.at, path[i + 2])) % 3;
    const std::string words = " from " + text(world, u.at) + " to " + text(world, v.at);
    if (!ends && !(next != 0 && world.corners.contains(v.at)) && world.joins(v.at, v.at))
      return "the path bends at " + text(world, v.at) + ", on a wall";
    if (last > 0 && (u.at == v.at || world.leg(u, v, turn, next))) return "the path does not get" + words;
    const auto meets = [&](const Edge& e, const Edge& f) { return is_near(e.a, f, keeps) || is_near(e.b, f, keeps); };
    for (const Edge& e : world.edges.items)
      if (const Edge leg{u.at, v.at}; keeps > 0 && (meets(leg, e) || meets(e, leg)))
        return "the path comes too near to a wall" + words;
    turn = next;
  }
  return room.holds(path[last]) ? "" : "the path ends at " + text(world, path[last]) + ", not in the goal";
}

// Why no closed chain of pieces and gates, links between pieces with squares up to `wide`, is between both ends.
std::string passage(const std::vector<Place>& chain, const World& world, Place start, Place goal, Wide wide) {
  bool between = false;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Place p = chain[i], q = chain[(i + 1) % chain.size()];
    const bool gate = dot(q - p, q - p) <= wide && world.joins(p, p) && world.joins(q, q);
    if (!gate && !world.joins(p, q)) return "the chain is open from " + text(world, p) + " to " + text(world, q);
    for (const Place end : {start, goal}) {
      if (Edge{p, q}.holds(end)) return "the chain passes through " + text(world, end);
      between ^= (p.y > end.y) != (q.y > end.y) && (side(p, q, end) > 0) == (q.y > p.y);
      between |= chain.size() == 1 && 4 * dot(p - end, p - end) <= wide;  // no room for the disc at its end
    }
  }
  return between ? "" : "the chain separates nothing";
}

Judgement judged(const std::string& lines, const nlohmann::json& json) {
  const std::string kind = json.at("kind");
  const bool none = kind == "none", widest = kind == "widest";
  if (json.at("format") != "taut certificate 1" || (!none && !widest && kind != "shortest"))
    throw BadInput("the certificate is of another format");
  const World world(lines, json.at("scale").get<Int>());
  if (json.at("world") != fmt::format("{:016x}", world.hash))
    return {false, kind, "the certificate is of another world"};
  const auto number = [](Int n, Int least, Int most) {
    return least <= n && n <= most ? n : throw BadInput("a number of the certificate is out of range");
  };
  const auto places = [&](const char* name) {
    std::vector<Place> all;
    for (const auto& [x, y] : json.at(name).get<std::vector<std::array<Int, 2>>>()) all.push_back({x, y});
    const auto is_outside = [&](Place p) { return !world.edges.box().holds(p); };
    if (all.empty() || std::ranges::any_of(all, is_outside)) throw BadInput("places are out of range");
    return all;
  };
  const std::vector<Place> path = places("path"), goal = places("goal");
  const Box room{least(goal[0], goal.back()), most(goal[0], goal.back())};
  const Int keeps = widest ? number(json.at("keeps"), 0, kLargest) : 0;
  std::string words = none ? "" : fault(path, world, room, keeps);
  if (widest || json.contains("chain")) {
    const Int width = number(json.at("width"), 0, kLargest);
    if (words.empty()) words = passage(places("chain"), world, path[0], path.back(), Wide{width} * width - none);
    if (!words.empty()) return {false, kind, words};
    const Real bound = world.unit * width / 2, kept = world.unit * keeps;
    if (none) return {true, kind, fmt::format("no disc of radius {:.12g} gets through", bound), kept, bound};
    words = "no disc of a radius above {:.12g} gets through; the path keeps {:.12g}";
    return {true, kind, fmt::format(fmt::runtime(words), bound, kept), kept, bound};
  }
  const Place start = path[0], size = world.edges.box().max - world.edges.box().min;
  const int bits = static_cast<int>(number(json.at("fraction_bits"), 0, 59));
  if ((room.min.x == room.max.x) != (room.min.y == room.max.y) || dot(size, size) >> (118 - 2 * bits) != 0)
    throw BadInput("fraction_bits are out of range, or the goal has no area");
  const auto length = [bits](Place d) { return static_cast<Int>(root(dot(d, d) << (2 * bits))); };
  const Int horizon = number(json.at("horizon"), -kMost, kMost);
  const Int reach = none ? kFar : number(json.at("reach"), -kMost, horizon - 1);
  std::map<Place, Corner> nodes = world.corners;
  nodes[start] = {start};
  for (auto& [p, node] : nodes)  // between those that are not listed the differences are legs' anyway
    node.high = none ? kFar : horizon - length(room.away(p)), node.low = node.high - !none;
  for (const auto& row : json.at("potentials"))
    if (const auto at = nodes.find({row.at(0), row.at(1)}); at != nodes.end())
      at->second.low = at->second.high = number(row.at(2), -kMost, kMost), at->second.is_listed = true;
  const Int from = nodes[start].low;
  if (words.empty() && (!nodes[start].is_listed || (room.holds(start) && reach > from)))
    words = "the start is not listed, or in the goal";
  std::vector<Corner> all = ends(world, room, start, reach);
  for (const auto& [p, node] : nodes) all.push_back(node);
  if (words.empty()) words = refutation(world, room, Tree(all), bits);
  if (none || !words.empty()) return {words.empty(), kind, words.empty() ? "there is no path" : words};
  Wide sum = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) sum += length(path[i + 1] - path[i]) + 1;
  const Real step = std::ldexp(world.unit, -bits), yours = step * static_cast<Real>(sum),
             bound = yours - step * static_cast<Real>(sum - reach + from),
             slack = std::fmod(yours - bound, 1e-6L);  // of a path that is the shortest all of it
  words = fmt::format("no path is shorter than {:.9f} - {:.0e}; yours is {:.9f} long", bound + slack, slack, yours);
  return {true, kind, words, yours, bound};
}

}  // namespace

Judgement judge(const std::string& world, const std::string& certificate) try {
  return judged(world, nlohmann::json::parse(certificate));
} catch (const nlohmann::json::exception& error) {
  throw BadInput(std::string("the certificate cannot be read: ") + error.what());
}

}  // namespace taut::proof
