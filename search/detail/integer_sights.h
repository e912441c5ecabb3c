// Which bends a place sees along a tangent, found when it is asked.
#pragma once

#include <cstdint>
#include <vector>

#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/detail/bend_turns.h>
#include <taut/search/detail/integer_world.h>

namespace taut::detail {

/// Triangular expansion (Bungiu et al., 2014) on integer places. One thread at a time.
class IntegerSights {
 public:
  /// All outlive it.
  IntegerSights(const VisibilityGraph& graph, const IntegerWorld& world)
      : tri_(graph.space().triangulation()), graph_(graph), world_(world) {}

  /// Calls see(bend, turns) for them, `turns` being TurnBits of a string from the place; some of them several times.
  template <class See>
  void from(const PlaceAt& place, See&& see) {
    at_ = place.at;
    for (std::uint32_t i = 0; i < place.count; ++i) {
      const std::uint32_t t = place.triangles[i];
      for (int k = 0; k < 3; ++k) {
        look_at(t, k, see);
        const auto& corners = tri_.triangles[t];
        const Place right = to(corners[Triangulation::ccw(k)]), left = to(corners[Triangulation::cw(k)]);
        // Through the side that it lies on only the other triangle is seen, which holds it, too.
        if (IntegerPlaces::cross(right, left) > 0) enter(t, k, right, left);
      }
      while (!open_.empty()) spread(see);
    }
  }

 private:
  using Place = IntegerPlaces::Place;
  struct View {
    std::uint32_t triangle;
    int side;
    Place right, left;
  };

  Place to(std::uint32_t vertex) const { return IntegerPlaces::difference(world_.at(vertex), at_); }

  void enter(std::uint32_t t, int side, Place right, Place left) {
    if (!tri_.is_constrained(t, side) && tri_.neighbours[t][side] != kNone) open_.push_back({t, side, right, left});
  }

  template <class See>
  void spread(See& see) {
    const View view = open_.back();
    open_.pop_back();
    const std::uint32_t t = tri_.neighbours[view.triangle][view.side];
    const int corner = tri_.mirror(view.triangle, view.side);
    const Place apex = to(tri_.triangles[t][corner]);
    const std::int64_t from_right = IntegerPlaces::cross(view.right, apex),
                       from_left = IntegerPlaces::cross(apex, view.left);
    if (from_right >= 0 && from_left >= 0) look_at(t, corner, see);
    if (from_left > 0) enter(t, Triangulation::cw(corner), from_right >= 0 ? apex : view.right, view.left);
    if (from_right > 0) enter(t, Triangulation::ccw(corner), view.right, from_left >= 0 ? apex : view.left);
  }

  template <class See>
  void look_at(std::uint32_t t, int corner, See& see) {
    const std::uint32_t sector = tri_.sector_of[3 * std::size_t{t} + static_cast<std::size_t>(corner)];
    const std::uint32_t bend = sector == kNone ? kNone : graph_.vertex_of_sector(sector);
    if (bend == kNone) return;
    const Triangulation::Sector& s = tri_.sectors[sector];
    const Place at = world_.at(s.vertex);
    const int right = IntegerPlaces::side(at_, at, world_.at(s.right)),
              left = IntegerPlaces::side(at_, at, world_.at(s.left));
    const std::uint32_t turns =
        (right <= 0 && left <= 0 ? kMayTurnRight : 0u) | (right >= 0 && left >= 0 ? kMayTurnLeft : 0u);
    if (turns != 0) see(bend, turns);
  }

  const Triangulation& tri_;
  const VisibilityGraph& graph_;
  const IntegerWorld& world_;
  Place at_{};
  std::vector<View> open_;
};

}  // namespace taut::detail
