# Builds the project SOURCE for Windows below WORK with the compilers CC and CXX, without optimisation, and looks at
# what its modules export.
#   BURIN, VERSION_FOLDER   as the project has them
#   OBJDUMP, GENERATOR
if(NOT CXX OR NOT CC OR NOT OBJDUMP)
  message("windows: skipped, there is no x86_64-w64-mingw32-g++-posix (Debian: g++-mingw-w64-x86-64-posix)")
  return()
endif()
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE} -B ${WORK} -DCMAKE_SYSTEM_NAME=Windows
  -DCMAKE_C_COMPILER=${CC} -DCMAKE_CXX_COMPILER=${CXX} -DBURIN=${BURIN}
  -DVERSION_FOLDER=${VERSION_FOLDER} -DHEADERS=${WORK}/headers COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK} --parallel 2 COMMAND_ERROR_IS_FATAL ANY)

file(GLOB modules ${WORK}/*.burin)
list(LENGTH modules count)
if(count LESS 18)
  message(FATAL_ERROR "windows: only ${count} modules were built")
endif()
foreach(module ${modules})
  execute_process(COMMAND ${OBJDUMP} -p ${module} OUTPUT_VARIABLE headers COMMAND_ERROR_IS_FATAL ANY)
  # The table ends with a blank line.
  string(REGEX MATCH "\\[Ordinal/Name Pointer\\] Table\n([^\n]+\n)+" exports "${headers}")
  if(NOT exports MATCHES "Table\n[^\n]*\\] burin_plugin\n$")
    message(FATAL_ERROR "windows: ${module} exports not burin_plugin alone but ${exports}")
  endif()
endforeach()
message("windows: ${count} modules export burin_plugin")
