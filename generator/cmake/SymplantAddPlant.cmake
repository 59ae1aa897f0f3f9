# symplant_add_plant(TARGET PLANT list.csv [TEMPLATES folder])
#
# Generates the plant of a symbol list and makes two targets of it:
#   TARGET         an executable that takes the options of `symplant run`
#   TARGET_plant   a library with one factory function: #include "TARGET/plant_gen.hpp", then <namespace>::make_plant()
# The code is generated anew when the list, the templates or the tool change; a build without such a change does nothing.
function(symplant_add_plant TARGET)
  cmake_parse_arguments(ARG "" "PLANT;TEMPLATES" "" ${ARGN})
  if(NOT ARG_PLANT)
    message(FATAL_ERROR "symplant_add_plant(${TARGET}): say PLANT and a symbol list")
  endif()
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "symplant_add_plant(${TARGET}): `${ARG_UNPARSED_ARGUMENTS}` is not understood")
  endif()
  get_filename_component(list "${ARG_PLANT}" ABSOLUTE)
  set(include_dir "${CMAKE_CURRENT_BINARY_DIR}/${TARGET}.plant")
  set(folder "${include_dir}/${TARGET}")
  set(options "")
  if(ARG_TEMPLATES)
    get_filename_component(templates "${ARG_TEMPLATES}" ABSOLUTE)
    list(APPEND options --templates "${templates}")
  endif()

  add_custom_command(
    OUTPUT "${folder}/tables_gen.cpp"
    BYPRODUCTS "${folder}/main_gen.cpp" "${folder}/plant_gen.hpp" "${folder}/types_gen.hpp" "${folder}/devices_gen.hpp"
               "${folder}/CMakeLists.txt"
    COMMAND symplant::symplant generate "${list}" -o "${folder}" --depfile "${folder}/plant.d" ${options}
    COMMAND ${CMAKE_COMMAND} -E touch "${folder}/tables_gen.cpp"
    DEPENDS "${list}" symplant::symplant
    DEPFILE "${folder}/plant.d"
    COMMENT "Generating the plant ${TARGET} from ${ARG_PLANT}"
    VERBATIM)

  add_library(${TARGET}_plant STATIC "${folder}/tables_gen.cpp")
  target_include_directories(${TARGET}_plant PUBLIC "${include_dir}")
  target_link_libraries(${TARGET}_plant PUBLIC symplant::core)

  add_executable(${TARGET} "${folder}/main_gen.cpp")
  target_link_libraries(${TARGET} PRIVATE ${TARGET}_plant symplant::runtime)
endfunction()
