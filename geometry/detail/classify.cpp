#include <taut/geometry/detail/triangulate.h>
#include <taut/geometry/predicates.h>

namespace taut::detail {

namespace {

constexpr std::uint8_t kUnknown = 2;

/// Does `piece` have its solid on the side of triangle t that lies on its side i?
bool solid_towards(const Triangulation& tri, std::uint32_t t, int i, const Constraint& piece) {
  // Triangle t lies to the left of the side from its corner ccw(i) to its corner cw(i).
  const bool forward = tri.points[tri.triangles[t][Triangulation::ccw(i)]] == piece.a;
  return forward ? piece.solid_left : piece.solid_right;
}

class Flood {
 public:
  Flood(Mesh& mesh, std::span<const Constraint> pieces) : mesh_(mesh), tri_(mesh.triangulation), pieces_(pieces) {}

  void run() {
    tri_.free.assign(tri_.triangles.size(), kUnknown);
    for (std::uint32_t t = 0; t < tri_.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t piece = mesh_.piece_of[3 * t + i];
        if (piece == kNone || pieces_[piece].is_wall()) continue;
        set(t, !solid_towards(tri_, t, i, pieces_[piece]));
        spread();
      }
    for (std::uint8_t& f : tri_.free) f = f == 1;
  }

 private:
  void set(std::uint32_t t, bool free) {
    if (tri_.free[t] == kUnknown) {
      tri_.free[t] = free;
      open_.push_back(t);
    } else if (tri_.free[t] != static_cast<std::uint8_t>(free)) {
      throw InputError({}, 0, "the outlines of the obstacles contradict each other");
    }
  }

  void spread() {
    while (!open_.empty()) {
      const std::uint32_t t = open_.back();
      open_.pop_back();
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t piece = mesh_.piece_of[3 * t + i], n = tri_.neighbours[t][i];
        if (piece != kNone && !pieces_[piece].is_wall()) set(t, !solid_towards(tri_, t, i, pieces_[piece]));
        else if (n != kNone) set(n, tri_.free[t]);
      }
    }
  }

  Mesh& mesh_;
  Triangulation& tri_;
  std::span<const Constraint> pieces_;
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
  return s.right == s.left || orientation(tri.points[s.vertex], tri.points[s.right], tri.points[s.left]) < 0;
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

void classify(Mesh& mesh, std::span<const Constraint> pieces) {
  Flood(mesh, pieces).run();
  find_sectors(mesh.triangulation);
}

}  // namespace taut::detail
