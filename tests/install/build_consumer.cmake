# Installs the build BURIN_BUILD (or one COMPONENT of it) below WORK, then configures and builds the project
# SOURCE against nothing else, and runs its program RUN with ARGUMENTS if one is named.
file(REMOVE_RECURSE ${WORK})
set(warnings "-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror")

set(component "")
set(without_packages "")
if(COMPONENT)
  set(component --component ${COMPONENT})
endif()
if(COMPONENT STREQUAL plugin)
  foreach(package Eigen3 TBB fmt embree nlohmann_json OpenImageIO CLI11)
    list(APPEND without_packages -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
  endforeach()
endif()

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install ${BURIN_BUILD} --config ${BURIN_CONFIG} --prefix ${WORK}/prefix ${component})
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR} ${without_packages}
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_PREFIX_PATH=${WORK}/prefix
  "-DCMAKE_CXX_FLAGS=${warnings} ${CXX_FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
if(RUN)
  run(${WORK}/build/${RUN} ${ARGUMENTS})
endif()
