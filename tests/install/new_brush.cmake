# Projects of `burin new` against the installed component plugin: every kind compiles without a warning by each
# compiler and standard, and one is built, validated and tested as its README says.
#   BURIN_BUILD, BURIN_CONFIG   the build to install, below WORK
#   BURIN_COMMAND               the program burin
#   SAMPLES                     samples/ of the sources, for a stroke and a mesh
#   C_COMPILERS, CXX_COMPILERS  those of them that are there
#   GENERATOR
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BURIN_BUILD} --config ${BURIN_CONFIG} --prefix ${WORK}/prefix --component plugin)

# new(NAME OPTION...): writes a project and appends its source to sources_c or sources_cpp.
function(new name)
  run(${BURIN_COMMAND} new ${WORK}/${name} ${ARGN} OUTPUT_QUIET)
  foreach(language c cpp)
    if(EXISTS ${WORK}/${name}/${name}.${language})
      set(sources_${language} ${sources_${language}} ${WORK}/${name}/${name}.${language} PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

new(plain)
# The SDK has a class Stamp.
new(stamp)
new(tiled --features tile)
new(painted --features paint)
new(solid --features volume)
new(tiled_and_painted --features tile,paint)
new(all_features --features tile,paint,volume)
new(plain_c --c)
new(painted_c --c --features paint)
new(tiled_c --c --features tile)
new(solid_c --c --features volume)
new(tiled_and_painted_c --c --features tile,paint)
new(all_c --c --features tile,paint,volume)

# compile(LANGUAGE COMPILER STANDARD...): all sources of the language.
set(compiled 0)
function(compile language compiler)
  find_program(found_${compiler} ${compiler})
  if(NOT found_${compiler})
    message("new_brush: no ${compiler} here")
    return()
  endif()
  foreach(standard ${ARGN})
    run(${found_${compiler}} -std=${standard} -fsyntax-only -Wall -Wextra -Wpedantic -Werror -I${WORK}/prefix/include
      ${sources_${language}})
  endforeach()
  math(EXPR compiled "${compiled} + 1")
  set(compiled ${compiled} PARENT_SCOPE)
endfunction()

foreach(compiler ${C_COMPILERS})
  compile(c ${compiler} c11 c17)
endforeach()
foreach(compiler ${CXX_COMPILERS})
  compile(cpp ${compiler} c++20 c++2b)
endforeach()
if(compiled LESS 2)
  message(FATAL_ERROR "new_brush: nothing was compiled")
endif()

# A brush in C and the same in C++ draw the same: positions and colours of all vertices have the same bits.
list(GET C_COMPILERS 0 c_compiler)
list(GET CXX_COMPILERS 0 cxx_compiler)
# draw(NAME COMPILER LANGUAGE OPTION...): NAME.ply, the surface with the solids beside it.
function(draw name compiler language)
  set(file ${WORK}/${name}/${name})
  run(${compiler} -O2 -ffp-contract=off -fPIC -shared -I${WORK}/prefix/include ${file}.${language} -o ${file}.burin -lm ${ARGN})
  set(solid "")
  if(name MATCHES "solid|all")
    set(solid --solid separate --voxel 0.02)
  endif()
  run(${BURIN_COMMAND} replay ${SAMPLES}/strokes/meander.stroke --mesh ${SAMPLES}/meshes/ewer.obj --subdivide 3
    --brush ${file}.burin ${solid} --save-mesh ${WORK}/${name}.ply OUTPUT_QUIET)
  file(SHA256 ${WORK}/${name}.ply hash)
  set(drawn_${name} ${hash} PARENT_SCOPE)
endfunction()
set(all_drawn "")
foreach(pair plain/plain_c tiled/tiled_c painted/painted_c tiled_and_painted/tiled_and_painted_c solid/solid_c
    all_features/all_c)
  get_filename_component(cpp ${pair} DIRECTORY)
  get_filename_component(c ${pair} NAME)
  draw(${cpp} ${cxx_compiler} cpp -std=c++20)
  draw(${c} ${c_compiler} c)
  if(NOT drawn_${cpp} STREQUAL drawn_${c})
    message(FATAL_ERROR "new_brush: ${cpp} and ${c} draw different things")
  endif()
  list(APPEND all_drawn ${drawn_${c}})
endforeach()
list(REMOVE_DUPLICATES all_drawn)
list(LENGTH all_drawn count)
if(NOT count EQUAL 5)  # both solids are the same rod
  message(FATAL_ERROR "new_brush: some features draw nothing")
endif()
foreach(source ${sources_c} ${sources_cpp})
  file(READ ${source} text)
  if(NOT text MATCHES "rim_slope = 1.125f")
    message(FATAL_ERROR "new_brush: ${source} states no rim_slope")
  endif()
endforeach()

# As builds without CMake do.
find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${WORK}/prefix/share/pkgconfig
    ${PKG_CONFIG} --cflags burin-plugin OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${c_compiler} ${flags} -O2 -fPIC -shared ${WORK}/plain_c/plain_c.c -o ${WORK}/plain_c/plain_c.burin -lm)
  run(${BURIN_COMMAND} validate ${WORK}/plain_c/plain_c.burin --level 1 --quiet)
  # module.h does so for brushes in C.
  execute_process(COMMAND ${BURIN_COMMAND} validate ${WORK}/plain_c/plain_c.burin --only life.outside-values
    OUTPUT_VARIABLE outside COMMAND_ERROR_IS_FATAL ANY)
  if(NOT outside MATCHES "begin refuses them")
    message(FATAL_ERROR "new_brush: values outside of their ranges: ${outside}")
  endif()
