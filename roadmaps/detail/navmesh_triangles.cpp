#include <taut/roadmaps/detail/navmesh_triangles.h>

#include <algorithm>
#include <array>

#include <taut/geometry/box.h>

namespace taut::detail {

namespace {

Box box_of(const Triangulation& tri, std::uint32_t t) {
  const auto& [a, b, c] = tri.triangles[t];
  return box_around(std::array{tri.points[a], tri.points[b], tri.points[c]});
}

bool meet(const Box& a, const Box& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

/// Counts of the free triangles across the sides, 3 at most; what is left out, or no place at all, has kOut.
class DeadEnds {
 public:
  DeadEnds(const Triangulation& tri, std::span<const Box> ends) : tri_(tri), ways_(tri.triangles.size(), kOut) {
    for (std::uint32_t t = 0; t < ways_.size(); ++t)
      if (tri.free[t]) ways_[t] = ways(t, ends);
    for (std::uint32_t t = 0; t < ways_.size(); ++t) fill_in(t);
  }

  bool is_out(std::uint32_t t) const { return ways_[t] == kOut; }

 private:
  static constexpr std::uint8_t kOut = 0xff, kKept = 0x80;  // an end: never as few as one

  std::uint8_t ways(std::uint32_t t, std::span<const Box> ends) const {
    const Box box = box_of(tri_, t);
    if (std::any_of(ends.begin(), ends.end(), [&](const Box& end) { return meet(box, end); })) return kKept;
    std::uint8_t count = 0;
    for (int i = 0; i < 3; ++i) count += tri_.neighbours[t][i] != kNone && !tri_.is_constrained(t, i);
    return count;
  }

  /// From a dead end back to where it branches off.
  void fill_in(std::uint32_t t) {
    while (t != kNone && ways_[t] <= 1) {
      ways_[t] = kOut;
      const std::uint32_t last = t;
      t = kNone;
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t n = tri_.neighbours[last][i];
        if (n != kNone && !tri_.is_constrained(last, i) && ways_[n] != kOut) t = n;
      }
      if (t != kNone && ways_[t] != kKept) --ways_[t];
    }
  }

  const Triangulation& tri_;
  std::vector<std::uint8_t> ways_;
};

}  // namespace

std::vector<std::uint32_t> free_triangles(const Triangulation& tri) {
  std::vector<std::uint32_t> chosen;
  chosen.reserve(tri.triangles.size());
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
    if (tri.free[t]) chosen.push_back(t);
  return chosen;
}

std::vector<std::uint32_t> triangles_between(const Triangulation& tri, std::span<const Box> ends) {
  const DeadEnds dead(tri, ends);
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
    if (!dead.is_out(t)) chosen.push_back(t);
  return chosen;
}

}  // namespace taut::detail
