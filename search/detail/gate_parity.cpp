#include <taut/search/detail/gate_parity.h>

#include <algorithm>
#include <utility>

#include <taut/geometry/written.h>
#include <taut/roadmaps/exact/exact_gates.h>

namespace taut::detail {

namespace {

/// A point strictly inside a triangle of the space at p, when p touches a constraint; else p. (Of a triangle so thin
/// that rounding leaves it, p as well.)
Point inner_point(const FreeSpace& space, Point p, int choice) {
  const Location at = space.locate(p);
  const Triangulation& tri = space.triangulation();
  if (at.kind == Location::Kind::triangle || at.kind == Location::Kind::outside) return p;
  const auto& corners = tri.triangles[at.triangle];
  const Point a = tri.points[corners[0]], b = tri.points[corners[1]], c = tri.points[corners[2]];
  const double u = 0.31 + 0.013 * choice, v = 0.37 - 0.017 * choice, w = 1 - u - v;
  const Point inner{u * a.x + v * b.x + w * c.x, u * a.y + v * b.y + w * c.y};
  const bool inside = written::orientation(a, b, inner) > 0 && written::orientation(b, c, inner) > 0 &&
                      written::orientation(c, a, inner) > 0;
  return inside ? inner : p;
}

/// Trees over vertices; each vertex knows the parity of the chain from its parent.
class ParityForest {
 public:
  explicit ParityForest(std::size_t count) : links_(count) {
    for (std::uint32_t v = 0; v < count; ++v) links_[v] = {v, 1, false};
  }

  struct Root {
    std::uint32_t vertex;
    bool parity;
  };

  Root root(std::uint32_t v) {
    bool parity = false;
    while (links_[v].parent != v) {
      Link& link = links_[v];
      const Link& above = links_[link.parent];  // halve the path
      const bool to_above = above.parent != link.parent && above.parity;
      parity ^= link.parity ^ to_above;
      link = {above.parent, link.size, static_cast<bool>(link.parity ^ to_above)};
      v = link.parent;
    }
    return {v, parity};
  }

  void join(Root a, Root b, bool parity) {
    if (links_[a.vertex].size < links_[b.vertex].size) std::swap(a, b);
    links_[a.vertex].size += links_[b.vertex].size;
    links_[b.vertex].parent = a.vertex;
    links_[b.vertex].parity = parity ^ a.parity ^ b.parity;
  }

