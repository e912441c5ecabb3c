# taut_flags: how every target of this project is compiled. Nothing of it reaches a user's targets.
add_library(taut_flags INTERFACE)

target_compile_options(taut_flags INTERFACE
  -ffp-contract=off  # a fused multiply-add would change what filtered predicates have bounded
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-qual -Wextra-semi -Wimplicit-fallthrough
  $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond -Wlogical-op>
  # GCC 12 sees overlaps and overflows in std::string where there are none (its bugs 105329 and 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow>
  $<$<BOOL:${TAUT_WERROR}>:-Werror>)

target_compile_definitions(taut_flags INTERFACE
  # CGAL drops its preconditions when NDEBUG is defined, and then NaN or a repeated vertex is a crash or a wrong answer instead of an
  # exception. CGAL_DEBUG is CGAL's own switch to keep them in spite of NDEBUG (CGAL/assertions.h). It costs the predicates
  # nothing, a triangulation up to 1.4 times. CGAL's expensive checks stay off, and so do its warnings: they print.
  CGAL_DEBUG
  CGAL_NO_WARNINGS
  # Boost 1.74 announces its own use of its deprecated headers.
  BOOST_ALLOW_DEPRECATED_HEADERS=)

# ISO C++, no GNU dialect.
set(CMAKE_CXX_EXTENSIONS OFF)
