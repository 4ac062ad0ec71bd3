# A brush that fails its validation against the installed component plugin: the build fails, the module stays, and the
# next build validates it again, with each generator.
#   BURIN_BUILD, BURIN_CONFIG   the build to install, below WORK
#   BURIN_COMMAND               the program burin
#   CXX_COMPILER
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BURIN_BUILD} --config ${BURIN_CONFIG} --prefix ${WORK}/prefix
  --component plugin OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${BURIN_COMMAND} new ${WORK}/ridge OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
set(source ${WORK}/ridge/ridge.cpp)
file(READ ${source} right)
string(REPLACE "up[i] =" "up[i] = 0.0f / 0.0f *" wrong "${right}")
if(wrong STREQUAL right)
  message(FATAL_ERROR "failed_validation: the brush could not be broken")
endif()

# build(RESULT TEXT): RESULT "passes" or "fails"; TEXT, a regular expression, must be in what the build says.
function(build result text)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} RESULT_VARIABLE status OUTPUT_VARIABLE output
    ERROR_VARIABLE output)
  set(is fails)
  if(status EQUAL 0)
    set(is passes)
  endif()
  if(NOT is STREQUAL result OR NOT output MATCHES "${text}")
    message(FATAL_ERROR "failed_validation: ${generator}: the build ${is}, not ${result} with '${text}':\n${output}")
  endif()
  if(NOT EXISTS ${build}/ridge.burin)
    message(FATAL_ERROR "failed_validation: ${generator}: there is no module:\n${output}")
  endif()
  set(said "${output}" PARENT_SCOPE)
endfunction()

find_program(MAKE_PROGRAM make)
set(generators Ninja)
if(MAKE_PROGRAM)
  list(APPEND generators "Unix Makefiles")
else()
  message("failed_validation: no make here")
endif()
foreach(generator ${generators})
  set(build ${WORK}/${generator})
  file(WRITE ${source} "${wrong}")
  execute_process(COMMAND ${CMAKE_COMMAND} -G ${generator} -S ${WORK}/ridge -B ${build} -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_PREFIX_PATH=${WORK}/prefix -DBURIN_PROGRAM=${BURIN_COMMAND}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  build(fails "FAIL .*writes -?nan to .up.")
  build(fails "FAIL .*writes -?nan to .up.")
  file(WRITE ${source} "${right}")
  build(passes "Validating ridge.* 0 failed")
  build(passes "")
  if(said MATCHES "0 failed")
    message(FATAL_ERROR "failed_validation: ${generator}: a module that has passed is validated again:\n${said}")
  endif()
endforeach()
