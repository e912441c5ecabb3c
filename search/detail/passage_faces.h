// The faces between constraints and gates. Private.
#pragma once

#include <taut/geometry/exact/numbers.h>

#include <cstdint>
#include <span>
#include <vector>

#include <taut/geometry/exact/exact_point.h>
#include <taut/roadmaps/gates.h>
#include <taut/search/detail/direction.h>

namespace taut::detail {

/// The plane graph of all constraints and gates, gates split where they cross openings, as half-edges: 2 e runs along
/// edge e, 2 e + 1 back. Faces are the closed walks along half-edges that keep the face to their left; a face's
/// boundary is one such walk, as walls and gates hang together (docs/passage-index.md).
class PassageFaces {
 public:
  /// A place inside a constraint where a gate ends, or crosses it.
  struct Stop {
    std::uint32_t constraint = kNone;
    std::uint32_t node = kNone;
    Point end;       ///< of walls: who stands upright here
    Rational along;  ///< of openings: (place - a) / (b - a)
  };
  /// A piece of a gate.
  struct Piece {
    std::uint32_t u = kNone, v = kNone;  ///< nodes
    std::uint32_t gate = kNone;
  };

  explicit PassageFaces(const Gates& gates);

  std::uint32_t face_count() const { return static_cast<std::uint32_t>(walk_.size()); }
  std::uint32_t edge_count() const { return static_cast<std::uint32_t>(to_.size() / 2); }
  std::uint32_t face(std::uint32_t half_edge) const { return face_[half_edge]; }
  /// The part of free space that the face is in; kNone: none.
  std::uint32_t component(std::uint32_t face) const { return component_[face]; }
  std::uint32_t next(std::uint32_t half_edge) const { return next_[half_edge]; }
  /// One half-edge of the face's boundary.
  std::uint32_t walk(std::uint32_t face) const { return walk_[face]; }
  Point from(std::uint32_t half_edge) const { return places_[to_[half_edge ^ 1]]; }

  /// The pieces of gates; piece i is edge first_gate_edge() + i.
  const std::vector<Piece>& pieces() const { return pieces_; }
  std::uint32_t first_gate_edge() const { return first_edge_.back(); }

  /// The face beside a wall, to the left of a -> b or the right, at p's foot on it.
  std::uint32_t beside_wall(std::uint32_t constraint, bool left, Point p) const;
  /// The face beside an opening, at `along` of it; where a gate meets it there, the one next to the direction.
  std::uint32_t beside_opening(std::uint32_t constraint, bool left, const Rational& along,
                               const Direction& outward) const;
  /// The face at a vertex, in a direction; on a gate, the one to its left.
  std::uint32_t at_vertex(std::uint32_t vertex, const Direction& outward) const { return at_node(vertex, outward); }

 private:
  struct Builder;

  std::uint32_t at_node(std::uint32_t node, const Direction& outward) const;
  std::uint32_t piece_face(std::uint32_t constraint, std::uint32_t piece, bool left) const {
    return face_[2 * (first_edge_[constraint] + piece) + (left ? 0 : 1)];
  }
  std::span<const Stop> stops(std::uint32_t constraint) const {
    return std::span(stops_).subspan(first_stop_[constraint], first_stop_[constraint + 1] - first_stop_[constraint]);
  }

  Gates gates_;
  std::vector<Point> places_;              // of nodes, rounded
  std::vector<Stop> stops_;                // by constraint, then along it
  std::vector<std::uint32_t> first_stop_;  // of each constraint
  std::vector<std::uint32_t> first_edge_;  // of each constraint; a piece each
  std::vector<Piece> pieces_;
  std::vector<Direction> directions_;  // of edges
  std::vector<std::uint32_t> to_;      // of half-edges
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> face_;
  std::vector<std::uint32_t> walk_;
  std::vector<std::uint32_t> component_;
  std::vector<std::uint32_t> first_around_;  // of each node
  std::vector<std::uint32_t> around_;        // half-edges that start there, counter-clockwise
};

}  // namespace taut::detail
