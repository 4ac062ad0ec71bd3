# libburin-dev depends on burin-dev: it must not have the files that both components install.
file(GLOB_RECURSE shared RELATIVE ${CPACK_TEMPORARY_DIRECTORY}/burin-dev ${CPACK_TEMPORARY_DIRECTORY}/burin-dev/usr/*)
list(TRANSFORM shared PREPEND ${CPACK_TEMPORARY_DIRECTORY}/libburin-dev/)
file(REMOVE ${shared})
