# The kinds of target in the house, so that each folder's CMakeLists.txt is a list of names.

add_library(burin_build_flags INTERFACE)
target_compile_options(burin_build_flags INTERFACE
  -Wall -Wextra -Wpedantic
  # In sources that are compiled together (burin_unite) locals may have the names of what other sources keep to themselves.
  $<IF:$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>,-Wshadow=local,-Wshadow>
  $<$<COMPILE_LANGUAGE:CXX>:-Wconversion -Wnon-virtual-dtor -Woverloaded-virtual>
  $<$<BOOL:${BURIN_WERROR}>:-Werror>
  # Same bits whatever the optimiser fuses or the machine offers.
  -ffp-contract=off)

set(BURIN_SANITIZE "" CACHE STRING "sanitizers for every target, as -fsanitize= takes them")
if(BURIN_SANITIZE)
  add_compile_options(-fsanitize=${BURIN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${BURIN_SANITIZE})
  # The stacks in reports need functions and lines. To describe variables, too, takes a fifth of the time to build.
  add_compile_options(-g1)
  # With sanitizers GCC sees uses of what is not initialised, and accesses past strings, where there are none (its
  # manual warns of it).
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    add_compile_options(-Wno-maybe-uninitialized -Wno-array-bounds)
  endif()
endif()

if(BURIN_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# Headers of others that many sources have, parsed once for all libraries, all tests, and so on. Not with a compiler
# launcher: a cache as ccache could not keep what is compiled with them, and such builds show which sources do not name
# all headers that they use.
# burin_precompile(NAME HEADER...): what targets of the same options take with burin_use_precompiled(TARGET NAME).
function(burin_precompile name)
  if(CMAKE_CXX_COMPILER_LAUNCHER OR CMAKE_DISABLE_PRECOMPILE_HEADERS)
    return()
  endif()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "")
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/${name}.cpp)
  target_compile_definitions(${name} PRIVATE $<TARGET_PROPERTY:burin_base,INTERFACE_COMPILE_DEFINITIONS>)
  target_link_libraries(${name} PRIVATE
    Eigen3::Eigen TBB::tbb fmt::fmt nlohmann_json::nlohmann_json burin_build_flags)
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()
# burin_precompile_for_tests(NAME HEADER...): the same for programs of tests.
function(burin_precompile_for_tests name)
  burin_precompile(${name} ${ARGN} <gtest/gtest.h> <iostream> <random> <set>)
  if(TARGET ${name})
    target_link_libraries(${name} PRIVATE GTest::gtest burin_test_flags)
    # As the sources of programs, not of libraries.
    set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(${name} PRIVATE ${CMAKE_CXX_COMPILE_OPTIONS_PIE})
  endif()
endfunction()
function(burin_use_precompiled target name)
  if(TARGET ${name})
    target_precompile_headers(${target} REUSE_FROM ${name})
    # A source that does not use {fmt} must have its macros too, else the compiler refuses the headers.
    target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
    # The headers fill more memory than GCC would use before it collects garbage, which costs a tenth of its time.
    target_compile_options(${target} PRIVATE
      $<$<COMPILE_LANG_AND_ID:CXX,GNU>:SHELL:--param ggc-min-heapsize=1000000>)
  endif()
endfunction()
# burin_batch(GROUP MOST SOURCE...): what burin_unite compiles together of these, so many at a time.
function(burin_batch group most)
  set(count 0)
  foreach(source ${ARGN})
    math(EXPR batch "${count} / ${most}")
    math(EXPR count "${count} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group}_${batch})
  endforeach()
endfunction()
# burin_unite(TARGET): compiles the sources of each room of the target together, up to eight at a time, which takes about
# half the time: they share templates of others that each would instantiate. So names without linkage are unique in
# a room. A room's batches do not change with other rooms. As with precompiled headers, builds with a compiler launcher
# and clang-tidy look at each source by itself.
function(burin_unite target)
  if(CMAKE_CXX_COMPILER_LAUNCHER OR CMAKE_DISABLE_PRECOMPILE_HEADERS)
    return()
  endif()
  set(rooms "")
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    get_source_file_property(group ${source} UNITY_GROUP)
    if(NOT group)
      cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
      cmake_path(GET path PARENT_PATH room)
      cmake_path(RELATIVE_PATH room BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
      string(MAKE_C_IDENTIFIER "${room}" room)
      list(APPEND rooms ${room})
      list(APPEND sources_${room} ${source})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES rooms)
  foreach(room ${rooms})
    burin_batch(${room} 8 ${sources_${room}})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # GCC takes a source that is included for a header, in which types without linkage would be a mistake. With more to
  # inline GCC 12 sees overflows of vectors where there are none. The address preset looks for real ones.
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage;-Wno-stringop-overflow>)
endfunction()
set(burin_common_headers
  <Eigen/Core> <Eigen/Geometry> <oneapi/tbb/parallel_for.h> <oneapi/tbb/parallel_sort.h> <fmt/format.h>
  <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <map> <memory> <optional> <span> <string> <vector>)
