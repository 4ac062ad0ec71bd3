# What `cmake --install` lays out, in components that stand alone:
#   plugin   headers and CMake package for brush authors; needs no third-party package
#   runtime  headers and static libraries for applications that embed Burin
#   brushes  the stock brushes
#   command  burin
include(CMakePackageConfigHelpers)
set(BURIN_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/Burin)
# Not CMAKE_INSTALL_LIBDIR: the command looks here, beside the folder it lies in.
set(BURIN_BRUSHES_FOLDER lib/burin/brushes)

# Library and headers of the SDK folder whose CMakeLists.txt is being read.
function(burin_install_library name)
  set(component runtime)
  if(name MATCHES "^(abi|math|plugin)$")
    set(component plugin)
  endif()
  install(TARGETS burin_${name} EXPORT burin_${component} ARCHIVE COMPONENT ${component})
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/burin/${name}
    COMPONENT ${component} FILES_MATCHING PATTERN "*.h")
endfunction()

function(burin_install_brush target)
  install(TARGETS ${target} LIBRARY DESTINATION ${BURIN_BRUSHES_FOLDER} COMPONENT brushes)
endfunction()

# The command and the CMake package, once all targets are known.
function(burin_install_package)
  install(TARGETS burin RUNTIME COMPONENT command)
  foreach(component plugin runtime)
    install(EXPORT burin_${component} NAMESPACE burin:: FILE Burin-${component}.cmake
      DESTINATION ${BURIN_PACKAGE_FOLDER} COMPONENT ${component})
  endforeach()
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/BurinConfig.cmake.in ${PROJECT_BINARY_DIR}/BurinConfig.cmake
    INSTALL_DESTINATION ${BURIN_PACKAGE_FOLDER})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/BurinConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/BurinConfig.cmake ${PROJECT_BINARY_DIR}/BurinConfigVersion.cmake
    ${PROJECT_SOURCE_DIR}/cmake/BurinAddBrush.cmake
    DESTINATION ${BURIN_PACKAGE_FOLDER} COMPONENT plugin)
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/BurinFindLibrary.cmake
    DESTINATION ${BURIN_PACKAGE_FOLDER} COMPONENT runtime)
endfunction()
