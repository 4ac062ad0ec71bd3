# burin_add_brush(NAME SOURCE...): a brush plugin, the module NAME.burin. Put it into a folder that
# BURIN_PLUGIN_PATH names.
function(burin_add_brush name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE burin::plugin)
  set_target_properties(${name} PROPERTIES
    PREFIX "" SUFFIX ".burin" C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden)
endfunction()
