#include <taut/geometry/detail/triangulate.h>

#include <limits>
#include <stdexcept>

#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

constexpr int kUnknown = std::numeric_limits<int>::min();

/// Spreads winding numbers from the hull inwards.
class Winding {
 public:
  Winding(const Mesh& mesh, std::span<const Edge> edges)
      : mesh_(mesh), tri_(mesh.triangulation), winding_(tri_.triangles.size(), kUnknown) {
    turns_.reserve(edges.size());
    for (const Edge& e : edges) turns_.push_back(e.turn);
  }

  std::vector<int> numbers(int outside) {
    for (std::uint32_t t = 0; t < tri_.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i)
        if (tri_.neighbours[t][i] == kNone) {
          set(t, outside - change(t, i));
          spread();
        }
    return std::move(winding_);
  }

 private:
  /// Of the winding number, from triangle t to beyond its side i.
  int change(std::uint32_t t, int i) const {
    const std::uint32_t edge = mesh_.edge_of[3 * t + i];
    if (edge == kNone || turns_[edge] == 0) return 0;
    return is_left_of_edge(tri_, t, i) ? -turns_[edge] : turns_[edge];
  }

  void set(std::uint32_t t, int winding) {
    if (winding_[t] == kUnknown) {
      winding_[t] = winding;
      open_.push_back(t);
    } else if (winding_[t] != winding) {
      throw std::logic_error("the outlines of the obstacles are not closed");
    }
  }

  void spread() {
    while (!open_.empty()) {
      const std::uint32_t t = open_.back();
      open_.pop_back();
      for (int i = 0; i < 3; ++i)
        if (const std::uint32_t n = tri_.neighbours[t][i]; n != kNone) set(n, winding_[t] + change(t, i));
    }
  }

  const Mesh& mesh_;
  const Triangulation& tri_;
  std::vector<int> turns_;  // of the edges
  std::vector<int> winding_;
  std::vector<std::uint32_t> open_;
};

/// Can a path turn around corner i of t into the next triangle counter-clockwise?
bool opens_ccw(const Triangulation& tri, std::uint32_t t, int i) {
  return !tri.is_constrained(t, Triangulation::ccw(i)) && tri.ccw_triangle(t, i) != kNone;
}
bool opens_cw(const Triangulation& tri, std::uint32_t t, int i) {
  return !tri.is_constrained(t, Triangulation::cw(i)) && tri.cw_triangle(t, i) != kNone;
}

bool is_reflex(const Triangulation& tri, const Triangulation::Sector& s) {
  return s.right == s.left || written::orientation(tri.points[s.vertex], tri.points[s.right], tri.points[s.left]) < 0;
}

/// Makes the sector of corner i of t.
void add_sector(Triangulation& tri, std::uint32_t t, int i) {
  Triangulation::Sector sector;
  const std::uint32_t v = sector.vertex = tri.triangles[t][i];
  const std::uint32_t origin = t;
  while (opens_cw(tri, t, i)) {
    t = tri.cw_triangle(t, i);
    i = tri.corner(t, v);
    if (t == origin) break;
  }
  sector.full = t == origin && opens_cw(tri, t, i);
  sector.triangle = t;
  if (!sector.full) sector.right = tri.triangles[t][Triangulation::ccw(i)];
  const auto id = static_cast<std::uint32_t>(tri.sectors.size());
  for (const std::uint32_t first = t;;) {
    tri.sector_of[3 * t + i] = id;
    if (!opens_ccw(tri, t, i)) break;
    t = tri.ccw_triangle(t, i);
    i = tri.corner(t, v);
    if (t == first) break;
  }
  if (!sector.full) sector.left = tri.triangles[t][Triangulation::cw(i)];
  sector.reflex = !sector.full && is_reflex(tri, sector);
  tri.sectors.push_back(sector);
}

void find_sectors(Triangulation& tri) {
  std::vector<std::uint32_t> first(tri.points.size() + 1, 0);
  for (const auto& triangle : tri.triangles)
    for (const std::uint32_t v : triangle) ++first[v + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<std::uint32_t> corners(3 * tri.triangles.size());
  auto next = first;
  for (std::uint32_t t = 0; t < tri.triangles.size(); ++t)
    for (const std::uint32_t v : tri.triangles[t]) corners[next[v]++] = t;
  tri.sector_of.assign(3 * tri.triangles.size(), kNone);
  for (std::uint32_t v = 0; v < tri.points.size(); ++v)
    for (auto k = first[v]; k != first[v + 1]; ++k) {
      const std::uint32_t t = corners[k];
      const int i = tri.corner(t, v);
      if (tri.free[t] && tri.sector_of[3 * t + i] == kNone) add_sector(tri, t, i);
    }
}

}  // namespace

std::vector<int> winding_numbers(const Mesh& mesh, std::span<const Edge> edges, int outside) {
  return Winding(mesh, edges).numbers(outside);
}

void classify(Mesh& mesh, std::span<const Edge> edges) {
  const std::vector<int> winding = winding_numbers(mesh, edges, 1);
  std::vector<std::uint8_t>& free = mesh.triangulation.free;
  free.resize(winding.size());
  for (std::size_t t = 0; t < free.size(); ++t) free[t] = winding[t] == 0;
  find_sectors(mesh.triangulation);
}

}  // namespace taut::detail
