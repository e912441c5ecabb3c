#include <taut/search/detail/landmarks.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <taut/search/detail/polyanya_engine.h>

namespace taut::detail {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// A bend of the component that has most of them.
std::uint32_t first_bend(const FreeSpace& space, const Navmesh& mesh) {
  std::vector<std::uint32_t> count(space.component_count());
  const auto component = [&](const Navmesh::Bend& bend) {
    return space.component(space.triangulation().sectors[bend.sector].triangle);
  };
  for (const Navmesh::Bend& bend : mesh.bends) ++count[component(bend)];
  const auto largest = static_cast<std::uint32_t>(std::max_element(count.begin(), count.end()) - count.begin());
  const auto at = std::find_if(mesh.bends.begin(), mesh.bends.end(),
                               [&](const Navmesh::Bend& bend) { return component(bend) == largest; });
  return static_cast<std::uint32_t>(at - mesh.bends.begin());
}

/// The bend farthest from all that `nearest` was measured from.
std::uint32_t farthest(const std::vector<double>& nearest) {
  std::uint32_t best = 0;
  double most = -1;
  for (std::uint32_t b = 0; b < nearest.size(); ++b)
    if (std::isfinite(nearest[b]) && nearest[b] > most) most = nearest[best = b];
  return best;
}

}  // namespace

Landmarks::Landmarks(const FreeSpace& space, const Navmesh& mesh, std::size_t count)
    : count_(mesh.bends.empty() ? 0 : count), table_(mesh.bends.size() * count_, kFar) {
  if (count_ == 0) return;
  PolyanyaEngine engine(mesh);
  std::vector<double> nearest, distances;
  engine.measure(first_bend(space, mesh), distances);
  nearest = distances;
  double most = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    engine.measure(farthest(nearest), distances);
    for (std::uint32_t b = 0; b < distances.size(); ++b) {
      if (!std::isfinite(distances[b])) continue;
      nearest[b] = i == 0 ? distances[b] : std::min(nearest[b], distances[b]);
      most = std::max(most, distances[b]);
      table_[b * count_ + i] = static_cast<float>(distances[b]);
    }
  }
  // Two floats, their difference, and the sums that they stand for.
  error_ = most * 0x1p-21;
}

void LandmarkBounds::aim_at(Point goal, std::span<const std::uint32_t> polygons) {
  is_used_ = landmarks_ != nullptr && landmarks_->count() > 0 && !polygons.empty();
  if (!is_used_) return;
  const std::size_t count = landmarks_->count();
  // Whatever polygon the path comes from: on a wall, those of its two sides are far from each other.
  least_.assign(count, kFar);
  most_.assign(count, 0);
  for (const std::uint32_t polygon : polygons)
    for (std::size_t i = 0; i < count; ++i) {
      float least = 0, most = kFar;
      for (const Navmesh::Corner& c : mesh_.ring(polygon)) {
        if (c.bend == kNone) continue;
        const float d = landmarks_->distances(c.bend)[i];
        if (d == kFar) continue;
        const auto leg = static_cast<float>(std::hypot(c.point.x - goal.x, c.point.y - goal.y));
        least = std::max(least, d - leg);
        most = std::min(most, d + leg);
      }
      least_[i] = std::min(least_[i], least);
      most_[i] = std::max(most_[i], most);
    }
}

}  // namespace taut::detail
