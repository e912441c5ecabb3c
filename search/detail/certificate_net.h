// A reduced visibility graph with the ends of a query, in integers. Private.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/lattice_integers.h>
#include <taut/roadmaps/visibility_graph.h>
#include <taut/search/shortest_path.h>

namespace taut::detail {

/// A world's places in integers, so fine that ends and places where an edge meets the goal's border are among them.
class CertificatePlaces {
 public:
  using Place = LatticeIntegers::Place;

  /// `goal` is a room, or a point as a box. Throws InputError as LatticeIntegers does.
  CertificatePlaces(const World& world, Point from, const Box& goal);

  /// Are places that fine below LatticeIntegers::kLargest? The rest asks for that.
  bool fits() const { return factor_ != 0; }
  std::int64_t scale() const { return integers_.scale() * factor_; }
  double per_one() const { return integers_.per_one() * static_cast<double>(factor_); }
  double unit() const { return integers_.lattice().unit() / static_cast<double>(scale()); }

  std::optional<Place> exactly(Point p) const;
  Place nearest(Point p) const;  ///< of a crossing of sloped walls with the border, which no doubles may be
  const std::array<Place, 2>& goal() const { return goal_; }

 private:
  LatticeIntegers integers_;
  std::int64_t factor_ = 1;
  std::array<Place, 2> goal_{};  // two corners of the box
};

/// Vertices of the graph, then the start, then the places where the goal can be reached.
class CertificateNet {
 public:
  using Place = LatticeIntegers::Place;
  using Vertex = Roadmap::Vertex;

  CertificateNet(const VisibilityGraph& graph, const CertificatePlaces& places, Point from, const Goal& to);

  bool is_exact() const { return is_exact_; }  ///< all corners are places
  Vertex start() const { return static_cast<Vertex>(graph_.vertex_count()); }
  bool is_goal(Vertex v) const { return v > start(); }
  Place place(Vertex v) const { return places_[v]; }
  std::size_t size() const { return places_.size(); }

  template <class Visit>
  void each_leg(Vertex v, Visit&& visit) const {
    if (is_goal(v)) return;
    if (v == start())
      for (const Vertex w : query_.start.vertices) visit(w);
    else
      for (const Vertex w : graph_.neighbours(v)) visit(w);
    for (const Vertex w : goals_[v]) visit(w);
  }

 private:
  const Roadmap& graph_;
  GraphQuery query_;
  std::vector<std::vector<Vertex>> goals_;  // by vertex, those that it sees
  std::vector<Place> places_;
  bool is_exact_ = true;
};

/// The box that the goal is; nothing where a room is no rectangle.
std::optional<Box> goal_box(const Goal& goal);

}  // namespace taut::detail
