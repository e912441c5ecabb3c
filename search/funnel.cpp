#include <taut/search/funnel.h>

#include <cstddef>
#include <span>
#include <vector>

#include <taut/geometry/expects.h>
#include <taut/geometry/written.h>
#include <taut/search/detail/taut_string.h>

namespace taut {

namespace {

using Tri = Triangulation;

/// The two ends of a portal, as seen when passing it.
struct Portal {
  std::uint32_t right, left;
};

Portal portal_between(const Tri& tri, std::uint32_t t, std::uint32_t next) {
  for (int i = 0; i < 3; ++i)
    if (tri.neighbours[t][i] == next) return {tri.triangles[t][Tri::ccw(i)], tri.triangles[t][Tri::cw(i)]};
  TAUT_EXPECTS(!"consecutive triangles are neighbours");
  return {tri.triangles[t][0], tri.triangles[t][1]};
}

bool is_on(const Tri& tri, Point p, const Portal& portal) {
  return written::on_segment(p, tri.points[portal.right], tri.points[portal.left]);
}

/// Without the portals that an end lies on: these do not part it from the rest.
std::span<const Portal> trimmed(const Tri& tri, const Corridor& corridor, std::span<const Portal> portals) {
  while (!portals.empty() && is_on(tri, corridor.from, portals.front())) portals = portals.subspan(1);
  while (!portals.empty() && is_on(tri, corridor.to, portals.back())) portals = portals.first(portals.size() - 1);
  return portals;
}

}  // namespace

Path funnel(const Triangulation& tri, const Corridor& corridor) {
  TAUT_EXPECTS(!corridor.triangles.empty());
  std::vector<Portal> all;
  for (std::size_t i = 0; i + 1 < corridor.triangles.size(); ++i)
    all.push_back(portal_between(tri, corridor.triangles[i], corridor.triangles[i + 1]));
  detail::TautString string;
  string.begin(corridor.from);
  Portal last{kNone, kNone};
  for (const Portal& portal : trimmed(tri, corridor, all)) {
    if (portal.right != last.right) string.widen_right(tri.points[portal.right]);
    if (portal.left != last.left) string.widen_left(tri.points[portal.left]);
    last = portal;
  }
  Path path{string.close(corridor.to), {}};
  path.length = Length(path.points);
  return path;
}

std::optional<Path> shortened(const FreeSpace& space, const Path& path) {
  const auto corridor = corridor_of(space, path.points);
  if (!corridor) return std::nullopt;
  return funnel(space.triangulation(), *corridor);
}

}  // namespace taut
