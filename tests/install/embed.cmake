# The sample application against the installed runtime: its hash must be that of BURIN_COMMAND replay.
#   BURIN_BUILD, BURIN_CONFIG  the build to install, below WORK
#   COMPONENTS                 what of it to install
#   SOURCE, COMPILERS          built by each compiler that is there; each program of the build is run
#   SAMPLES, BRUSHES           the samples, and where the prefix has the stock brushes
#   GENERATOR, CXX_FLAGS       of the build
#   SUBDIVIDE                  how often the sample mesh is refined
# Leaves prefix, mesh.obj and hash, the text that programs must print.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
foreach(component ${COMPONENTS})
  run(${CMAKE_COMMAND} --install ${BURIN_BUILD} --config ${BURIN_CONFIG} --prefix ${WORK}/prefix
    --component ${component})
endforeach()

# A mesh of some fineness, and what the command makes of a stroke on it.
set(stroke ${SAMPLES}/strokes/meander.stroke)
run(${BURIN_COMMAND} replay ${stroke} --mesh ${SAMPLES}/meshes/ewer.obj --subdivide ${SUBDIVIDE} --save-mesh ${WORK}/mesh.obj
  --json OUTPUT_FILE ${WORK}/first.json)
execute_process(COMMAND ${BURIN_COMMAND} replay ${stroke} --mesh ${WORK}/mesh.obj --json
  OUTPUT_VARIABLE replayed COMMAND_ERROR_IS_FATAL ANY)
string(JSON expected GET ${replayed} result_hash)
file(WRITE ${WORK}/hash ${expected})

# Packages that the runtime does not need.
set(without "")
foreach(package OpenImageIO PNG TIFF Freetype nlohmann_json nanoflann CLI11)
  list(APPEND without -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()

set(programs 0)
foreach(compiler ${COMPILERS})
  find_program(found_${compiler} ${compiler})
  if(NOT found_${compiler})
    message("embed: no ${compiler} here")
    continue()
  endif()
  get_filename_component(name ${compiler} NAME)
  set(build ${WORK}/${name})
  run(${CMAKE_COMMAND} -S ${SOURCE} -B ${build} -G ${GENERATOR} ${without} -DCMAKE_PREFIX_PATH=${WORK}/prefix
    -DCMAKE_CXX_COMPILER=${found_${compiler}} -DEMBED=${SAMPLES}/embed/embed.cpp
    "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow -Werror ${CXX_FLAGS}")
  run(${CMAKE_COMMAND} --build ${build} --parallel 2)
  foreach(program embed debug checked optimised wide native)
    if(NOT EXISTS ${build}/${program})
      continue()
    endif()
    execute_process(
      COMMAND ${build}/${program} ${WORK}/mesh.obj ${stroke} ${WORK}/prefix/${BRUSHES} ${WORK}/${name}-${program}.ply
      OUTPUT_VARIABLE hash OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    if(NOT hash STREQUAL expected)
      message(FATAL_ERROR "embed: ${name}, ${program}: hash ${hash}, but replay has ${expected}")
    endif()
    math(EXPR programs "${programs} + 1")
  endforeach()
endforeach()
if(programs EQUAL 0)
  message(FATAL_ERROR "embed: no program ran")
endif()
message("embed: ${programs} programs, all with the hash ${expected}")
