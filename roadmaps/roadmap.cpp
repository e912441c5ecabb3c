#include <taut/roadmaps/roadmap.h>

#include <algorithm>

#include <taut/geometry/expects.h>

namespace taut {

namespace {

/// Sorts each row, drops repeats and closes the gaps.
void tidy_rows(std::vector<std::uint64_t>& offsets, std::vector<Roadmap::Vertex>& targets) {
  auto kept = targets.begin();
  for (std::size_t v = 0; v + 1 < offsets.size(); ++v) {
    const auto first = targets.begin() + static_cast<std::ptrdiff_t>(offsets[v]);
    const auto last = targets.begin() + static_cast<std::ptrdiff_t>(offsets[v + 1]);
    offsets[v] = static_cast<std::uint64_t>(kept - targets.begin());
    std::sort(first, last);
    kept = std::move(first, std::unique(first, last), kept);
  }
  offsets.back() = static_cast<std::uint64_t>(kept - targets.begin());
  targets.erase(kept, targets.end());
}

}  // namespace

Roadmap::Roadmap(std::vector<Point> points, std::span<const std::pair<Vertex, Vertex>> edges)
    : points_(std::move(points)), offsets_(points_.size() + 1, 0) {
  // Counts become row starts; filling moves each start to its row's end, which is where the next row starts.
  for (const auto& [u, v] : edges) {
    TAUT_EXPECTS(u < points_.size() && v < points_.size());
    if (u == v) continue;
    ++offsets_[u];
    ++offsets_[v];
  }
  std::uint64_t sum = 0;
  for (std::uint64_t& offset : offsets_) sum += std::exchange(offset, sum);
  targets_.resize(sum);
  for (const auto& [u, v] : edges) {
    if (u == v) continue;
    targets_[offsets_[u]++] = v;
    targets_[offsets_[v]++] = u;
  }
  for (std::size_t v = points_.size(); v > 0; --v) offsets_[v] = offsets_[v - 1];
  offsets_[0] = 0;
  tidy_rows(offsets_, targets_);
}

Roadmap::Roadmap(std::vector<Point> points, std::vector<std::uint64_t> offsets, std::vector<Vertex> targets)
    : points_(std::move(points)), offsets_(std::move(offsets)), targets_(std::move(targets)) {
  TAUT_EXPECTS(offsets_.size() == points_.size() + 1);
  TAUT_EXPECTS(offsets_.front() == 0 && offsets_.back() == targets_.size());
}

bool Roadmap::adjacent(Vertex u, Vertex v) const {
  TAUT_EXPECTS(u < vertex_count() && v < vertex_count());
  if (neighbours(v).size() < neighbours(u).size()) std::swap(u, v);
  const auto row = neighbours(u);
  return std::binary_search(row.begin(), row.end(), v);
}

}  // namespace taut
