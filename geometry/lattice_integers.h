// A world's coordinates as integers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include <taut/geometry/number_lattice.h>
#include <taut/geometry/point.h>
#include <taut/geometry/world.h>

namespace taut {

/// Points of a world as multiples of its lattice's unit, counted from (0, 0); and of a finer one, the unit / scale, of
/// which other places are multiples too.
class LatticeIntegers {
 public:
  using Place = std::array<std::int64_t, 2>;

  /// Multiples stay below this.
  static constexpr std::int64_t kLargest = std::int64_t{1} << 51;

  /// `scale` is the least with which all of `places` are multiples. Throws InputError where the world lies on no
  /// lattice, or a place on none as fine.
  explicit LatticeIntegers(const World& world, std::span<const Point> places = {});

  const NumberLattice& lattice() const { return lattice_; }
  std::int64_t scale() const { return scale_; }
  /// How many units / scale make 1, to the nearest double.
  double per_one() const;

  /// What the point means as multiples of unit / scale; nothing when it is none.
  std::optional<Place> place(Point p) const;

 private:
  std::optional<std::int64_t> integer(double v) const;

  NumberLattice lattice_;
  std::int64_t scale_ = 1;
};

}  // namespace taut