burin_precompile(burin_library_headers ${burin_common_headers})
# GCC instantiates much of nlohmann/json in each source whose precompiled headers have it, used or not, which takes twice
# as long as all the rest of a small source. Only where most sources use it is that less than to parse it.
set(burin_command_headers_list ${burin_common_headers} <nlohmann/json.hpp>)
burin_precompile(burin_command_headers ${burin_command_headers_list})

# It takes longer to compile a test than to run what is in it, so tests are optimised little. What they test and what
# they share (tests/support) is optimised in full. With sanitizers -O1 halves the time to compile a test.
add_library(burin_test_flags INTERFACE)
target_compile_options(burin_test_flags INTERFACE $<$<CONFIG:Release,RelWithDebInfo>:-O1>)
if(BURIN_TESTS)
  burin_precompile_for_tests(burin_test_headers ${burin_common_headers})
  burin_precompile_for_tests(burin_command_test_headers ${burin_command_headers_list})
endif()

# burin_use_openvdb(TARGET): for sources that include it. OpenVDB's templates hold data that the library and its
# users must share: hidden, each would have its own, and openvdb::initialize() would read what nobody has written.
# Headers that were compiled with hidden visibility can't serve sources of another one.
function(burin_use_openvdb target)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang>:-fvisibility=default>)
  set_target_properties(${target} PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)
  target_link_libraries(${target} PRIVATE OpenVDB::openvdb Imath::Imath)
endfunction()

# burin_interface_library(NAME LINK...): a folder of headers.
function(burin_interface_library name)
  add_library(burin_${name} INTERFACE)
  add_library(burin::${name} ALIAS burin_${name})
  set_target_properties(burin_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(burin_${name} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/sdk> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(burin_${name} INTERFACE ${ARGN})
  burin_install_library(${name})
endfunction()

# burin_library(NAME LINK (public) ... PRIVATE ...): a folder of the SDK, all its sources and those of its rooms.
function(burin_library name)
  cmake_parse_arguments(ARG "" "" "LINK;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
  add_library(burin_${name} STATIC ${sources})
  add_library(burin::${name} ALIAS burin_${name})
  set_target_properties(burin_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(burin_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/sdk> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(burin_${name} PUBLIC cxx_std_20)
  burin_use_precompiled(burin_${name} burin_library_headers)
  burin_unite(burin_${name})
  target_link_libraries(burin_${name} PUBLIC ${ARG_LINK} PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:burin_build_flags>)
  burin_install_library(${name})
endfunction()

# burin_brush_plugin(NAME): one source, one shared module that sees the plugin SDK only.
function(burin_brush_plugin name)
  burin_brush_module(burin_brush_${name} ${name}.cpp)
  target_link_libraries(burin_brush_${name} PRIVATE burin_build_flags)
  set_target_properties(burin_brush_${name} PROPERTIES
    OUTPUT_NAME ${name} LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin/brushes)
  add_dependencies(burin_brushes burin_brush_${name})
  burin_install_brush(burin_brush_${name})
endfunction()

# How long a test may run. With the address sanitizer tests of merged solids take minutes of processor time.
set(burin_test_seconds 300)
if(BURIN_SANITIZE)
  set(burin_test_seconds 1800)
endif()

# burin_test(NAME LINK ... [LABELS ...] [COST n] [PRECOMPILED name]): the *_test.cpp of the folder and its rooms as one
# GoogleTest program NAME_test, one CTest entry a test. CTest starts tests of higher cost (0 unless given) first: long
# ones belong there, so that none is left to run alone. The precompiled headers are burin_test_headers unless given.
function(burin_test folder)
  cmake_parse_arguments(ARG "" "COST;PRECOMPILED" "LINK;LABELS" ${ARGN})
  if(NOT ARG_COST)
    set(ARG_COST 0)
  endif()
  if(NOT ARG_PRECOMPILED)
    set(ARG_PRECOMPILED burin_test_headers)
  endif()
  set(name ${folder}_test)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *_test.cpp)
  add_executable(${name} ${sources})
  burin_use_precompiled(${name} ${ARG_PRECOMPILED})
  burin_unite(${name})
  if(TARGET ${ARG_PRECOMPILED})
    # GCC forgets that GoogleTest's macros are a system's when they come from precompiled headers, and warns of
    # an `if` before them.
    target_compile_options(${name} PRIVATE -Wno-dangling-else)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # GCC 12 sees accesses beyond a std::string's own characters where there are none, and whether it does depends on
    # the lengths of the paths above. The address preset looks for real ones.
    target_compile_options(${name} PRIVATE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow)
  endif()
  target_link_libraries(${name} PRIVATE
    ${ARG_LINK} burin_test_support GTest::gtest_main burin_build_flags burin_test_flags)
  add_dependencies(${name} burin_images)
  # A program that was not in memory may take longer to list its tests than the 5 seconds that CMake allows.
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 PROPERTIES
    TIMEOUT ${burin_test_seconds} COST ${ARG_COST} LABELS "${ARG_LABELS};${folder}")
endfunction()
