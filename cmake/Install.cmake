# What `cmake --install` lays out, in components that stand alone:
#   plugin   headers, CMake package and guide for brush authors; needs no third-party package
#   runtime  headers, static libraries and CMake package for applications that embed Burin
#   library  libburin.so.0 and what it looks for beside itself, for programs that load it
#   c        its header, CMake package and pkg-config file, for those who build such programs
#   brushes  the stock brushes
#   python   the Python package over libburin.so.0
#   command  burin, and recorded strokes, meshes and stamps to try it with
include(CMakePackageConfigHelpers)
include(${CMAKE_CURRENT_LIST_DIR}/PublicHeaders.cmake)
set(BURIN_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/Burin)
# Not CMAKE_INSTALL_LIBDIR: the command looks here, beside the folder it lies in.
set(BURIN_BRUSHES_FOLDER lib/burin/brushes)

# The targets of an SDK folder are exported in one of six sets, which the CMake package loads one by one:
# `abi` is part of both components; `stamps`, `subdiv` and `solids` need packages that the others do not.
set(burin_set_of_abi abi)
set(burin_set_of_math abi)
set(burin_set_of_plugin plugin)
set(burin_set_of_stamp stamps)
set(burin_set_of_image_codec stamps)
set(burin_set_of_services stamps)
set(burin_set_of_subdiv subdiv)
set(burin_set_of_level_set solids)
set(burin_set_of_remesh solids)
set(burin_components_of_abi plugin runtime)
set(burin_components_of_plugin plugin)

# Folders of the command alone, whose packages applications need not have.
set(burin_not_installed ink)

# Library and headers of the SDK folder whose CMakeLists.txt is being read.
function(burin_install_library name)
  if(name IN_LIST burin_not_installed)
    return()
  endif()
  set(export_set runtime)
  if(burin_set_of_${name})
    set(export_set ${burin_set_of_${name}})
  endif()
  install(TARGETS burin_${name} EXPORT burin_${export_set} ARCHIVE COMPONENT runtime)
  if(NOT export_set MATCHES "^(abi|plugin)$")
    set(headers ${burin_public_headers})
    list(FILTER headers INCLUDE REGEX "^${name}/")
    list(TRANSFORM headers REPLACE "^${name}/" "")
    install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/burin/${name} COMPONENT runtime)
    return()
  endif()
  foreach(component ${burin_components_of_${export_set}})
    install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/burin/${name}
      COMPONENT ${component} FILES_MATCHING PATTERN "*.h")
  endforeach()
endfunction()

# libburin.so and what programs in C are built with.
function(burin_install_c_library)
  install(TARGETS burin_c EXPORT burin_c LIBRARY COMPONENT library NAMELINK_COMPONENT c)
  set(sdk ${PROJECT_SOURCE_DIR}/sdk/burin)
  set(include ${CMAKE_INSTALL_INCLUDEDIR}/burin)
  install(DIRECTORY ${sdk}/abi/ DESTINATION ${include}/abi COMPONENT c FILES_MATCHING PATTERN "*.h")
  install(FILES ${sdk}/host/recorder.h DESTINATION ${include}/host COMPONENT c)
  install(FILES ${sdk}/host/c/burin.h DESTINATION ${include}/host/c COMPONENT c)
  burin_install_pkgconfig(burin ${CMAKE_INSTALL_LIBDIR}/pkgconfig c)
endfunction()

# The Python package, where Debian's Python looks for packages, with what tells pip that it is there.
function(burin_install_python_package)
  set(folder lib/python3/dist-packages)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/hosts/python/burin DESTINATION ${folder} COMPONENT python
    FILES_MATCHING PATTERN "*.py" PATTERN py.typed PATTERN __pycache__ EXCLUDE PATTERN .mypy_cache EXCLUDE)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/python/METADATA
    CONTENT "Metadata-Version: 2.1\nName: burin\nVersion: ${PROJECT_VERSION}\nRequires-Dist: numpy\n")
  install(FILES ${PROJECT_BINARY_DIR}/python/METADATA DESTINATION ${folder}/burin-${PROJECT_VERSION}.dist-info COMPONENT python)
endfunction()

function(burin_install_brush target)
  install(TARGETS ${target} LIBRARY DESTINATION ${BURIN_BRUSHES_FOLDER} COMPONENT brushes)
endfunction()

# The command and the CMake package, once all targets are known.
function(burin_install_package)
  install(TARGETS burin RUNTIME COMPONENT command)
  burin_install_guide()
  burin_install_python_package()
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/BurinConfig.cmake.in ${PROJECT_BINARY_DIR}/BurinConfig.cmake
    INSTALL_DESTINATION ${BURIN_PACKAGE_FOLDER})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/BurinConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  foreach(component plugin runtime c)
    install(FILES ${PROJECT_BINARY_DIR}/BurinConfig.cmake ${PROJECT_BINARY_DIR}/BurinConfigVersion.cmake
      DESTINATION ${BURIN_PACKAGE_FOLDER} COMPONENT ${component})
    install(FILES ${PROJECT_BINARY_DIR}/include/burin/version.h
      DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/burin COMPONENT ${component})
  endforeach()
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/BurinAddBrush.cmake
    DESTINATION ${BURIN_PACKAGE_FOLDER} COMPONENT plugin)
  burin_install_pkgconfig(burin-plugin ${CMAKE_INSTALL_DATADIR}/pkgconfig plugin)
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/BurinFindLibrary.cmake
    DESTINATION ${BURIN_PACKAGE_FOLDER} COMPONENT runtime)
  burin_install_export(abi plugin)
  # CMake installs an export once only; this is the same file for the other components.
  foreach(component runtime c)
    install(CODE "
      file(GLOB_RECURSE exported \"${PROJECT_BINARY_DIR}/CMakeFiles/Export/*/Burin-abi.cmake\")
      file(INSTALL \${exported} DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${BURIN_PACKAGE_FOLDER}\")"
      COMPONENT ${component})
  endforeach()
  burin_install_export(plugin plugin)
  foreach(export_set runtime stamps subdiv solids)
    burin_install_export(${export_set} runtime)
  endforeach()
  burin_install_export(c c)
endfunction()

# The guide, and what its commands draw.
function(burin_install_guide)
  install(CODE "
    set(SOURCE \"${PROJECT_SOURCE_DIR}/docs\")
    set(WORK \"${PROJECT_BINARY_DIR}/guide\")
    set(FOLDER ${CMAKE_INSTALL_DATADIR}/doc/burin-dev/guide)
    include(\"${PROJECT_SOURCE_DIR}/cmake/InstalledGuide.cmake\")"
    COMPONENT plugin)
  foreach(kind meshes recordings solids stamps strokes suites)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/samples/${kind} DESTINATION ${CMAKE_INSTALL_DATADIR}/burin/samples COMPONENT command)
  endforeach()
endfunction()

# burin_install_pkgconfig(NAME FOLDER COMPONENT): for those who build without CMake.
function(burin_install_pkgconfig name folder component)
  file(RELATIVE_PATH BURIN_PREFIX_FROM_PKGCONFIG /${folder} /)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${folder} COMPONENT ${component})
endfunction()

function(burin_install_export export_set component)
  install(EXPORT burin_${export_set} NAMESPACE burin:: FILE Burin-${export_set}.cmake
    DESTINATION ${BURIN_PACKAGE_FOLDER} COMPONENT ${component})
endfunction()
