#include <taut/verify/judge.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>

namespace taut::proof {

namespace {

constexpr Int kMost = Int{1} << 61;  // of potentials; what is unreached has INT64_MAX

Int within(Int n, Int least, Int most) {
  return least <= n && n <= most ? n : throw BadInput("a number of the certificate is out of range");
}

Wide root(Wide square) {  // rounded down
  Wide root = static_cast<Wide>(std::sqrt(static_cast<Real>(square)));
  while (root * root > square) --root;
  while ((root + 1) * (root + 1) <= square) ++root;
  return root;
}

struct Node : Corner {
  Int low = 0, high = 0, is_listed = false;  // of its potential, in 2^-bits of the unit
};

struct Box {  // of nodes
  Place min, max;
  Int low, high;
};

class Potentials {
 public:
  std::map<Place, Node> nodes;
  const int bits;

  Potentials(const World& world, Place start, Place goal, int fraction_bits) : bits(fraction_bits), world_(world) {
    if (bits < 0 || bits > 59 || dot(world.high - world.low, world.high - world.low) >> (118 - 2 * bits) != 0)
      throw BadInput("fraction_bits are out of range");
    for (const Corner& c : world.corners) nodes[c.at] = {c};
    for (const Place p : {start, goal}) nodes[p] = {Corner{p}};
  }

  Int distance(Place p, Place q) const { return static_cast<Int>(root(squared(q - p))); }

  // A leg from a listed node that a shortest path could have, while the potentials of its ends differ by more than it
  // is long. Nodes are asked about by boxes of them, a kd-tree.
  std::string refutation() {
    for (const auto& [p, node] : nodes) order_.push_back(&node);
    boxes_.resize(4 * order_.size());
    build(0, order_);
    for (const auto& [p, from] : nodes) {
      blockers_.clear();
      if (const Node* const to = from.is_listed ? open(from, 0, order_) : nullptr)
        return "nothing stops the leg " + world_.text(p) + "-" + world_.text(to->at) + ", shorter than potentials say";
    }
    return {};
  }

 private:
  using Run = std::span<const Node*>;

  Wide squared(Place d) const { return dot(d, d) << (2 * bits); }

  void build(std::size_t at, Run run) {
    Box& box = boxes_[at] = {run[0]->at, run[0]->at, run[0]->low, run[0]->high};
    for (const Node* n : run)
      box = {least(box.min, n->at), most(box.max, n->at), std::min(box.low, n->low), std::max(box.high, n->high)};
    if (run.size() == 1) return;
    const bool wide = box.max.x - box.min.x > box.max.y - box.min.y;
    const auto key = [wide](const Node* n) { return wide ? n->at : Place{n->at.y, n->at.x}; };
    const std::size_t half = run.size() / 2;
    std::nth_element(run.begin(), run.begin() + half, run.end(), [&](auto* a, auto* b) { return key(a) < key(b); });
    build(2 * at + 1, run.first(half));
    build(2 * at + 2, run.subspan(half));
  }

  // Potentials in the box differ by less than it is away; or no leg into it is tangent at the node; or it lies wholly
  // behind an edge that was in the way of another leg.
  bool is_settled(const Node& from, const Box& box) const {
    const Place u = from.at, away{std::max<Int>({box.min.x - u.x, u.x - box.max.x, 0}),
                                  std::max<Int>({box.min.y - u.y, u.y - box.max.y, 0})};
    const Wide differ = std::max(Wide{from.high} - box.low, Wide{box.high} - from.low);
    if (differ <= 0 || (differ <= 2 * kMost && differ * differ <= squared(away))) return true;
    const auto holds = [&](auto inside) {  // a convex place holds the box when it holds the corners
      return inside(box.min) && inside(box.max) && inside({box.min.x, box.max.y}) && inside({box.max.x, box.min.y});
    };
    for (const int s : {1, -1})
      if (holds([&](Place p) { return s * cross(from.right, p - u) > 0 && s * cross(p - u, from.left) > 0; }))
        return true;
    return std::any_of(blockers_.rbegin(), blockers_.rend(), [&](const Edge& e) {  // u lies to their left
      return holds([&](Place p) { return side(e.a, e.b, p) < 0 && side(u, e.a, p) > 0 && side(u, e.b, p) < 0; });
    });
  }

