# Each header that the component runtime installs, compiled alone with nothing but the prefix and Eigen.
#   BURIN_BUILD, BURIN_CONFIG  the build to install, below WORK
#   EIGEN                      the folder of Eigen's headers
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BURIN_BUILD} --config ${BURIN_CONFIG} --prefix ${WORK}/prefix
  --component runtime OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE headers RELATIVE ${WORK}/prefix/include ${WORK}/prefix/include/burin/*.h)
list(LENGTH headers count)
if(count LESS 50)
  message(FATAL_ERROR "public_headers: only ${count} are installed")
endif()
set(sources "")
foreach(header ${headers})
  string(MAKE_C_IDENTIFIER ${header} name)
  file(WRITE ${WORK}/${name}.cpp "#include <${header}>\n")
  list(APPEND sources ${WORK}/${name}.cpp)
endforeach()
execute_process(COMMAND ${CXX_COMPILER} -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wshadow -Werror
  -I${WORK}/prefix/include -isystem ${EIGEN} ${sources} COMMAND_ERROR_IS_FATAL ANY)
