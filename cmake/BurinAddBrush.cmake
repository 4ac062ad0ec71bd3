# For authors of brushes:
#
#   burin_add_brush(NAME SOURCE... [VALIDATE LEVEL|OFF])
#     The module NAME.burin. A build of all targets tests it by `burin validate` up to LEVEL, 2 unless given, if the
#     program is there (BURIN_PROGRAM). Where that fails so does the build; the module stays, to look at it, and the next
#     build tests it again. `cmake --install` puts it into lib/burin/brushes: hosts of the same prefix find it there,
#     others if BURIN_PLUGIN_PATH names the folder.
#   burin_test_brush(NAME [BRUSHES ID...] [PARAMS ID=VALUE...])
#     Tests for CTest: `burin validate` and one stroke by `burin try`, both with these parameters. BRUSHES names the
#     brushes of a module that has several; there is a stroke for each.

# burin_brush_module(NAME SOURCE...): the module alone, as the stock brushes are built.
function(burin_brush_module name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE burin::plugin)
  # Same bits whatever the optimiser fuses.
  foreach(language C CXX)
    target_compile_options(${name} PRIVATE
      $<$<COMPILE_LANG_AND_ID:${language},GNU,Clang,AppleClang>:-ffp-contract=off>)
  endforeach()
  # Systems never unload a module with unique symbols, which g++ makes of std::to_string() and the like.
  target_compile_options(${name} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-gnu-unique>)
  # Compilers of C leave square roots of negative numbers to the library.
  if(UNIX)
    target_link_libraries(${name} PRIVATE $<$<LINK_LANGUAGE:C>:m>)
  endif()
  set_target_properties(${name} PROPERTIES
    PREFIX "" SUFFIX ".burin" C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden)
endfunction()

function(burin_add_brush name)
  cmake_parse_arguments(ARG "" "VALIDATE" "" ${ARGN})
  burin_brush_module(${name} ${ARG_UNPARSED_ARGUMENTS})
  install(TARGETS ${name} LIBRARY DESTINATION lib/burin/brushes)
  if(NOT DEFINED ARG_VALIDATE)
    set(ARG_VALIDATE 2)
  endif()
  if(NOT ARG_VALIDATE)
    return()
  elseif(NOT BURIN_PROGRAM)
    message(STATUS "Burin: without the program burin, ${name} is not validated")
  elseif(NOT CMAKE_CROSSCOMPILING)
    burin_validate_brush(${name} ${ARG_VALIDATE})
  endif()
endfunction()

# burin_validate_brush(NAME LEVEL): a file beside the module is made when it has passed. As a step of the module's own
# build a failure would let make delete the module.
function(burin_validate_brush name level)
  set(passed ${CMAKE_CURRENT_BINARY_DIR}/${name}.validated-${level}$<CONFIG>)
  add_custom_command(OUTPUT ${passed} DEPENDS ${name} VERBATIM COMMENT "Validating ${name}"
    COMMAND ${BURIN_PROGRAM} validate $<TARGET_FILE:${name}> --level ${level} --quiet
    COMMAND ${CMAKE_COMMAND} -E touch ${passed})
  add_custom_target(${name}_validated ALL DEPENDS ${passed})
endfunction()

function(burin_test_brush name)
  cmake_parse_arguments(ARG "" "" "BRUSHES;PARAMS" ${ARGN})
  list(TRANSFORM ARG_PARAMS PREPEND --param=)
  if(NOT BURIN_PROGRAM)
    message(STATUS "Burin: without the program burin, ${name} is not tested")
    return()
  endif()
  add_test(NAME ${name}.validate COMMAND ${BURIN_PROGRAM} validate $<TARGET_FILE:${name}> --quiet ${ARG_PARAMS})
  if(NOT ARG_BRUSHES)
    add_test(NAME ${name}.try COMMAND ${BURIN_PROGRAM} try $<TARGET_FILE:${name}> --png ${name}.png ${ARG_PARAMS})
  endif()
  foreach(brush ${ARG_BRUSHES})
    add_test(NAME ${name}.try.${brush}
      COMMAND ${BURIN_PROGRAM} try $<TARGET_FILE:${name}>:${brush} --png ${brush}.png ${ARG_PARAMS})
  endforeach()
endfunction()
