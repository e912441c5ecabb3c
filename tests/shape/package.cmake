# Installs the build tree to a scratch prefix, then configures, builds and runs a project that knows nothing but that prefix.
cmake_minimum_required(VERSION 3.25)
function(run what)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what} failed:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
run("install" ${CMAKE_COMMAND} --install ${BUILD_TREE} --prefix ${SCRATCH}/prefix)

if(EXISTS ${SCRATCH}/prefix/bin/taut)
  run("the installed program" ${SCRATCH}/prefix/bin/taut --version)
endif()

file(GLOB_RECURSE private ${SCRATCH}/prefix/include/*.h)
list(FILTER private INCLUDE REGEX "/detail/")
if(private)
  message(FATAL_ERROR "private headers were installed: ${private}")
endif()
file(GLOB_RECURSE exported ${SCRATCH}/prefix/*.cmake)
foreach(file IN LISTS exported)
  file(READ ${file} text)
  string(FIND "${text}" "${BUILD_TREE}" leak)
  if(NOT leak EQUAL -1)
    message(FATAL_ERROR "${file} names the build tree")
  endif()
endforeach()

run("configuring the consumer" ${CMAKE_COMMAND} -S ${CONSUMER} -B ${SCRATCH}/build -G ${GENERATOR}
  -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}"
  -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DTAUT_EXPECTED_VERSION=${VERSION})
run("building the consumer" ${CMAKE_COMMAND} --build ${SCRATCH}/build)
run("running the consumer" ${SCRATCH}/build/consumer)

# The project of examples, on the same prefix.
run("configuring the examples" ${CMAKE_COMMAND} -S ${CONSUMER}/../../examples -B ${SCRATCH}/examples -G ${GENERATOR}
  -DCMAKE_PREFIX_PATH=${SCRATCH}/prefix -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}"
  -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DCMAKE_DISABLE_FIND_PACKAGE_ompl=ON)
run("building the examples" ${CMAKE_COMMAND} --build ${SCRATCH}/examples)
set(maze ${CONSUMER}/../../data/maze_25x25.txt)
run("the example solve" ${SCRATCH}/examples/solve ${maze})
run("the example batch" sh -c "echo 0.5 0.5 3.5 6.5 | ${SCRATCH}/examples/batch ${maze}")
run("the example micromouse_robot" ${SCRATCH}/examples/micromouse_robot ${CONSUMER}/../../data/mouse_12.cells)
run("the example disc" ${SCRATCH}/examples/disc ${maze} 0.2)
run("the example spanning_tree" ${SCRATCH}/examples/spanning_tree ${maze})

# The same without CMake, as a page of any tutorial has it. Only where the prefix stands is told.
find_program(PKG_CONFIG NAMES pkg-config pkgconf)
if(NOT PKG_CONFIG)
  message(FATAL_ERROR "no pkg-config: it is one of the packages in cmake/debian-packages.txt")
endif()
file(GLOB sources ${CONSUMER}/*.cpp)
file(GLOB_RECURSE description ${SCRATCH}/prefix/*/taut.pc)
cmake_path(GET description PARENT_PATH descriptions)
cmake_path(GET descriptions PARENT_PATH libraries)
set(ENV{PKG_CONFIG_PATH} ${descriptions})
set(ENV{LD_LIBRARY_PATH} ${libraries}:$ENV{LD_LIBRARY_PATH})
list(JOIN sources " " sources)
run("building with pkg-config" sh -c
  "${COMPILER} ${FLAGS} ${sources} $(${PKG_CONFIG} --cflags --libs taut) -o ${SCRATCH}/by_pkg_config")
run("running what pkg-config built" ${SCRATCH}/by_pkg_config)
run("asking pkg-config for the version" ${PKG_CONFIG} --exact-version=${VERSION} taut)
