// What an index consists of: its image, and what follows from the world.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/detail/index_image.h>
#include <taut/search/detail/integer_world.h>

namespace taut::detail {

struct IndexParts {
  /// `ends` may be without edges.
  IndexParts(VisibilityGraph ends, std::span<const std::byte> image_bytes, std::shared_ptr<const void> image_keeper);

  /// A bend's place, and its labels in the image.
  struct Bend {
    IntegerPlaces::Place at{};
    std::uint32_t begin = 0, end = 0;
  };

  std::uint32_t bend_of(std::uint32_t label) const {
    std::uint32_t bend = bend_of_block[label / kBlock];
    while (bends[bend].end <= label) ++bend;
    return bend;
  }
  bool has_sights() const { return !image.sights_begin().empty(); }
  Point point(std::uint32_t bend) const { return graph.roadmap().point(bend); }

  static constexpr std::uint32_t kBlock = 64;

  VisibilityGraph graph;  // for what ends see where no lists tell
  std::optional<IntegerWorld> integers;
  std::vector<IntegerPlaces::Place> rays;  // ray_places
  std::span<const std::byte> bytes;
  std::shared_ptr<const void> keeper;
  IndexImage image;
  std::vector<Bend> bends;
  std::vector<std::uint32_t> bend_of_block;  // by label / kBlock: of its first label
};

}  // namespace taut::detail
