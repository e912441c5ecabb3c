# Compiles a file that only includes HEADER (twice: guarded), as a user would, and looks at what it reaches.
#   cmake -DCOMPILER=... -DINCLUDE=include:build/include -DHEADER=geometry/point.h -DSCRATCH=dir [-DBRIDGE=ON] -P header_alone.cmake
cmake_minimum_required(VERSION 3.25)

string(MAKE_C_IDENTIFIER ${HEADER} name)
set(source ${SCRATCH}/${name}.cpp)
set(reached ${SCRATCH}/${name}.d)
file(WRITE ${source} "#include <taut/${HEADER}>\n#include <taut/${HEADER}>\n")
string(REPLACE ":" ";-I" include -I${INCLUDE})
execute_process(
  COMMAND ${COMPILER} -std=c++20 -Wall -Wextra -Wpedantic -Wshadow -Werror ${include} -MD -MF ${reached} -fsyntax-only
    ${source}
  ERROR_VARIABLE errors RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "<taut/${HEADER}> does not compile alone:\n${errors}")
endif()

file(READ ${reached} files)
string(REGEX REPLACE "[\\\\\n ]+" ";" files "${files}")
if(BRIDGE)  # to a library that the other headers keep out
  return()
endif()
foreach(file IN LISTS files)
  if(file MATCHES "/(CGAL|boost|Eigen|nlohmann|fmt|CLI)/|/gmp(xx)?\\.h$|/mpfr\\.h$")
    message(FATAL_ERROR "<taut/${HEADER}> reaches ${file}: keep it in the .cpp")
  endif()
  if(file MATCHES "/taut/.*/detail/")
    message(FATAL_ERROR "<taut/${HEADER}> reaches ${file}, which is not installed")
  endif()
endforeach()