  // The nearer half first: what is near casts wider shadows.
  const Node* open(const Node& from, std::size_t at, Run run) {
    if (is_settled(from, boxes_[at])) return nullptr;
    if (run.size() == 1) return is_open(from, *run[0]) ? run[0] : nullptr;
    const auto away = [&](const Box& b) { return (b.min - from.at) - (from.at - b.max); };
    const Place d = away(boxes_[2 * at + 1]), e = away(boxes_[2 * at + 2]);
    const std::size_t nearer = dot(e, e) < dot(d, d) ? 1 : 0, half = run.size() / 2;
    for (const std::size_t i : {nearer, 1 - nearer})
      if (const Node* to = open(from, 2 * at + 1 + i, i == 0 ? run.first(half) : run.subspan(half))) return to;
    return nullptr;
  }

  bool is_open(const Node& from, const Node& to) {
    if (from.at == to.at || !from.is_tangent(to.at - from.at) || !to.is_tangent(to.at - from.at)) return false;
    const int found = world_.leg(from, to);
    if (found < 0) return found == World::kOpen;
    const Edge& e = world_.edges[static_cast<std::size_t>(found)];
    blockers_.push_back(side(e.a, e.b, from.at) > 0 ? e : Edge{e.b, e.a});
    return false;
  }

