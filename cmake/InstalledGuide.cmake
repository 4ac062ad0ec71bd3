# Writes the pages in docs/ as they are installed, when they are: links lead to the installed headers, commands and samples
# are the installed ones, and what readers without the sources cannot use is left out: what stands between
# <!-- sources --> and <!-- /sources -->, names of headers and sources that are not installed, in brackets after what they
# have, the pictures of samples, and whole pages.
#   SOURCE   folder of the pages
#   WORK     folder for what is written
#   FOLDER   where they go, below the prefix
cmake_policy(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/PublicHeaders.cmake)
file(REMOVE_RECURSE ${WORK})
file(GLOB pages ${SOURCE}/*.md)
# The code, the add-on for Blender and the plugin that tests hosts are not installed.
list(FILTER pages EXCLUDE REGEX "/(architecture|blender|probe)\\.md$")
file(RELATIVE_PATH prefix /${FOLDER} /)

# leave_out_sources(VARIABLE): what is meant for readers with the sources.
function(leave_out_sources variable)
  set(text "${${variable}}")
  set(end_mark "<!-- /sources -->")
  string(LENGTH "${end_mark}" length)
  string(FIND "${text}" "<!-- sources -->" begin)
  while(NOT begin EQUAL -1)
    string(SUBSTRING "${text}" 0 ${begin} kept)
    string(SUBSTRING "${text}" ${begin} -1 rest)
    string(FIND "${rest}" "${end_mark}" end)
    if(end EQUAL -1)
      message(FATAL_ERROR "guide: ${page} does not end what is for readers with the sources")
    endif()
    math(EXPR end "${end} + ${length}")
    string(SUBSTRING "${rest}" ${end} -1 rest)
    set(text "${kept}${rest}")
    string(FIND "${text}" "<!-- sources -->" begin)
  endwhile()
  string(REGEX REPLACE "\n\n\n+" "\n\n" text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

# leave_out_names(VARIABLE): of files of the SDK's folders that are not installed.
function(leave_out_names variable)
  set(text "${${variable}}")
  string(REGEX MATCHALL " \\(`[a-z_0-9/]+\\.(h|cpp)`\\)" names "${text}")
  foreach(name ${names})
    string(REGEX REPLACE "^ .`((sdk/)?burin/)?|`.$" "" file "${name}")
    if(NOT file MATCHES "^(abi|math|plugin)/" AND NOT file IN_LIST burin_public_headers)
      string(REPLACE "${name}" "" text "${text}")
    endif()
  endforeach()
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

foreach(page ${pages})
  get_filename_component(name ${page} NAME)
  file(READ ${page} text)
  leave_out_sources(text)
  leave_out_names(text)
  string(REGEX REPLACE "!\\[[^]]*\\]\\(\\.\\./samples/[^)]*\\)" "" text "${text}")
  string(REPLACE "](../sdk/" "](${prefix}include/" text "${text}")
  string(REPLACE "`sdk/burin/" "`burin/" text "${text}")
  string(REPLACE "build/release/bin/brushes/" "${CMAKE_INSTALL_PREFIX}/lib/burin/brushes/" text "${text}")
  string(REPLACE "build/release/bin/" "" text "${text}")
  string(REGEX REPLACE "([ =`\"])samples/(meshes|recordings|solids|stamps|strokes|suites)"
    "\\1${CMAKE_INSTALL_PREFIX}/share/burin/samples/\\2" text "${text}")
  file(WRITE ${WORK}/${name} "${text}")
endforeach()
file(GLOB installed ${WORK}/*.md ${SOURCE}/*.png)
list(FILTER installed EXCLUDE REGEX "/(after|blender)\\.png$")
file(INSTALL ${installed} DESTINATION ${CMAKE_INSTALL_PREFIX}/${FOLDER})
