# Writes the pages in docs/ as they are installed, when they are: links lead to the installed headers, commands and samples
# are the installed ones, and the pictures of samples are left out.
#   SOURCE   folder of the pages
#   WORK     folder for what is written
#   FOLDER   where they go, below the prefix
file(REMOVE_RECURSE ${WORK})
file(GLOB pages ${SOURCE}/*.md)
# It describes the repository.
list(FILTER pages EXCLUDE REGEX "/architecture\\.md$")
file(RELATIVE_PATH prefix /${FOLDER} /)
foreach(page ${pages})
  get_filename_component(name ${page} NAME)
  file(READ ${page} text)
  string(REGEX REPLACE "!\\[[^]]*\\]\\(\\.\\./samples/[^)]*\\)" "" text "${text}")
  string(REPLACE "](../sdk/" "](${prefix}include/" text "${text}")
  string(REPLACE "build/release/bin/brushes/" "${CMAKE_INSTALL_PREFIX}/lib/burin/brushes/" text "${text}")
  string(REPLACE "build/release/bin/" "" text "${text}")
  foreach(kind strokes meshes stamps)
    string(REGEX REPLACE "([ =`])samples/${kind}/" "\\1${CMAKE_INSTALL_PREFIX}/share/burin/samples/${kind}/" text "${text}")
  endforeach()
  file(WRITE ${WORK}/${name} "${text}")
endforeach()
file(GLOB installed ${WORK}/*.md ${SOURCE}/*.png)
file(INSTALL ${installed} DESTINATION ${CMAKE_INSTALL_PREFIX}/${FOLDER})
