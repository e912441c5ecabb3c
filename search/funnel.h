// Pulling a path taut: the shortest path in a corridor of triangles.
#pragma once

#include <optional>

#include <taut/geometry/free_space.h>
#include <taut/search/corridor.h>
#include <taut/search/path.h>

namespace taut {

/// The shortest path from corridor.from to corridor.to that stays in the corridor's triangles, in their order.
///
///  1. It bends at vertices of the triangulation only, each time towards the side where the vertex is; points in a
///     straight line are left out.
///  2. Exact orientations throughout: it is the shortest path, and its length is exact.
///  3. Where it touches a vertex it turns within one sector: it never slips through a joint, and it may turn around the
///     free end of a wall.
/// O(triangles). Source: Lee, Preparata, "Euclidean shortest paths in the presence of rectilinear barriers" (1984);
/// Chazelle, "A theorem on polygon cutting with applications" (1982). Precondition: the guarantees of Corridor hold.
Path funnel(const Triangulation& tri, const Corridor& corridor);

/// The shortest path that `path` can be pulled into, its ends held fast: the shortest in its homotopy class (how it
/// winds around the obstacles). Where free space has no holes there is only one class, and this is the shortest path of
/// all.
///
///  1. Never longer than `path`, exactly; equally long iff `path` was taut. Pulling twice changes nothing.
///  2. verify() accepts it when it accepts `path`.
///  3. Clearance is given up: a taut path touches the corners that it bends around.
///  4. An end on a wall stays on the side of the wall that `path` comes from.
/// Nothing when `path` is no path in the space: that of corridor_of(). O(n) for n triangles passed or around vertices
/// touched.
std::optional<Path> shortened(const FreeSpace& space, const Path& path);

}  // namespace taut
