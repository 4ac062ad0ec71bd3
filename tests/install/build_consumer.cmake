# Installs the component plugin of the build BURIN_BUILD below WORK, then configures and builds the project SOURCE
# against nothing else.
file(REMOVE_RECURSE ${WORK})
set(warnings "-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror")
set(without_packages "")
foreach(package Eigen3 TBB fmt nlohmann_json OpenImageIO CLI11)
  list(APPEND without_packages -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install ${BURIN_BUILD} --config ${BURIN_CONFIG} --prefix ${WORK}/prefix --component plugin)
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR} ${without_packages}
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_PREFIX_PATH=${WORK}/prefix
  "-DCMAKE_CXX_FLAGS=${warnings}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
