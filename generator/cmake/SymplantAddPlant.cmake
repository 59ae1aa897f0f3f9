# symplant_add_plant(TARGET PLANT plant.json [BEHAVIOURS folder] [LINK_DEFAULT url] [TEMPLATES folder])
#
# Generates the plant of a description, or of a symbol list, and makes two targets of it:
#   TARGET         an executable that takes the options of `symplant run`
#   TARGET_plant   a library with the plant's class: #include "TARGET/plant_gen.hpp", then <namespace>::Plant
# BEHAVIOURS is the folder of your custom classes for devices (NAME_behavior.hpp): they are compiled in, and missing
# ones are written there, once. A file formulas.hpp there replaces formulas. Without it all devices and formulas follow
# the model. LINK_DEFAULT is the link of a start without
# --link. The code is generated again when the description, its lists, the templates or the tool change; a build
# without such a change does nothing.
function(symplant_add_plant TARGET)
  cmake_parse_arguments(ARG "" "PLANT;BEHAVIOURS;LINK_DEFAULT;TEMPLATES" "" ${ARGN})
  if(NOT ARG_PLANT)
    message(FATAL_ERROR "symplant_add_plant(${TARGET}): PLANT is missing; give a plant.json or a symbol list")
  endif()
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "symplant_add_plant(${TARGET}): unknown arguments `${ARG_UNPARSED_ARGUMENTS}`")
  endif()
  get_filename_component(plant "${ARG_PLANT}" ABSOLUTE)
  set(include_dir "${CMAKE_CURRENT_BINARY_DIR}/${TARGET}.plant")
  set(folder "${include_dir}/${TARGET}")
  set(options "")
  if(ARG_TEMPLATES)
    get_filename_component(templates "${ARG_TEMPLATES}" ABSOLUTE)
    list(APPEND options --templates "${templates}")
  endif()
  if(ARG_BEHAVIOURS)
    get_filename_component(behaviours "${ARG_BEHAVIOURS}" ABSOLUTE)
    list(APPEND options --behaviours "${behaviours}")
  endif()

  add_custom_command(
    OUTPUT "${folder}/tables_gen.cpp"
    BYPRODUCTS "${folder}/main_gen.cpp" "${folder}/plant_gen.hpp" "${folder}/types_gen.hpp"
               "${folder}/formulas_gen.hpp" "${folder}/tables_gen.hpp" "${folder}/fmu_gen.cpp" "${folder}/CMakeLists.txt"
    COMMAND symplant::symplant generate "${plant}" -o "${folder}" --depfile "${folder}/plant.d" ${options}
    COMMAND ${CMAKE_COMMAND} -E touch "${folder}/tables_gen.cpp"
    DEPENDS "${plant}" symplant::symplant
    DEPFILE "${folder}/plant.d"
    COMMENT "Generating the plant ${TARGET} from ${ARG_PLANT}"
    VERBATIM)

  add_library(${TARGET}_plant STATIC "${folder}/tables_gen.cpp")
  target_include_directories(${TARGET}_plant PUBLIC "${include_dir}")
  target_link_libraries(${TARGET}_plant PUBLIC symplant::plant)
  # Formulas give the same bits everywhere: no fused operations.
  target_compile_options(${TARGET}_plant
                         PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-ffp-contract=off>)
  if(ARG_BEHAVIOURS)
    target_include_directories(${TARGET}_plant PRIVATE "${folder}" "${behaviours}")
    target_compile_definitions(${TARGET}_plant PRIVATE SYMPLANT_BEHAVIOURS)
    file(GLOB formulas CONFIGURE_DEPENDS "${behaviours}/formulas.hpp")
    if(formulas)
      target_compile_definitions(${TARGET}_plant PRIVATE SYMPLANT_FORMULAS)
    endif()
  endif()

  set_target_properties(${TARGET}_plant PROPERTIES SYMPLANT_PLANT_FILE "${plant}" SYMPLANT_PLANT_CODE "${folder}")

  add_executable(${TARGET} "${folder}/main_gen.cpp")
  target_link_libraries(${TARGET} PRIVATE ${TARGET}_plant symplant::runtime)
  if(ARG_LINK_DEFAULT)
    target_compile_definitions(${TARGET} PRIVATE "SYMPLANT_LINK_DEFAULT=\"${ARG_LINK_DEFAULT}\"")
  endif()
endfunction()
