# The packages of Debian: what is in them, and whether Lintian finds an error.
#   BURIN_BUILD   the build to pack, below WORK
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_CPACK_COMMAND} -G DEB --config ${BURIN_BUILD}/CPackConfig.cmake -B ${WORK}
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

# expect(PACKAGE FILE...): files that the package must have.
function(expect package)
  file(GLOB deb ${WORK}/${package}_*.deb)
  execute_process(COMMAND dpkg-deb --contents ${deb} OUTPUT_VARIABLE contents COMMAND_ERROR_IS_FATAL ANY)
  foreach(file ${ARGN})
    string(FIND "${contents}" "./usr/${file}\n" place)
    if(place EQUAL -1)
      message(FATAL_ERROR "packages: ${package} lacks ${file}; it has:\n${contents}")
    endif()
  endforeach()
  set(contents_of_${package} "${contents}" PARENT_SCOPE)
endfunction()

expect(burin bin/burin share/man/man1/burin.1.gz lib/burin/brushes/groove.burin
  lib/burin/burin-brush-process lib/burin/burin-images.so lib/burin/burin-solids.so share/burin/samples/strokes/wave.stroke share/burin/samples/meshes/ewer.obj
  share/burin/samples/stamps/scales.exr share/burin/samples/suites/everyday.json share/burin/samples/solids/rail.vdb)
expect(burin-dev include/burin/plugin/plugin.h include/burin/abi/plugin.h lib/cmake/Burin/BurinAddBrush.cmake
  share/pkgconfig/burin-plugin.pc share/doc/burin-dev/guide/guide.md share/doc/burin-dev/guide/chart.png)
expect(libburin0 lib/libburin.so.0.1.0)
expect(libburin-dev include/burin/host/session.h lib/libburin_host.a lib/cmake/Burin/Burin-runtime.cmake
  include/burin/host/c/burin.h lib/cmake/Burin/Burin-c.cmake lib/pkgconfig/burin.pc)
expect(python3-burin lib/python3/dist-packages/burin/session.py lib/python3/dist-packages/burin/py.typed
  lib/python3/dist-packages/burin-0.1.0.dist-info/METADATA)
if(contents_of_python3-burin MATCHES "pycache|\\.so")
  message(FATAL_ERROR "packages: python3-burin has files of one machine")
endif()
if(contents_of_libburin-dev MATCHES "abi/plugin\\.h")
  message(FATAL_ERROR "packages: a file is in burin-dev and in libburin-dev")
endif()

if(contents_of_libburin0 MATCHES "burin-(images|solids)")
  message(FATAL_ERROR "packages: a file is in burin and in libburin0")
endif()

# Links of the guide lead to what the packages hold.
foreach(package burin burin-dev libburin-dev)
  file(GLOB deb ${WORK}/${package}_*.deb)
  execute_process(COMMAND dpkg-deb -x ${deb} ${WORK}/unpacked COMMAND_ERROR_IS_FATAL ANY)
endforeach()
set(guide ${WORK}/unpacked/usr/share/doc/burin-dev/guide)
file(GLOB pages ${guide}/*.md)
set(links 0)
foreach(page ${pages})
  file(READ ${page} text)
  # Lists of CMake are not split within brackets.
  string(REPLACE "](" "link=" text "${text}")
  string(REGEX MATCHALL "link=[^)# ]+\\.(md|png|h)" found "${text}")
  foreach(link ${found})
    string(SUBSTRING "${link}" 5 -1 link)
    if(NOT EXISTS ${guide}/${link})
      message(FATAL_ERROR "packages: ${page} has a link to ${link}, which no package holds")
    endif()
    math(EXPR links "${links} + 1")
  endforeach()
endforeach()
if(links LESS 50)
  message(FATAL_ERROR "packages: ${links} links in the guide")
endif()

# Readers of the guide have neither the sources nor ./dev: every file that it names in backquotes is a header that the
# packages hold, and nothing else of the repository is there.
set(include ${WORK}/unpacked/usr/include)
set(names 0)
foreach(page ${pages})
  file(READ ${page} text)
  foreach(word "\\./dev" "build/release" "<!--" "sdk/burin" "(^|[^/])samples/" "host_stub/" "host_probe" "hosts/" "tests/" "CONTRIBUTING")
    if(text MATCHES "[^\n]*${word}[^\n]*")
      message(FATAL_ERROR "packages: ${page} tells readers without the sources: ${CMAKE_MATCH_0}")
    endif()
  endforeach()
  string(REGEX MATCHALL "`[a-z_0-9/]+/[a-z_0-9]+\\.(h|c|cpp|cmake|md|py|sh)`" found "${text}")
  foreach(name ${found})
    string(REPLACE "`" "" name "${name}")
    if(NOT EXISTS ${include}/${name} AND NOT EXISTS ${include}/burin/${name})
      message(FATAL_ERROR "packages: ${page} names ${name}, which no package holds")
    endif()
    math(EXPR names "${names} + 1")
  endforeach()
endforeach()
if(names LESS 20)
  message(FATAL_ERROR "packages: ${names} names of headers in the guide")
endif()

file(GLOB debs ${WORK}/*.deb)
execute_process(COMMAND lintian --allow-root --fail-on error ${debs} COMMAND_ERROR_IS_FATAL ANY)
