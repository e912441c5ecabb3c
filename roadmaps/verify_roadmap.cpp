#include <taut/roadmaps/verify_roadmap.h>

#include <algorithm>

#include <taut/geometry/text.h>

namespace taut {

namespace {

using Vertex = Roadmap::Vertex;

std::string named(const Roadmap& roadmap, Vertex v) {
  return "vertex " + std::to_string(v) + ", " + text(roadmap.point(v)) + ",";
}

std::string edge_text(const Roadmap& roadmap, Vertex v, Vertex w) {
  return "the edge from " + named(roadmap, v) + " to " + named(roadmap, w);
}

/// The first neighbour above v that only one of the rows has.
std::optional<RoadmapFault> row_difference(const Roadmap& roadmap, const Roadmap& wanted, Vertex v) {
  const auto given = roadmap.neighbours(v), right = wanted.neighbours(v);
  auto [g, w] = std::mismatch(given.begin(), given.end(), right.begin(), right.end());
  if (g == given.end() && w == right.end()) return std::nullopt;
  if (w == right.end() || (g != given.end() && *g < *w))
    return RoadmapFault{v, true, edge_text(roadmap, v, *g) + " does not belong there"};
  return RoadmapFault{v, true, edge_text(roadmap, v, *w) + " is missing"};
}

}  // namespace

std::optional<RoadmapFault> verify_roadmap(const Roadmap& roadmap, const FreeSpace& space) {
  for (Vertex v = 0; v < roadmap.vertex_count(); ++v)
    if (space.locate(roadmap.point(v)).kind != Location::Kind::triangle)
      return RoadmapFault{v, false, named(roadmap, v) + " lies in an obstacle or touches one"};
  for (Vertex v = 0; v < roadmap.vertex_count(); ++v)
    for (const Vertex w : roadmap.neighbours(v))
      if (w > v && !space.sees(roadmap.point(v), roadmap.point(w)))
        return RoadmapFault{v, true, edge_text(roadmap, v, w) + " leads through an obstacle"};
  return std::nullopt;
}

std::optional<RoadmapFault> difference(const Roadmap& roadmap, const Roadmap& wanted) {
  const auto at =
      std::mismatch(roadmap.points().begin(), roadmap.points().end(), wanted.points().begin(), wanted.points().end())
          .first;
  const auto first = static_cast<Vertex>(at - roadmap.points().begin());
  if (first < roadmap.vertex_count())
    return RoadmapFault{first, false, named(roadmap, first) + " does not belong there"};
  if (first < wanted.vertex_count()) return RoadmapFault{first, false, named(wanted, first) + " is missing"};
  for (Vertex v = 0; v < roadmap.vertex_count(); ++v)
    if (auto fault = row_difference(roadmap, wanted, v)) return fault;
  return std::nullopt;
}

}  // namespace taut