endif()
set(ENV{CC} ${c_compiler})
set(ENV{CXX} ${cxx_compiler})

# A module with two brushes, a stroke of each.
file(MAKE_DIRECTORY ${WORK}/pair)
file(READ ${WORK}/plain/plain.cpp one)
string(REGEX REPLACE "BURIN_PLUGIN.*" "" one "${one}")
string(REGEX REPLACE ".*using namespace [a-z:]+;" "" two "${one}")
string(REPLACE "PlainPlugin" "OtherPlugin" two "${two}")
string(REPLACE "org.example.plain" "org.example.other" two "${two}")
file(WRITE ${WORK}/pair/pair.cpp "${one}${two}BURIN_PLUGIN(PlainPlugin, OtherPlugin);\n")
file(WRITE ${WORK}/pair/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)\nproject(pair LANGUAGES CXX)\n\
find_package(Burin REQUIRED COMPONENTS plugin)\nburin_add_brush(pair pair.cpp)\nenable_testing()\n\
burin_test_brush(pair BRUSHES org.example.plain org.example.other PARAMS height=0.5)\n")
run(${CMAKE_COMMAND} -S ${WORK}/pair -B ${WORK}/pair/build -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_PREFIX_PATH=${WORK}/prefix -DBURIN_PROGRAM=${BURIN_COMMAND})
run(${CMAKE_COMMAND} --build ${WORK}/pair/build)
run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/pair/build --no-tests=error --output-on-failure)
file(READ ${WORK}/pair/build/CTestTestfile.cmake tests)
if(NOT tests MATCHES "\"validate\" [^\n]*\"--param=height=0.5\"" OR NOT tests MATCHES "\"try\" [^\n]*\"--param=height=0.5\"")
  message(FATAL_ERROR "new_brush: tests without the parameters that they are to have: ${tests}")
endif()
foreach(id plain other)
  if(NOT EXISTS ${WORK}/pair/build/org.example.${id}.png)
    message(FATAL_ERROR "new_brush: no stroke of ${id}")
  endif()
endforeach()
foreach(name all_features all_c)
  set(build ${WORK}/${name}/build)
  run(${CMAKE_COMMAND} --preset release -S ${WORK}/${name} -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${WORK}/prefix
    -DBURIN_PROGRAM=${BURIN_COMMAND} WORKING_DIRECTORY ${WORK}/${name})
  run(${CMAKE_COMMAND} --build ${build})
  # Same bits whatever the processor, also in projects of C alone, and one symbol only.
  file(READ ${build}/compile_commands.json commands)
  if(NOT commands MATCHES "-ffp-contract=off" OR NOT commands MATCHES "-fvisibility=hidden")
    message(FATAL_ERROR "new_brush: flags of ${name}: ${commands}")
  endif()
  run(${CMAKE_CTEST_COMMAND} --test-dir ${build} --no-tests=error --output-on-failure)
  run(${CMAKE_COMMAND} --install ${build} --prefix ${WORK}/installed)
  if(NOT EXISTS ${build}/${name}.png OR NOT EXISTS ${WORK}/installed/lib/burin/brushes/${name}.burin)
    message(FATAL_ERROR "new_brush: ${name} drew no picture or is not installed")
  endif()
endforeach()
