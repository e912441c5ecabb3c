// CGAL's segment Delaunay graph with what a Voronoi roadmap needs in it. Private; for one file, CGAL costs seconds.
#pragma once

#ifdef TAUT_BOOST_NUMBERS
#include <CGAL/MP_Float.h>
#else
#include <CGAL/Exact_rational.h>
#include <CGAL/Mpzf.h>
#endif
#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <taut/geometry/point.h>
#include <taut/geometry/triangulation.h>

namespace taut::detail {

using Kernel = CGAL::Simple_cartesian<double>;
/// What the filter cannot decide, numbers of any length do that know no division and no root: signs of a + b sqrt(c)
/// and the like, by squaring.
#if defined TAUT_BOOST_NUMBERS
using Exact = CGAL::Simple_cartesian<CGAL::MP_Float>;
#elif defined CGAL_HAS_MPZF
using Exact = CGAL::Simple_cartesian<CGAL::Mpzf>;
#else
using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
#endif
using FilteredTraits =
    CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<Kernel, CGAL::Field_with_sqrt_tag, Exact>;

/// A type of our own, so that what follows concerns nobody else's graphs. Two of the questions that are asked most need
/// no interval: every point is one that was given, and of most sites a coordinate tells that they are apart.
struct Traits : FilteredTraits {
  struct Equal_2 {
    using result_type = bool;
    bool operator()(const Site_2& p, const Site_2& q) const { return p.point() == q.point(); }
  };

  struct Arrangement_type_2 : FilteredTraits::Arrangement_type_2 {
    using Filtered = FilteredTraits::Arrangement_type_2;
    using result_type = Filtered::result_type;
    result_type operator()(const Site_2& s, const Site_2& t) const {
      const std::array p = ends_of(s), q = ends_of(t);
      for (int axis = 0; axis < 2; ++axis) {
        const auto [s0, s1] = std::minmax({p[0][axis], p[1][axis]});
        const auto [t0, t1] = std::minmax({q[0][axis], q[1][axis]});
        if (s1 < t0 || t1 < s0) return Arrangement_enum::DISJOINT;
      }
      return Filtered::operator()(s, t);
    }

   private:
    static std::array<Point_2, 2> ends_of(const Site_2& s) {
      if (s.is_point()) return {s.point(), s.point()};
      return {s.source(), s.target()};
    }
  };

  Equal_2 equal_2_object() const { return {}; }
  Arrangement_type_2 arrangement_type_2_object() const { return {}; }
};

/// A vertex or a face with room for a number.
template <class Base>
struct Numbered : Base {
  using Base::Base;
  template <class Structure>
  struct Rebind_TDS {
    using Other = Numbered<typename Base::template Rebind_TDS<Structure>::Other>;
  };

  std::uint32_t number = kNone;
};

using Storage = CGAL::Segment_Delaunay_graph_storage_traits_2<Traits>;
using Structure = CGAL::Triangulation_data_structure_2<Numbered<CGAL::Segment_Delaunay_graph_vertex_base_2<Storage>>,
                                                       Numbered<CGAL::Segment_Delaunay_graph_face_base_2<Traits>>>;
using Graph = CGAL::Segment_Delaunay_graph_2<Traits, Storage, Structure>;

/// Finds points by their coordinates.
class PointNumbers {
 public:
  explicit PointNumbers(const std::vector<Point>& points)
      : points_(points), slots_(std::bit_ceil(2 * points.size() + 1), kNone) {
    for (std::uint32_t i = 0; i < points.size(); ++i) slots_[slot_of(points[i])] = i;
  }

  std::uint32_t of(Point p) const { return slots_[slot_of(p)]; }

 private:
  /// The one that holds p, or the first free one behind.
  std::size_t slot_of(Point p) const {
    const auto bits = [](double v) { return std::bit_cast<std::uint64_t>(v + 0.0); };  // -0 equals 0
    std::uint64_t hash = bits(p.x) * 0x9e3779b97f4a7c15u;
    hash = (hash ^ (hash >> 29) ^ bits(p.y)) * 0xbf58476d1ce4e5b9u;
    std::size_t slot = (hash ^ (hash >> 32)) & (slots_.size() - 1);
    while (slots_[slot] != kNone && points_[slots_[slot]] != p) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  const std::vector<Point>& points_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace taut::detail

/// CGAL prints that pieces cross, and goes on without them.
template <>
inline void CGAL::Segment_Delaunay_graph_2<taut::detail::Traits, taut::detail::Storage,
                                           taut::detail::Structure>::print_error_message() const {
  throw std::logic_error("two pieces of a Voronoi diagram cross");
}
