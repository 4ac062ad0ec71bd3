# find_package(Burin) where something is missing: says what, and how to get it.
#   BURIN_BUILD, BURIN_CONFIG  the build to install, below WORK
file(REMOVE_RECURSE ${WORK})
foreach(component plugin runtime library c)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${BURIN_BUILD} --config ${BURIN_CONFIG}
    --prefix ${WORK}/${component} --component ${component} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# expect(PREFIX COMPONENTS RESULT TEXT FLAG...): RESULT "found" or "missing"; TEXT must be in what CMake says.
function(expect prefix components result text)
  file(WRITE ${WORK}/project/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)\nproject(p LANGUAGES CXX)\n\
find_package(Burin REQUIRED COMPONENTS ${components})\nmessage(\"found\")\n")
  # What CMake found out about the compiler stays.
  file(REMOVE ${WORK}/project/build/CMakeCache.txt)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/project -B ${WORK}/project/build -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} "-DCMAKE_PREFIX_PATH=${prefix}" ${ARGN}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " words "${output}")
  string(FIND "${words}" "${text}" place)
  set(is missing)
  if(status EQUAL 0)
    set(is found)
  endif()
  if(NOT is STREQUAL result OR place EQUAL -1)
    message(FATAL_ERROR "find_package: ${components} in ${prefix} ${ARGN}: expected ${result}, '${text}'; is:\n${output}")
  endif()
endfunction()

expect("${WORK}/runtime" "runtime" found "found")
expect("${WORK}/runtime" "runtime stamps subdiv solids" found "found")
expect("${WORK}/c" "c" missing "Component c needs what was not found: libburin.so (component library, Debian: libburin0).")
file(COPY ${WORK}/library/ DESTINATION ${WORK}/c)
expect("${WORK}/c" "c" found "found" -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON)
expect("${WORK}/runtime" "c" missing "Component c is not installed in ${WORK}/runtime")
expect("${WORK}/plugin" "plugin" found "found" -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
expect("${WORK}/plugin;${WORK}/runtime" "runtime" missing
  "Component runtime is not installed in ${WORK}/plugin, the first prefix that has Burin; install it there: cmake --install BUILD --component runtime --prefix ${WORK}/plugin")
expect("${WORK}/runtime" "plugin" missing "Component plugin is not installed in ${WORK}/runtime")
expect("${WORK}/runtime" "brushes" missing "There is no component brushes: plugin, runtime, stamps, subdiv, solids or c.")
expect("${WORK}/runtime" "runtime" missing
  "Component runtime needs what was not found: fmt::fmt (Debian: libfmt-dev)."
  -DCMAKE_DISABLE_FIND_PACKAGE_fmt=ON)
expect("${WORK}/runtime" "runtime" found "found" -DCMAKE_DISABLE_FIND_PACKAGE_OpenImageIO=ON)
expect("${WORK}/runtime" "runtime" found "found" -DCMAKE_DISABLE_FIND_PACKAGE_Imath=ON)
expect("${WORK}/runtime" "solids" missing "Component solids needs what was not found: Imath::Imath (Debian: libimath-dev)."
  -DCMAKE_DISABLE_FIND_PACKAGE_Imath=ON)
expect("${WORK}/runtime" "stamps" missing
  "Component stamps needs what was not found: OpenImageIO::OpenImageIO (Debian: libopenimageio-dev)."
  -DCMAKE_DISABLE_FIND_PACKAGE_OpenImageIO=ON)
