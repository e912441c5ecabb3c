#include <taut/geometry/detail/outline_rings.h>

#include <algorithm>
#include <span>

#include <taut/geometry/written.h>

namespace taut::detail {

namespace {

using Tri = Triangulation;
using Chain = std::vector<std::uint32_t>;  // vertices

class Tracer {
 public:
  explicit Tracer(const Tri& tri)
      : tri_(tri),
        region_(tri.triangles.size(), kNone),
        done_(3 * tri.triangles.size(), false),
        place_(tri.points.size(), kNone) {}

  std::vector<Polygon> run() {
    for (std::uint32_t t = 0; t < tri_.triangles.size(); ++t)
      if (tri_.free[t] && region_[t] == kNone) flood(t);
    polygons_.resize(regions_);
    for (std::uint32_t t = 0; t < tri_.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i)
        if (tri_.free[t] && on_outline(t, i) && !done_[3 * t + i]) trace(t, i);
    for (Polygon& polygon : polygons_) std::sort(polygon.holes.begin(), polygon.holes.end());
    std::sort(polygons_.begin(), polygons_.end(), [](const Polygon& a, const Polygon& b) { return a.outer < b.outer; });
    return std::move(polygons_);
  }

 private:
  bool on_outline(std::uint32_t t, int i) const {
    // Between free and solid, and on the hull of what is free, there is always a constrained side.
    return tri_.is_constrained(t, i) && (tri_.neighbours[t][i] == kNone || !tri_.free[tri_.neighbours[t][i]]);
  }

  void flood(std::uint32_t first) {
    Chain open{first};
    region_[first] = regions_;
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (const std::uint32_t n : tri_.neighbours[t]) {
        if (n == kNone || !tri_.free[n] || region_[n] != kNone) continue;
        region_[n] = regions_;
        open.push_back(n);
      }
    }
    ++regions_;
  }

  /// Follows the outline with the free space on the left, starting with side i of t.
  void trace(std::uint32_t t, int i) {
    const std::uint32_t region = region_[t];
    Chain chain;
    while (!done_[3 * t + i]) {
      done_[3 * t + i] = true;
      chain.push_back(tri_.triangles[t][Tri::ccw(i)]);
      const std::uint32_t v = tri_.triangles[t][Tri::cw(i)];
      // Around the end of this side, clockwise through free triangles, to the side where the outline goes on.
      for (;;) {
        const int c = tri_.corner(t, v);
        i = Tri::cw(c);
        if (on_outline(t, i)) break;
        t = tri_.cw_triangle(t, c);
      }
    }
    split(chain, region);
  }

  /// Cuts a chain where it comes back to a vertex.
  void split(const Chain& chain, std::uint32_t region) {
    Chain open;
    for (const std::uint32_t v : chain) {
      if (place_[v] != kNone) {
        const auto first = open.begin() + static_cast<std::ptrdiff_t>(place_[v]);
        add(std::span(open).subspan(place_[v]), region);
        open.erase(first, open.end());
      }
      place_[v] = static_cast<std::uint32_t>(open.size());
      open.push_back(v);
    }
    add(open, region);
  }

  void add(std::span<const std::uint32_t> loop, std::uint32_t region) {
    Ring ring;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      place_[loop[k]] = kNone;
      const Point before = tri_.points[loop[k == 0 ? loop.size() - 1 : k - 1]], p = tri_.points[loop[k]],
                  after = tri_.points[loop[k + 1 == loop.size() ? 0 : k + 1]];
      if (written::orientation(before, p, after) != 0) ring.push_back(p);
    }
    if (ring.size() < 3) return;
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    if (written::ring_orientation(ring) > 0)
      polygons_[region].outer = std::move(ring);
    else
      polygons_[region].holes.push_back(std::move(ring));
  }

  const Tri& tri_;
  std::vector<std::uint32_t> region_;
  std::vector<std::uint8_t> done_;
  std::vector<std::uint32_t> place_;  // by vertex: where it is in the chain that is split
  std::uint32_t regions_ = 0;
  std::vector<Polygon> polygons_;
};

}  // namespace

std::vector<Polygon> outline_rings(const Tri& tri) { return Tracer(tri).run(); }

}  // namespace taut::detail
