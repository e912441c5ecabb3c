// Proofs in integers of what discs can do: that none of a radius gets through, that none wider does.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <taut/geometry/lattice_integers.h>
#include <taut/geometry/point.h>
#include <taut/roadmaps/bezier.h>
#include <taut/search/disc_passage.h>

namespace taut {

/// A closed chain of pieces and gates between start and goal, and what is to be checked of it (docs/certificates.md).
/// All numbers are in LatticeIntegers' unit / scale of plain_world(gates.space()).
struct DiscCertificate {
  using Place = LatticeIntegers::Place;

  std::int64_t scale = 1;
  bool is_found = false;       ///< of the widest disc; else there is no way for one of diameter `width`
  std::vector<Place> path{};   ///< of the widest from start to goal; else only these
  std::vector<Place> chain{};  ///< one place: a wall that an end is so near to
  std::int64_t width = 0;      ///< widest: no gate is wider; none: each is narrower
  std::int64_t keeps = 0;      ///< widest: how far the path is from all walls at least
};

/// That no disc is wider than `widest`, and that the way, curves of a ClearancePath from s to g, serves it but for
/// about a billionth: it becomes legs, the finer the nearer to where a curve turns most. The foot of a gate is moved
/// along its wall to a fraction in 2^-k, the way's points to multiples of the fine unit. Nothing where rounding leaves
/// none. Throws InputError as LatticeIntegers does.
std::optional<DiscCertificate> widest_certificate(const Gates& gates, const WidestPassage& widest, Point s, Point g,
                                                  std::span<const Bezier> way);

/// That no disc of radius r gets from s to g, by disc_passage. Precondition: its status is none.
std::optional<DiscCertificate> narrow_certificate(const Gates& gates, const DiscPassage& passage, Point s, Point g,
                                                  double r);

}  // namespace taut
