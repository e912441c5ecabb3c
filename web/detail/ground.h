// A world that is asked about again and again: what was made of it once is kept.
#pragma once

#include <memory>
#include <optional>

#include <taut/geometry/free_space.h>
#include <taut/geometry/world.h>
#include <taut/io/worlds/read_world.h>
#include <taut/roadmaps/gates.h>
#include <taut/roadmaps/tangent_graph.h>
#include <taut/search/no_path.h>
#include <taut/search/polyanya.h>

namespace taut::web {

class Ground {
 public:
  Ground(World world, ReadNotes notes);

  const World& world() const { return space_.world(); }
  const ReadNotes& notes() const { return notes_; }
  const FreeSpace& space() const { return space_; }

  // Each is made when it is first asked for; of tangent graphs the last radius' is kept.
  PolyanyaSearch& search();
  const Navmesh& mesh();
  const NoPath& no_path();
  const Gates& gates();
  const TangentGraph& tangents(double radius);

 private:
  const Polyanya& polyanya();

  FreeSpace space_;
  ReadNotes notes_;
  std::optional<Polyanya> polyanya_;
  std::optional<PolyanyaSearch> search_;
  std::unique_ptr<NoPath> no_path_;
  std::optional<Gates> gates_;
  std::optional<TangentGraph> tangents_;
};

/// Start, goal.
struct Ends {
  std::optional<Point> start;
  Goal goal;
};

/// Of a world that has none: places near two opposite corners, if there are any.
Ends ends_to_begin_with(const Ground& ground);

}  // namespace taut::web
