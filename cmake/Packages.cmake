# What `cpack -G DEB` makes, see ./dev package:
#   burin         the command, the stock brushes, samples of strokes, meshes and stamps
#   burin-dev     for authors of brushes: headers, CMake package and guide
#   libburin0     libburin.so.0, for programs that load it
#   libburin-dev  for applications that embed Burin: what programs in C are built with, and for C++ static libraries
#                 and more headers, beside burin-dev
#   python3-burin the Python package
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME burin)
set(CPACK_PACKAGE_VENDOR Burin)
set(CPACK_PACKAGE_CONTACT "Burin maintainers <maintainers@burin.invalid>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
# The build is up to date before it is packed.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
# Lintian wants it, whatever the mask of whom builds.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian/leave_out_shared_files.cmake)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${CPACK_PACKAGE_CONTACT})
set(CPACK_COMPONENTS_ALL command brushes plugin runtime library c python)

# Lintian wants copyright and changelog of each package. They are installed with packages only.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

# burin_deb(PACKAGE SECTION COMPONENTS c... DEPENDS "..." RECOMMENDS "..." SUMMARY "..." TEXT line...)
function(burin_deb package section)
  cmake_parse_arguments(ARG "" "DEPENDS;RECOMMENDS;SUMMARY" "COMPONENTS;TEXT" ${ARGN})
  set(doc ${PROJECT_BINARY_DIR}/debian/${package})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/debian/changelog.in ${doc}/changelog @ONLY)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/debian/copyright ${doc}/copyright COPYONLY)
  execute_process(COMMAND gzip -9nf ${doc}/changelog COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${doc}/changelog.gz ${doc}/copyright DESTINATION share/doc/${package}
    COMPONENT doc-${package} EXCLUDE_FROM_ALL)
  list(APPEND CPACK_COMPONENTS_ALL doc-${package})
  foreach(component ${ARG_COMPONENTS} doc-${package})
    string(TOUPPER ${component} name)
    set(CPACK_COMPONENT_${name}_GROUP ${package} PARENT_SCOPE)
  endforeach()
  string(TOUPPER ${package} name)
  set(CPACK_DEBIAN_${name}_PACKAGE_NAME ${package} PARENT_SCOPE)
  set(CPACK_DEBIAN_${name}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${name}_PACKAGE_DEPENDS "${ARG_DEPENDS}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${name}_PACKAGE_RECOMMENDS "${ARG_RECOMMENDS}" PARENT_SCOPE)
  list(JOIN ARG_TEXT "\n" text)
  set(CPACK_DEBIAN_${name}_DESCRIPTION "${ARG_SUMMARY}\n${text}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} PARENT_SCOPE)
endfunction()

burin_deb(burin graphics COMPONENTS command brushes
  RECOMMENDS "fonts-dejavu-core"
  SUMMARY "draws recorded pen strokes on surfaces with brush plugins"
  TEXT "The command burin replays recorded strokes on meshes with its stock"
       "brushes or with others, writes meshes, pictures and reports, and"
       "validates plugins of brushes.")
burin_deb(burin-dev devel COMPONENTS plugin
  RECOMMENDS "burin (= ${PROJECT_VERSION}), cmake, g++, ninja-build"
  SUMMARY "headers, CMake package and guide for authors of Burin brushes"
  TEXT "A brush is a pointwise function over the chart of a stroke, built as a"
       "module that hosts load. The headers are the C ABI between brushes and"
       "hosts, and a C++ layer over it. The guide begins with"
       "/usr/share/doc/burin-dev/guide/guide.md.")
burin_deb(libburin0 libs COMPONENTS library
  RECOMMENDS "burin (= ${PROJECT_VERSION})"
  SUMMARY "shared library of Burin, for programs that draw with its brushes"
  TEXT "A program gives its mesh and the samples of its pen to a session, and"
       "shows the vertices that the session reports as changed. The stock"
       "brushes are in the package burin.")
burin_deb(libburin-dev libdevel COMPONENTS runtime c
  DEPENDS "burin-dev (= ${PROJECT_VERSION}), libburin0 (= ${PROJECT_VERSION}), libeigen3-dev, libtbb-dev, libfmt-dev, libxxhash-dev"
  RECOMMENDS "libopenimageio-dev, libpng-dev, libtiff-dev, libfreetype-dev, libharfbuzz-dev, libosd-dev, libopenvdb-dev, libimath-dev"
  SUMMARY "libraries for applications that draw with Burin brushes"
  TEXT "An application gives its mesh and the samples of its pen to a session,"
       "and shows the vertices that the session reports as changed: in C by"
       "libburin.so, in C++ by static libraries.")
burin_deb(python3-burin python COMPONENTS python
  DEPENDS "python3 (>= 3.10), python3-numpy, libburin0 (= ${PROJECT_VERSION})"
  RECOMMENDS "burin (= ${PROJECT_VERSION})"
  SUMMARY "strokes on surfaces: Burin's brushes for Python"
  TEXT "A session takes a mesh as arrays of numpy and the samples of a pen,"
       "draws strokes with Burin's brushes, and shows what has changed as"
       "views. Brushes may be written in Python.")
set(CPACK_DEBIAN_PYTHON3-BURIN_PACKAGE_ARCHITECTURE all)
# They compile the package's files for the interpreters that are there, and remove what they have made.
set(CPACK_DEBIAN_PYTHON3-BURIN_PACKAGE_CONTROL_EXTRA
  ${CMAKE_CURRENT_LIST_DIR}/debian/python3-burin/postinst ${CMAKE_CURRENT_LIST_DIR}/debian/python3-burin/prerm)
foreach(package BURIN LIBBURIN0)
  set(CPACK_DEBIAN_${package}_PACKAGE_SHLIBDEPS ON)
endforeach()
# The package that programs depend on which are linked with libburin.so.0, and the call of ldconfig.
set(control ${PROJECT_BINARY_DIR}/debian/libburin0)
file(WRITE ${control}/shlibs "libburin 0 libburin0 (>= ${PROJECT_VERSION})\n")
file(WRITE ${control}/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBBURIN0_PACKAGE_CONTROL_EXTRA ${control}/shlibs ${control}/triggers)

include(CPack)
