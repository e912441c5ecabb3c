// ContourPlaces on contours.
#pragma once

#include <cstdint>

#include <taut/robots/bug/bug.h>
#include <taut/robots/bug/detail/contours.h>
#include <taut/robots/bug/detail/heading.h>

namespace taut::bug::detail {

/// A place on a contour. Stations 2k and 2k + 1 are the tail of half-edge k and its inside.
struct ContourPlace {
  std::uint32_t contour = kNone;
  std::uint32_t station = 0;
  Stand stand;

  Contours::At edge() const { return {contour, station / 2}; }
  bool is_vertex() const { return station % 2 == 0; }
  friend bool operator==(const ContourPlace& a, const ContourPlace& b) {
    return a.contour == b.contour && a.station == b.station && a.stand.at == b.stand.at;
  }
};

/// The places of all contours. Left is the order of the half-edges, right the other way. Keeps references.
class ContourPlaces {
 public:
  ContourPlaces(const Triangulation& tri, const Contours& contours) : tri_(tri), contours_(contours) {}

  /// Precondition: the stand is on a side, or at a vertex whose sector is not full.
  ContourPlace at(const Stand& stand) const;
  ContourPlace vertex(Contours::At at) const;
  ContourPlace side(Contours::At at, ExactPoint x) const;
  /// Of the closed half-edge. Precondition: x is on it.
  ContourPlace on(Contours::At at, const ExactPoint& x) const;

  std::uint32_t stations(std::uint32_t contour) const {
    return 2 * static_cast<std::uint32_t>(contours_.edges(contour).size());
  }
  /// The station that is j steps after `from`.
  std::uint32_t station(const ContourPlace& from, std::uint32_t j, Turn turn) const {
    const std::uint32_t n = stations(from.contour);
    return (turn == Turn::left ? from.station + j : from.station + n - j) % n;
  }
  std::uint32_t steps(const ContourPlace& from, std::uint32_t to, Turn turn) const {
    const std::uint32_t n = stations(from.contour);
    return (turn == Turn::left ? to + n - from.station : from.station + n - to) % n;
  }
  /// The vertex after a place.
  ContourPlace next_vertex(const ContourPlace& from, Turn turn) const;
  /// The half-edge that leads on from a place.
  Contours::At ahead(const ContourPlace& from, Turn turn) const;
  /// Is b after a, going left along the half-edge that both are inside of?
  bool is_ahead(const ContourPlace& a, const ContourPlace& b) const;

  const Triangulation& tri() const { return tri_; }
  const Contours& contours() const { return contours_; }

 private:
  const Triangulation& tri_;
  const Contours& contours_;
};

}  // namespace taut::bug::detail
