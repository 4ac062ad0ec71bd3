# The sample application in C against the installed library: its hash must be that of `burin replay`. The prefix, the
# mesh and the hash are those of embed.cmake.
#   EMBED            the folder in which embed.cmake worked
#   C_COMPILER, GENERATOR   of the builds
#   SAMPLES, WORK    the samples, and a folder to work in
#   SANITIZE         flags of sanitizers, if the library has some
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
set(prefix ${EMBED}/prefix)
set(warnings -std=c11 -Wall -Wextra -Wpedantic -Werror ${SANITIZE})
set(source ${SAMPLES}/c_host/c_host.c)
file(READ ${EMBED}/hash expected)

# By hand, with the flags of pkg-config where it is, and by CMake in a project without C++.
file(GLOB_RECURSE pkgconfig ${prefix}/burin.pc)
get_filename_component(pkgconfig ${pkgconfig} DIRECTORY)
find_program(PKG_CONFIG pkg-config)
set(flags -I${prefix}/include -L${prefix}/lib -lburin)
if(PKG_CONFIG)
  set(ENV{PKG_CONFIG_PATH} ${pkgconfig})
  execute_process(COMMAND ${PKG_CONFIG} --cflags --libs burin OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
endif()
run(${C_COMPILER} ${warnings} ${source} ${flags} -Wl,-rpath,${prefix}/lib -o ${WORK}/by_hand)
list(JOIN warnings " " warnings)
run(${CMAKE_COMMAND} -S ${SAMPLES}/c_host -B ${WORK}/build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${prefix}
  -DCMAKE_C_COMPILER=${C_COMPILER} "-DCMAKE_C_FLAGS=${warnings}")
run(${CMAKE_COMMAND} --build ${WORK}/build)

execute_process(
  COMMAND ${WORK}/by_hand ${EMBED}/mesh.obj ${SAMPLES}/strokes/meander.stroke brush=org.burin.groove radius=0.18
    params=depth=0.18 params=width=0.3
  OUTPUT_VARIABLE hash OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
if(NOT hash STREQUAL expected)
  message(FATAL_ERROR "c_host: hash ${hash}, but replay has ${expected}")
endif()

# A stamp is an image, which the library reads with a module beside it.
run(${WORK}/build/c_host ${SAMPLES}/meshes/ewer.obj ${SAMPLES}/strokes/scale_band.stroke brush=org.burin.scales radius=0.2
  params=stamp=${SAMPLES}/stamps/scales.exr OUTPUT_QUIET)

# Where something is wrong it says what, and ends with 2.
execute_process(COMMAND ${WORK}/by_hand ${EMBED}/mesh.obj ${SAMPLES}/strokes/meander.stroke brush=org.burin.none radius=1
  RESULT_VARIABLE status ERROR_VARIABLE line)
if(NOT status EQUAL 2 OR NOT line MATCHES "^c_host: no brush 'org.burin.none'; there are: ")
  message(FATAL_ERROR "c_host: status ${status}: ${line}")
endif()
message("c_host: two programs, the hash ${expected}")
