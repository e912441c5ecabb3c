# Who keeps integers and rationals of any length (geometry/exact/numbers.h): GMP, or Boost.Multiprecision where there is no GMP, as in
# a page. taut_cgal: CGAL with the same numbers. taut_numbers: what is linked for them.
if(TAUT_BOOST_NUMBERS)
  # CGAL's own target brings GMP and MPFR along. As in a page, it has neither, and its intervals do without directed rounding.
  add_library(taut_cgal_boost INTERFACE)
  target_include_directories(taut_cgal_boost SYSTEM INTERFACE ${CGAL_INCLUDE_DIRS})
  target_compile_definitions(taut_cgal_boost INTERFACE CGAL_DISABLE_GMP=1 CGAL_ALWAYS_ROUND_TO_NEAREST)
  set(taut_cgal taut_cgal_boost)
  set(taut_numbers)
else()
  set(taut_cgal CGAL::CGAL)
  set(taut_numbers gmpxx gmp)
endif()
