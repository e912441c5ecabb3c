# What a shared taut shows is decided by place, as for headers: what detail/ folders hold is private. Their sources are compiled with
# hidden symbols, and so are those whose header lies in detail/; of the rest exports.map keeps what is named taut::. A static taut is
# compiled alike, so both are made of the same objects.

# taut_hide_private_symbols(LIBRARY)
function(taut_hide_private_symbols library)
  get_target_property(sources ${library} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET source STEM name)
    if(source MATCHES "/detail/" OR (EXISTS ${folder}/detail/${name}.h AND NOT EXISTS ${folder}/${name}.h))
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS -fvisibility=hidden)
      if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
        # It refuses a precompiled header that was compiled with another visibility.
        set_property(SOURCE ${source} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
      endif()
    endif()
  endforeach()
  taut_keep_public_symbols(${library})
endfunction()

# taut_keep_public_symbols(LIBRARY): for whatever is linked as a shared library of taut's objects.
function(taut_keep_public_symbols library)
  get_target_property(type ${library} TYPE)
  if(type STREQUAL SHARED_LIBRARY)
    target_link_options(${library} PRIVATE -Wl,--version-script=${CMAKE_CURRENT_FUNCTION_LIST_DIR}/exports.map)
    set_property(TARGET ${library} APPEND PROPERTY LINK_DEPENDS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/exports.map)
  endif()
endfunction()
