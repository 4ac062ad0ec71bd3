# leave_out(PACKAGE OTHER): a package that depends on or recommends another must not have the files that components of
# both install.
function(leave_out package other)
  set(folder ${CPACK_TEMPORARY_DIRECTORY}/${other})
  file(GLOB_RECURSE shared RELATIVE ${folder} ${folder}/usr/*)
  list(TRANSFORM shared PREPEND ${CPACK_TEMPORARY_DIRECTORY}/${package}/)
  file(REMOVE ${shared})
endfunction()
leave_out(libburin-dev burin-dev)
leave_out(libburin0 burin)
