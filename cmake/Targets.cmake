# The kinds of target in the house, so that each folder's CMakeLists.txt is a list of names.

add_library(burin_build_flags INTERFACE)
target_compile_options(burin_build_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow
  $<$<COMPILE_LANGUAGE:CXX>:-Wconversion -Wnon-virtual-dtor -Woverloaded-virtual>
  $<$<BOOL:${BURIN_WERROR}>:-Werror>
  # Same bits whatever the optimiser fuses or the machine offers.
  -ffp-contract=off)

set(BURIN_SANITIZE "" CACHE STRING "sanitizers for every target, as -fsanitize= takes them")
if(BURIN_SANITIZE)
  add_compile_options(-fsanitize=${BURIN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${BURIN_SANITIZE})
  # With sanitizers GCC sees uses of what is not initialised where there are none (its manual warns of it).
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    add_compile_options(-Wno-maybe-uninitialized)
  endif()
endif()

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

# burin_library(NAME LINK (public) ... PRIVATE ...): a folder of the SDK, all its sources.
function(burin_library name)
  cmake_parse_arguments(ARG "" "" "LINK;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  add_library(burin_${name} STATIC ${sources})
  add_library(burin::${name} ALIAS burin_${name})
  set_target_properties(burin_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(burin_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/sdk> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(burin_${name} PUBLIC cxx_std_20)
  target_link_libraries(burin_${name} PUBLIC ${ARG_LINK} PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:burin_build_flags>)
  burin_install_library(${name})
endfunction()

# burin_brush_plugin(NAME): one source, one shared module that sees the plugin SDK only.
function(burin_brush_plugin name)
  burin_add_brush(burin_brush_${name} ${name}.cpp)
  target_link_libraries(burin_brush_${name} PRIVATE burin_build_flags)
  set_target_properties(burin_brush_${name} PROPERTIES
    OUTPUT_NAME ${name} LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin/brushes)
  add_dependencies(burin_brushes burin_brush_${name})
  burin_install_brush(burin_brush_${name})
endfunction()

# burin_test(NAME LINK ... [LABELS ...]): the folder's *_test.cpp as one GoogleTest program NAME_test, one
# CTest entry a test.
function(burin_test folder)
  cmake_parse_arguments(ARG "" "" "LINK;LABELS" ${ARGN})
  set(name ${folder}_test)
  file(GLOB sources CONFIGURE_DEPENDS *_test.cpp)
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} burin_test_support GTest::gtest_main burin_build_flags)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 300 LABELS "${ARG_LABELS};${folder}")
endfunction()
