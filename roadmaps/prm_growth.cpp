#include <taut/roadmaps/prm_growth.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <taut/geometry/expects.h>

namespace taut {

using Vertex = Roadmap::Vertex;

void PrmParts::add(std::size_t vertices) {
  const std::size_t first = parent_.size();
  parent_.resize(first + vertices);
  std::iota(parent_.begin() + static_cast<std::ptrdiff_t>(first), parent_.end(), static_cast<std::uint32_t>(first));
  size_.resize(first + vertices, 1);
  count_ += vertices;
}

std::uint32_t PrmParts::part(std::uint32_t v) {
  while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
  return v;
}

void PrmParts::join(std::uint32_t u, std::uint32_t v) {
  u = part(u);
  v = part(v);
  if (u == v) return;
  if (size_[u] < size_[v]) std::swap(u, v);
  parent_[v] = u;
  size_[u] += size_[v];
  --count_;
}

PrmGrowth::PrmGrowth(const FreeSpace& space, const PrmOptions& options, bool lazy)
    : clear_(space, options.clearance), samples_(clear_, options), connection_(options.connection), lazy_(lazy) {
  TAUT_EXPECTS(connection_.count >= 1 && connection_.radius > 0);
}

void PrmGrowth::add(std::size_t draws) {
  draw(draws, [](Point) { return true; });
}

void PrmGrowth::add_in(const BoxIndex& boxes, std::size_t draws) {
  draw(draws, [&](Point p) {
    bool is_in = false;
    boxes.meeting({p, p}, [&](std::uint32_t) { is_in = true; });
    return is_in;
  });
}

template <class Wanted>
void PrmGrowth::draw(std::size_t draws, Wanted&& wanted) {
  const auto first = static_cast<Vertex>(points_.size());
  for (std::size_t i = 0; i < draws; ++i)
    if (const auto sample = samples_.draw(wanted)) {
      points_.push_back(sample->point);
      places_.push_back(sample->place);
    }
  drawn_ += draws;
  nearest_.add(std::span(points_).subspan(first));
  parts_.add(points_.size() - first);
  if (connection_.rule == PrmConnection::Rule::visible && !lazy_)
    connect_visible(first);
  else if (connection_.rule == PrmConnection::Rule::forest && !lazy_)
    connect_forest(first);
  else
    connect(first);
}

std::vector<Vertex> PrmGrowth::candidates(Vertex v) const {
  const Point p = points_[v];
  if (connection_.rule == PrmConnection::Rule::radius) return nearest_.within(p, connection_.radius);
  std::size_t count = connection_.count;
  if (connection_.rule == PrmConnection::Rule::star)
    count = static_cast<std::size_t>(
        std::ceil(std::numbers::e * 1.5 * std::log(static_cast<double>(std::max<std::size_t>(points_.size(), 2)))));
  return nearest_.nearest(p, count + 1);  // it is its own nearest
}

void PrmGrowth::connect(Vertex first) {
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for (Vertex v = first; v < points_.size(); ++v)
    for (const Vertex w : candidates(v))
      if (v != w) pairs.emplace_back(std::min(v, w), std::max(v, w));
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& [u, v] : pairs) {
    PrmEdge edge{u, v};
    if (!lazy_ && !test(edge)) continue;
    edges_.push_back(edge);
    parts_.join(u, v);
  }
}

/// Pairs are tested from both ends, where both have to: remembering them costs more than it saves.
void PrmGrowth::connect_visible(Vertex first) {
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for (Vertex v = first; v < points_.size(); ++v) {
    const auto is_free = [&](Vertex w) {
      PrmEdge edge{v, w};
      return v != w && test(edge);
    };
    for (const Vertex w : nearest_accepted(nearest_, points_[v], connection_.count, 4 * connection_.count + 1, is_free))
      pairs.emplace_back(std::min(v, w), std::max(v, w));
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& [u, v] : pairs) {
    edges_.push_back({u, v, PrmEdge::State::free});
    parts_.join(u, v);
  }
}

void PrmGrowth::connect_forest(Vertex first) {
  for (Vertex v = first; v < points_.size(); ++v)
    for (const Vertex w : nearest_.nearest(points_[v], 4 * connection_.count + 1)) {
      PrmEdge edge{std::min(v, w), std::max(v, w)};
      if (parts_.part(v) == parts_.part(w) || !test(edge)) continue;
      edges_.push_back(edge);
      parts_.join(v, w);
    }
}

bool PrmGrowth::test(PrmEdge& edge) {
  if (edge.state == PrmEdge::State::untested) {
    ++tested_;
    const bool is_free = clear_.leg(points_[edge.u], places_[edge.u], points_[edge.v]);
    edge.state = is_free ? PrmEdge::State::free : PrmEdge::State::blocked;
  }
  return edge.state == PrmEdge::State::free;
}

void PrmGrowth::take_back(const Size& size) {
  points_.resize(size.vertices);
  places_.resize(size.vertices);
  edges_.resize(size.edges);
}

PrmCounts PrmGrowth::counts() const {
  PrmCounts counts{drawn_, points_.size(), tested_, 0, 0};
  PrmParts parts;
  parts.add(points_.size());
  for (const PrmEdge& edge : edges_) {
    if (edge.state != PrmEdge::State::free) continue;
    ++counts.edges;
    parts.join(edge.u, edge.v);
  }
  counts.components = parts.count();
  return counts;
}

Roadmap PrmGrowth::roadmap(bool untested) const {
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for (const PrmEdge& edge : edges_)
    if (edge.state == PrmEdge::State::free || (untested && edge.state == PrmEdge::State::untested))
      pairs.emplace_back(edge.u, edge.v);
  return Roadmap(points_, pairs);
}

std::vector<Vertex> nearest_visible(const PrmClear& clear, const PrmNearest& index, const std::vector<Point>& points,
                                    Point p, std::size_t count) {
  const bool keeps_clearance = clear.point(p);
  return nearest_accepted(index, p, count, index.size(), [&](Vertex v) {
    return keeps_clearance ? clear.leg(p, points[v]) : clear.space().sees(p, points[v]);
  });
}

}  // namespace taut
