# burin_find_library(TARGET HEADER LIBRARY [REQUIRED]): an imported target for a library without a usable CMake
# configuration; without REQUIRED none where the library is not found. Used by the build and by the installed
# package.
function(burin_find_library target header library)
  if(TARGET ${target})
    return()
  endif()
  find_path(${library}_INCLUDE_DIR ${header} ${ARGN})
  find_library(${library}_LIBRARY ${library} ${ARGN})
  if(NOT ${library}_INCLUDE_DIR OR NOT ${library}_LIBRARY)
    return()
  endif()
  add_library(${target} UNKNOWN IMPORTED GLOBAL)
  set_target_properties(${target} PROPERTIES
    IMPORTED_LOCATION "${${library}_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${${library}_INCLUDE_DIR}")
endfunction()
