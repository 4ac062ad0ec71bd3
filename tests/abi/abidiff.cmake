# libabigail compares the headers with what they were when frozen/abi_1_3.xml was written: besides the layout the
# types of members and the arguments of functions.
#   C_COMPILER, ABIDIFF   programs
#   SOURCE                folder of this file
#   WORK                  folder for files
file(MAKE_DIRECTORY ${WORK})
set(library ${WORK}/every_struct.so)
execute_process(COMMAND ${C_COMPILER} -std=c11 -g -O0 -fPIC -shared -I${SOURCE}/../../sdk ${SOURCE}/every_struct.c
  -o ${library} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${ABIDIFF} ${SOURCE}/frozen/abi_1_3.xml ${library} RESULT_VARIABLE differs)
if(differs)
  message(FATAL_ERROR "abidiff: the ABI is not the frozen one; tests/abi/frozen/README.md says when that may be")
endif()