 private:
  struct Link {
    std::uint32_t parent;
    std::uint32_t size;
    bool parity;
  };
  std::vector<Link> links_;
};

/// A constraint or gate between two vertices.
struct ChainEdge {
  std::uint32_t u, v;
  BarrierPiece piece;
};

/// The pieces of the tree path from `from` to `to`, in order.
std::vector<ChainEdge> tree_path(const std::vector<ChainEdge>& tree, std::size_t vertices, std::uint32_t from,
                                 std::uint32_t to) {
  std::vector<std::uint32_t> first(vertices + 1, 0), edge_at(2 * tree.size()), via(vertices, kNone);
  for (const ChainEdge& e : tree) ++first[e.u], ++first[e.v];
  for (std::size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
  for (std::uint32_t i = 0; i < tree.size(); ++i) edge_at[--first[tree[i].u]] = i, edge_at[--first[tree[i].v]] = i;
  // Backwards from `to`, so that following `via` from `from` leads there.
  std::vector<std::uint32_t> open{to};
  for (std::size_t n = 0; n < open.size() && via[from] == kNone; ++n)
    for (std::uint32_t k = first[open[n]]; k < first[open[n] + 1]; ++k) {
      const ChainEdge& e = tree[edge_at[k]];
      const std::uint32_t other = e.u == open[n] ? e.v : e.u;
      if (edge_at[k] == via[open[n]] || other == to || via[other] != kNone) continue;
      via[other] = edge_at[k];
      open.push_back(other);
    }
  std::vector<ChainEdge> path;
  for (std::uint32_t v = from; v != to;) {
    const ChainEdge& e = tree[via[v]];
    path.push_back(e.u == v ? e : ChainEdge{e.v, e.u, e.piece});
    v = path.back().v;
  }
  return path;
}

/// The closed chain, with the constraint along which a gate's foot reaches facing's a put in.
std::vector<BarrierPiece> pieces_of(const Gates& gates, const std::vector<ChainEdge>& chain) {
  std::vector<BarrierPiece> pieces;
  for (const ChainEdge& e : chain) {
    const bool inside = e.piece.gate != kNone && !gates.gates()[e.piece.gate].foot_is_end;
    const BarrierPiece along{inside ? gates.gates()[e.piece.gate].facing : kNone, kNone};
    const bool ends_at_foot = inside && e.u == gates.exact().nodes[e.piece.gate][0];
    if (inside && !ends_at_foot) pieces.push_back(along);
    pieces.push_back(e.piece);
    if (ends_at_foot) pieces.push_back(along);
  }
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  if (pieces.size() > 1 && pieces.front() == pieces.back()) pieces.pop_back();
  return pieces;
}

std::optional<SeparatingChain> closed_chain(const Gates& gates, const CrossingParity& parity, std::uint32_t count) {
  const auto& ends = gates.exact().walls.ends();
  const std::size_t vertices = gates.space().triangulation().points.size();
  ParityForest forest(vertices);
  std::vector<ChainEdge> tree;
  const auto closes = [&](const ChainEdge& e, bool odd) {
    const auto u = forest.root(e.u), v = forest.root(e.v);
    if (u.vertex == v.vertex) return (u.parity ^ v.parity ^ odd) != 0;
    forest.join(u, v, odd);
    tree.push_back(e);
    return false;
  };
  const auto chain = [&](const ChainEdge& last) {
    std::vector<ChainEdge> path = tree_path(tree, vertices, last.v, last.u);
    path.insert(path.begin(), last);
    return SeparatingChain{pieces_of(gates, path), last.piece.gate};
  };
  for (std::uint32_t c = 0; c < ends.size(); ++c)
    if (const ChainEdge e{ends[c][0], ends[c][1], {c, kNone}}; closes(e, parity.of_constraint(c))) return chain(e);
  for (std::uint32_t i = 0; i < count && !parity.is_degenerate(); ++i) {
    const auto [u, v] = gates.exact().nodes[i];
    if (const ChainEdge e{u, v, {kNone, i}}; closes(e, parity.of_gate(i))) return chain(e);
  }
  return std::nullopt;
}

}  // namespace

CrossingParity::CrossingParity(const Gates& gates, Point s, Point g, int choice) : gates_(gates) {
  const Point from = inner_point(gates.space(), s, choice), to = inner_point(gates.space(), g, choice);
  if (from != s) add_leg(s, from, true);
  if (from != to) add_leg(from, to, false);
  if (to != g) add_leg(to, g, true);
}

void CrossingParity::add_leg(Point s, Point g, bool within_triangle) {
  Leg leg{s, g, within_triangle};
  const std::vector<Point>& points = gates_.space().triangulation().points;
  leg.right_of.reserve(points.size());
  for (const Point p : points) leg.right_of.push_back(written::orientation(s, g, p) < 0);
  legs_.push_back(std::move(leg));
}

bool CrossingParity::of_constraint(std::uint32_t c) const {
  bool odd = false;
  for (const Leg& leg : legs_) odd ^= crosses_constraint(leg, c);
  return odd;
}

bool CrossingParity::of_gate(std::uint32_t i) const {
  bool odd = false;
  for (const Leg& leg : legs_) odd ^= crosses_gate(leg, i);
  return odd;
}

bool CrossingParity::crosses_constraint(const Leg& leg, std::uint32_t c) const {
  const auto [u, v] = gates_.exact().walls.ends()[c];
  if (leg.within_triangle || leg.right_of[u] == leg.right_of[v]) return false;
  const auto [a, b] = gates_.exact().walls.segment(c);
  return written::orientation(a, b, leg.s) * written::orientation(a, b, leg.g) < 0;
}

bool CrossingParity::crosses_gate(const Leg& leg, std::uint32_t i) const {
  const GateShape& shape = gates_.exact().shapes[i];
  const Gate& gate = gates_.gates()[i];
  const auto [u, v] = gates_.exact().nodes[i];
  const bool end_right = leg.right_of[u];
  const bool foot_right = gate.foot_is_end ? leg.right_of[v] != 0 : foot_orientation(leg.s, leg.g, shape) < 0;
  bool odd = false;
  if (end_right != foot_right) {
    const int sides = side_of_gate(shape, leg.s) * side_of_gate(shape, leg.g);
    // A corner of the line on the gate itself is none of its ends, which keep their distance.
    if (sides == 0) degenerate_ = true;
    odd = sides < 0;
  }
  if (gate.foot_is_end || leg.within_triangle || foot_right == (leg.right_of[v] != 0)) return odd;
  const auto [a, b] = gates_.exact().walls.segment(gate.facing);
  return odd ^ (written::orientation(a, b, leg.s) * written::orientation(a, b, leg.g) < 0);
}

std::optional<SeparatingChain> separating_chain(const Gates& gates, Point s, Point g, std::uint32_t count) {
  constexpr int kChoices = 16;
  for (int choice = 0;; ++choice) {
    const CrossingParity parity(gates, s, g, choice);
    auto chain = closed_chain(gates, parity, count);
    if (!parity.is_degenerate() || choice == kChoices) return chain;
  }
}

}  // namespace taut::detail
