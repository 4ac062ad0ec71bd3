# burin_add_brush(NAME SOURCE...): a brush plugin, the module NAME.burin. Put it into a folder that
# BURIN_PLUGIN_PATH names.
function(burin_add_brush name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE burin::plugin)
  # Same bits whatever the optimiser fuses.
  target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>)
  set_target_properties(${name} PROPERTIES
    PREFIX "" SUFFIX ".burin" C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden)
endfunction()
