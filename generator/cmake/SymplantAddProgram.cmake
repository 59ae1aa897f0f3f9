# symplant_add_program(TARGET FILES...)
#
# Makes a PLC program that runs in lock step with a plant: the shared library TARGET.so (TARGET.dll on Windows) of FILES, in C or C++, with
# <symplant/program.h> found. `symplant run PLANT --program TARGET.so` runs it. The project must have the languages of the
# files.
function(symplant_add_program TARGET)
  if(NOT ARGN)
    message(FATAL_ERROR "symplant_add_program(${TARGET}): give the files of the program")
  endif()
  add_library(${TARGET} MODULE ${ARGN})
  set_target_properties(${TARGET} PROPERTIES PREFIX "")
  target_include_directories(${TARGET} PRIVATE $<TARGET_PROPERTY:symplant::tables,INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()