  const World& world_;
  std::vector<const Node*> order_;
  std::vector<Box> boxes_;
  std::vector<Edge> blockers_;
};

// Why the path cannot be followed. It bends around corners, and where nothing stands.
std::string fault(const std::vector<Place>& path, const World& world, const Potentials& potentials) {
  int turn = 0;  // at u
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const bool ends = i + 2 == path.size();
    const Corner u{path[i], Place{i > 0, 0}}, v{path[i + 1], Place{!ends, 0}};  // ends have no directions
    const int next = ends ? 0 : side(u.at, v.at, path[i + 2]);
    if (u.at == v.at || !(ends || (next != 0 && potentials.nodes.contains(v.at)) || !world.joins(v.at, v.at)))
      return "the path bends at " + world.text(v.at) + ", on a wall";
    if (world.leg(u, v, turn, next) != World::kOpen)
      return "the path does not get from " + world.text(u.at) + " to " + world.text(v.at);
    turn = next;
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

std::string nearness(const std::vector<Place>& path, const World& world, Int r) {
  for (std::size_t i = 0; i < path.size(); ++i)
    for (const Edge& e : world.edges) {
      const Edge leg{path[i], path[std::min(i + 1, path.size() - 1)]};
      if (is_near(leg.a, e, r) || is_near(leg.b, e, r) || is_near(e.a, leg, r) || is_near(e.b, leg, r))
        return "the path comes too near to a wall from " + world.text(leg.a) + " to " + world.text(leg.b);
    }
  return {};
}

// Why no closed chain of pieces and gates, links between pieces with squares up to `wide`, is between both ends.
std::string passage(const std::vector<Place>& chain, const World& world, Place start, Place goal, Wide wide) {
  bool between = false;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Place p = chain[i], q = chain[(i + 1) % chain.size()];
    const bool gate = dot(q - p, q - p) <= wide && world.joins(p, p) && world.joins(q, q);
    if (!gate && !world.joins(p, q)) return "the chain is open from " + world.text(p) + " to " + world.text(q);
    for (const Place end : {start, goal}) {
      if (Edge{p, q}.holds(end)) return "the chain passes through " + world.text(end);
      between ^= (p.y > end.y) != (q.y > end.y) && (side(p, q, end) > 0) == (q.y > p.y);
      between |= chain.size() == 1 && 4 * dot(p - end, p - end) <= wide;  // no room for the disc at its end
    }
  }
  return between ? "" : "the chain separates nothing";
}

Judgement judged(const std::string& lines, const nlohmann::json& json) {
  Judgement said{false, json.at("kind").get<std::string>(), "the certificate is of another world"};
  const bool none = said.kind == "none", widest = said.kind == "widest";
  if (json.at("format") != "taut certificate 1" || (!none && !widest && said.kind != "shortest"))
    throw BadInput("the certificate is of another format");
  const World world(lines, json.at("scale").get<Int>());
  char words[200];
  std::snprintf(words, sizeof words, "%016llx", static_cast<unsigned long long>(world.hash));
  if (json.at("world") != words) return said;
  const auto places = [&](const char* name) {
    std::vector<Place> all;
    for (const auto& [x, y] : json.at(name).get<std::vector<std::array<Int, 2>>>()) all.push_back({x, y});
    const auto lies_in = [&](Place p) { return least(p, world.low) == world.low && most(p, world.high) == world.high; };
    if (all.empty() || !std::all_of(all.begin(), all.end(), lies_in)) throw BadInput("places are out of range");
    return all;
  };
  const std::vector<Place> path = places("path");
  const Place start = path.front(), goal = path.back();
  Potentials potentials(world, start, goal, json.value("fraction_bits", 0));
  said.words = none ? "" : fault(path, world, potentials);
  if (widest || json.contains("chain")) {
    const Int keeps = within(json.value("keeps", Int{0}), 0, kLargest),
              width = within(json.at("width").get<Int>(), 0, kLargest);
    if (said.words.empty()) said.words = passage(places("chain"), world, start, goal, Wide{width} * width - none);
    if (said.words.empty() && widest) said.words = nearness(path, world, keeps);
    if (!said.words.empty()) return said;
    const Real bound = world.unit * static_cast<Real>(width) / 2, kept = world.unit * static_cast<Real>(keeps);
    const char* const form = none ? "no disc of radius %.12Lg gets through"
                                  : "no disc of a radius above %.12Lg gets through; the path keeps %.12Lg";
    std::snprintf(words, sizeof words, form, bound, kept);
    return {true, said.kind, words, kept, bound};
  }
  const Int horizon = within(json.at("horizon").get<Int>(), -kMost, kMost);
  for (auto& [p, node] : potentials.nodes)  // between those that are not listed the differences are legs' anyway
    node.high = none ? INT64_MAX : horizon - potentials.distance(p, goal), node.low = node.high - !none;
  for (const auto& [x, y, n] : json.at("potentials").get<std::vector<std::array<Int, 3>>>())
    if (const auto at = potentials.nodes.find({x, y}); at != potentials.nodes.end())
      at->second.low = at->second.high = within(n, -kMost, kMost), at->second.is_listed = true;
  const Node &from = potentials.nodes[start], &to = potentials.nodes[goal];
  if (said.words.empty() && (!from.is_listed || to.is_listed == none)) said.words = "an end is listed, or is not";
  if (said.words.empty()) said.words = potentials.refutation();
  if (!said.words.empty()) return said;
  Wide length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) length += potentials.distance(path[i], path[i + 1]) + 1;
  const Real step = std::ldexp(world.unit, -potentials.bits), yours = step * static_cast<Real>(length),
             bound = yours - step * static_cast<Real>(length - to.low + from.low),
             slack = std::fmod(yours - bound, 1e-6L);  // of a path that is the shortest all of it
  std::snprintf(words, sizeof words, "no path is shorter than %.9Lf - %.0Le; yours is %.9Lf long", bound + slack, slack,
                yours);
  return {true, said.kind, none ? "there is no path" : words, yours, bound};
}

}  // namespace

Judgement judge(const std::string& world, const std::string& certificate) try {
  return judged(world, nlohmann::json::parse(certificate));
} catch (const nlohmann::json::exception& error) {
  throw BadInput(std::string("the certificate cannot be read: ") + error.what());
}

}  // namespace taut::proof
