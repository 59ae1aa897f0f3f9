# symplant_add_fmu(TARGET PLANT target [OUTPUT file.fmu])
#
# Makes an FMU (FMI 2.0, co-simulation) of a plant that symplant_add_plant() made, with its custom behaviors and formulas compiled in.
# PLANT is the first argument of symplant_add_plant(). OUTPUT is the file; by default TARGET.fmu in the folder of the
# build. The FMU is for the platform of the build only. A plant without C++ of yours needs no compiler:
# `symplant generate plant.json --fmu plant.fmu`.
function(symplant_add_fmu TARGET)
  cmake_parse_arguments(ARG "" "PLANT;OUTPUT" "" ${ARGN})
  if(NOT TARGET ${ARG_PLANT}_plant)
    message(FATAL_ERROR "symplant_add_fmu(${TARGET}): PLANT `${ARG_PLANT}` is not a plant; give the target of symplant_add_plant()")
  endif()
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "symplant_add_fmu(${TARGET}): unknown arguments `${ARG_UNPARSED_ARGUMENTS}`")
  endif()
  if(NOT ARG_OUTPUT)
    set(ARG_OUTPUT ${TARGET}.fmu)
  endif()
  get_filename_component(fmu "${ARG_OUTPUT}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_BINARY_DIR}")
  get_target_property(plant_file ${ARG_PLANT}_plant SYMPLANT_PLANT_FILE)
  get_target_property(code ${ARG_PLANT}_plant SYMPLANT_PLANT_CODE)
  set_target_properties(${ARG_PLANT}_plant PROPERTIES POSITION_INDEPENDENT_CODE ON)

  add_library(${TARGET}_library MODULE "${code}/fmu_gen.cpp")
  target_link_libraries(${TARGET}_library PRIVATE ${ARG_PLANT}_plant)
  symplant_fmu_library(${TARGET}_library symplant::fmi)
  get_target_property(platform ${TARGET}_library SYMPLANT_FMI_PLATFORM)
  add_custom_command(
    OUTPUT "${fmu}"
    COMMAND symplant::symplant generate "${plant_file}" --fmu "${fmu}" --fmu-library "${platform}=$<TARGET_FILE:${TARGET}_library>"
    DEPENDS ${TARGET}_library "${code}/tables_gen.cpp" symplant::symplant
    COMMENT "Packing the FMU ${ARG_OUTPUT}"
    VERBATIM)
  add_custom_target(${TARGET} ALL DEPENDS "${fmu}")
endfunction()

# symplant_fmu_library(TARGET FMI): links a shared library that exports the functions of FMI, from the library FMI, and nothing else. Its
# property SYMPLANT_FMI_PLATFORM is its folder in an FMU. It needs the C library of its system, and no C++ library.
set(SYMPLANT_FMI_EXPORTS "${CMAKE_CURRENT_LIST_DIR}/fmi_exports.map")
function(symplant_fmu_library TARGET FMI)
  if(WIN32)
    set(platform win64)
  elseif(CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
    set(platform linux64)
  else()
    set(platform ${CMAKE_SYSTEM_PROCESSOR}-linux)
  endif()
  set_target_properties(${TARGET} PROPERTIES PREFIX "" SYMPLANT_FMI_PLATFORM ${platform})
  target_link_libraries(${TARGET} PRIVATE $<LINK_LIBRARY:WHOLE_ARCHIVE,${FMI}>)
  if(WIN32)
    target_link_options(${TARGET} PRIVATE -static)
  else()
    # With the system's libgcc, which every system has: a static one needs the C library of the build's system or a later one.
    target_link_options(${TARGET} PRIVATE -static-libstdc++ -Wl,--gc-sections $<$<CONFIG:Release,MinSizeRel>:-s>
                                                "-Wl,--version-script=${SYMPLANT_FMI_EXPORTS}")
    set_target_properties(${TARGET} PROPERTIES LINK_DEPENDS "${SYMPLANT_FMI_EXPORTS}")
  endif()
endfunction()
