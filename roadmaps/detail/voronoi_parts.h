// What a VoronoiRoadmap holds, and how it is put together. Private.
#pragma once

#include <taut/roadmaps/detail/voronoi_geometry.h>
#include <taut/roadmaps/voronoi.h>

namespace taut {

namespace detail {

/// Edge indices in compressed rows.
struct EdgeRows {
  std::vector<std::uint32_t> offsets;
  std::vector<std::uint32_t> edges;

  std::span<const std::uint32_t> row(std::uint32_t i) const {
    return {edges.data() + offsets[i], edges.data() + offsets[i + 1]};
  }
};

struct VoronoiParts {
  FreeSpace space;
  std::vector<VoronoiSite> sites;
  std::vector<VoronoiVertex> vertices;
  std::vector<VoronoiEdge> edges;
  std::vector<std::uint32_t> by_rank;  ///< an edge of each rank
  EdgeRows at_vertex;
  EdgeRows beside_site;

  Segment segment(std::uint32_t site) const {
    const Constraint& c = space.constraints()[sites[site].constraint];
    const auto part = sites[site].part;
    return {part == VoronoiSite::Part::b ? c.b : c.a, part == VoronoiSite::Part::a ? c.a : c.b};
  }
  Bezier curve(const VoronoiEdge& e) const { return {vertices[e.from].at, e.control, vertices[e.to].at}; }
};

/// Curves are shaped by `jobs` threads.
VoronoiParts voronoi_parts(const FreeSpace& space, unsigned jobs = 1, const TellProgress& tell = {});

}  // namespace detail

struct VoronoiRoadmap::Impl : detail::VoronoiParts {};

}  // namespace taut
