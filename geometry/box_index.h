// Which boxes meet a box?
#pragma once

#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include <taut/geometry/box.h>
#include <taut/geometry/point.h>

namespace taut {

/// An immutable R-tree (Boost.Geometry, packed) over closed boxes; a plain list when they are few.
/// Built in O(n log n); a query takes O(log n + hits) on usual inputs.
class BoxIndex {
 public:
  explicit BoxIndex(std::vector<Box> boxes);
  ~BoxIndex();
  BoxIndex(BoxIndex&&) noexcept;
  BoxIndex& operator=(BoxIndex&&) noexcept;

  /// Calls visit(i) for every box i that shares a point with `box`, in no particular but a reproducible order.
  template <class Visit>
  void meeting(const Box& box, Visit&& visit) const {
    query(box, &visit, [](void* to, std::uint32_t i) { (*static_cast<std::remove_reference_t<Visit>*>(to))(i); });
  }

 private:
  void query(const Box& box, void* to, void (*call)(void*, std::uint32_t)) const;

  struct Tree;
  std::vector<Box> boxes_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace taut
