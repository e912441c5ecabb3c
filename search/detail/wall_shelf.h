// Walls, found by the line that they lie on. Private.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include <taut/geometry/world.h>

namespace taut::detail {

/// Walls that come and go, always in the same order for the same changes. What concerns an axis-parallel wall takes
/// O(log lines + walls on its line), of a sloped one O(sloped walls).
class WallShelf {
 public:
  void add(const Wall& wall);

  /// Takes the stretch out of each wall that it lies on; what is left of that stays. False when there is none.
  bool take_out(const Segment& stretch);

  /// Does an axis-parallel wall hold an axis-parallel stretch?
  bool holds(const Segment& stretch) const;

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  std::size_t sloped() const { return sloped_.size(); }  ///< how many are not axis-parallel
  std::size_t thick() const { return thick_; }           ///< how many have a thickness

  template <class Visit>
  void each(Visit&& visit) const {
    for (const auto* lines : {&upright_, &level_})
      for (const auto& line : *lines)
        for (const Wall& wall : line.second) visit(wall);
    for (const Wall& wall : sloped_) visit(wall);
  }

  void append_to(std::vector<Wall>& walls) const {
    each([&](const Wall& wall) { walls.push_back(wall); });
  }

 private:
  using Lines = std::map<double, std::vector<Wall>>;

  bool take_out(const Segment& stretch, std::vector<Wall>& walls);

  Lines upright_, level_;
  std::vector<Wall> sloped_;
  std::size_t size_ = 0, thick_ = 0;
};

}  // namespace taut::detail
