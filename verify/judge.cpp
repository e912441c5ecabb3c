#include <taut/verify/judge.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <sstream>

namespace taut::proof {

namespace {

using Json = nlohmann::json;

constexpr Int kMost = Int{1} << 61;  // of potentials; what is unreached has INT64_MAX

Int within(Int n, Int most) {
  return -most <= n && n <= most ? n : throw BadInput("a number of the certificate is out of range");
}

struct Node : Corner {
  Int low = 0, high = 0;  // of its potential, in 2^-bits of the unit
  bool is_listed = false;
};

struct Box {  // of nodes
  Place min, max;
  Int low, high;
};

class Potentials {
 public:
  std::vector<Node> nodes;  // by place

  Potentials(const World& world, Place start, Place goal, int bits) : world_(world), bits_(bits) {
    for (const Place p : {start, goal})
      if (p.x < world.low.x || p.y < world.low.y || p.x > world.high.x || p.y > world.high.y || bits < 0 || bits > 59 ||
          dot(world.high - world.low, world.high - world.low) >> (118 - 2 * bits) != 0)
        throw BadInput("start, goal or fraction_bits are out of range");
    for (const Corner& c : world.corners)
      if (c.at != start && c.at != goal) nodes.push_back({c});
    nodes.push_back({Corner{start}});
    if (goal != start) nodes.push_back({Corner{goal}});
    std::sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.at < b.at; });
  }

  Node* find(Place p) {
    const auto node = std::lower_bound(nodes.begin(), nodes.end(), p, [](auto& n, Place q) { return n.at < q; });
    return node != nodes.end() && node->at == p ? &*node : nullptr;
  }

  Int distance(Place p, Place q) const {  // rounded down
    const Wide square = squared(q - p);
    Int root = static_cast<Int>(std::sqrt(static_cast<long double>(square)));
    while (Wide{root} * root > square) --root;
    while (Wide{root + 1} * (root + 1) <= square) ++root;
    return root;
  }

  // A leg from a listed node that a shortest path could have, while the potentials of its ends differ by more than it
  // is long. Nodes are asked about by boxes of them, a kd-tree.
  std::optional<std::pair<Place, Place>> refutation() {
    for (const Node& node : nodes) order_.push_back(&node);
    boxes_.resize(4 * order_.size());
    build(0, order_);
    for (const Node& from : nodes) {
      blockers_.clear();
      if (!from.is_listed) continue;
      if (const Node* const to = open(from, 0, order_)) return std::pair(from.at, to->at);
    }
    return std::nullopt;
  }

 private:
  using Run = std::span<const Node*>;

  Wide squared(Place d) const { return dot(d, d) << (2 * bits_); }

  void build(std::size_t at, Run run) {
    Box box{run[0]->at, run[0]->at, run[0]->low, run[0]->high};
    for (const Node* n : run) {
      box.min = {std::min(box.min.x, n->at.x), std::min(box.min.y, n->at.y)};
      box.max = {std::max(box.max.x, n->at.x), std::max(box.max.y, n->at.y)};
      box.low = std::min(box.low, n->low), box.high = std::max(box.high, n->high);
    }
    boxes_[at] = box;
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
  int bits_;
  std::vector<const Node*> order_;
  std::vector<Box> boxes_;
  std::vector<Edge> blockers_;
};

std::string text(Place p, long double unit) {
  char out[80];
  std::snprintf(out, sizeof out, "(%.12Lg, %.12Lg)", unit * p.x, unit * p.y);
  return out;
}

// Why the path cannot be followed. It bends only where shortest ones do, around what stands there.
std::string fault(const std::vector<Place>& path, const World& world, Potentials& nodes, long double unit) {
  const auto turn = [&](std::size_t i) {
    return i == 0 || i + 1 == path.size() ? 0 : side(path[i - 1], path[i], path[i + 1]);
  };
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Corner u{path[i], Place{i > 0, 0}}, v{path[i + 1], Place{i + 2 < path.size(), 0}};  // ends have no directions
    if (u.at == v.at || (i + 2 < path.size() && (!nodes.find(v.at) || turn(i + 1) == 0)))
      return "the path bends at " + text(v.at, unit) + ", where no shortest one does";
    if (world.leg(u, v, turn(i), turn(i + 1)) != World::kOpen)
      return "the path does not get from " + text(u.at, unit) + " to " + text(v.at, unit);
  }
  return {};
}

std::string fingerprint(const std::string& world) {  // FNV-1a over the lines that are no ends
  std::uint64_t hash = 0xcbf29ce484222325;
  std::istringstream lines(world);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("start ") && !line.starts_with("goal "))
      for (const char c : line + '\n') hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

Judgement judged(const std::string& lines, const Json& json) {
  Judgement said{false, json.at("kind").get<std::string>(), "the certificate is of another world"};
  const bool none = said.kind == "none";
  if (json.at("format").get<std::string>() != "taut certificate 1" || (!none && said.kind != "shortest"))
    throw BadInput("the certificate is of another format");
  if (json.at("world").get<std::string>() != fingerprint(lines)) return said;
  const World world(lines, json.at("scale").get<Int>());
  const long double unit = world.unit / json.at("scale").get<long double>();
  std::vector<Place> path;
  for (const auto& [x, y] : json.at("path").get<std::vector<std::array<Int, 2>>>())
    path.push_back({within(x, kLargest), within(y, kLargest)});
  if (path.empty()) throw BadInput("the certificate's path has no points");
  const int bits = json.at("fraction_bits").get<int>();
  const Int horizon = within(json.at("horizon").get<Int>(), kMost);
  Potentials nodes(world, path.front(), path.back(), bits);
  for (const auto& [x, y, potential] : json.at("potentials").get<std::vector<std::array<Int, 3>>>())
    if (Node* node = nodes.find({x, y})) {
      node->low = node->high = within(potential, kMost);
      node->is_listed = true;
    }
  for (Node& node : nodes.nodes)  // between those that are not listed the differences are legs' anyway
    if (!node.is_listed) {
      node.high = none ? INT64_MAX : horizon - nodes.distance(node.at, path.back());
      node.low = node.high - (none ? 0 : 1);
    }
  const Node start = *nodes.find(path.front()), goal = *nodes.find(path.back());
  said.words = none ? "" : fault(path, world, nodes, unit);
  if (said.words.empty() && (!start.is_listed || goal.is_listed == none)) said.words = "an end is listed, or is not";
  if (!said.words.empty()) return said;
  if (const auto leg = nodes.refutation())
    return {false, said.kind,
            "nothing stops the leg " + text(leg->first, unit) + "-" + text(leg->second, unit) +
                (none ? ", which leads out of what is reached" : ", shorter than potentials say")};
  Wide length = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) length += nodes.distance(path[i], path[i + 1]) + 1;
  const long double step = std::ldexp(unit, -bits), long_ = step * static_cast<long double>(length),
                    less = static_cast<long double>(length - goal.low + start.low) * step;
  char words[200];
  std::snprintf(words, sizeof words, "no path is shorter than %.9Lf - %.0Le; yours is %.9Lf long", long_, less, long_);
  return {true, said.kind, none ? "there is no path" : words, static_cast<double>(long_),
          static_cast<double>(long_ - less)};
}

}  // namespace

Judgement judge(const std::string& world, const std::string& certificate) try {
  return judged(world, Json::parse(certificate));
} catch (const Json::exception& error) {
  throw BadInput(std::string("the certificate cannot be read: ") + error.what());
}

}  // namespace taut::proof
