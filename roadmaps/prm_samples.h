// Where the next vertex of a PRM might be.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <taut/geometry/draws.h>
#include <taut/roadmaps/prm.h>
#include <taut/roadmaps/prm_clear.h>

namespace taut {

/// The points of a lattice in a box, row by row; then those of the lattice with half the spacing that are not among
/// them, and so on.
class PrmLatticeWalk {
 public:
  /// Throws InputError when the first lattice has 2^32 points or more in the box.
  PrmLatticeWalk(const Box& box, const PrmLattice& lattice);

  std::size_t first_size() const { return first_size_; }
  Point next();

 private:
  void begin_level();
  bool advance();

  Box box_;
  PrmLattice lattice_;
  int level_ = 0;
  std::size_t first_size_ = 0;
  double first_i_ = 0, last_i_ = 0, last_j_ = 0, i_ = 0, j_ = 0;  // whole numbers
};

/// A sample that is clear, and where it is.
struct PrmSample {
  Point point;
  Location place;
};

/// The samples of PrmOptions, one after the other. The clear test must outlive it.
class PrmSamples {
 public:
  PrmSamples(const PrmClear& clear, const PrmOptions& options);

  /// How many there are when the options do not say.
  std::size_t default_count() const { return walk_ ? walk_->first_size() : 500; }
  /// A sample that is clear, or nothing: one that is not.
  std::optional<PrmSample> draw() {
    return draw([](Point) { return true; });
  }
  /// Likewise; nothing where it is not wanted, either.
  template <class Wanted>
  std::optional<PrmSample> draw(Wanted&& wanted) {
    const std::optional<Point> p = candidate();
    return p && wanted(*p) ? placed(*p) : std::nullopt;
  }

 private:
  std::optional<Point> candidate();
  std::optional<PrmSample> placed(Point p) const;
  Point uniform();
  Point sobol();
  Point in_box(double x, double y) const;  // of a share of its sides, 0 .. 1
  double normal();
  Point near(Point p);
  std::optional<Point> gaussian();
  std::optional<Point> bridge();
  std::optional<Point> medial();
  bool is_any_nearer(Point p, double distance) const;
  Point corner();

  const PrmClear& clear_;
  PrmSampler sampler_;
  Draws draws_;
  Box box_;
  double spread_;
  bool near_corner_ = false;
  std::uint32_t number_ = 0, flips_x_ = 0, flips_y_ = 0;  // of Sobol's sequence
  std::vector<Point> corners_;
  std::optional<PrmLatticeWalk> walk_;
};

}  // namespace taut
