# Installs the tool, the runtime and the CMake package for both, as two components: symplant (the tool and what it reads) and
# libsymplant-dev (what projects compile and link).
include(CMakePackageConfigHelpers)
set(tool COMPONENT symplant)
set(development COMPONENT libsymplant-dev)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/symplant)
set(targets symplant_tables symplant_engine symplant_plant symplant_condition symplant_fmi symplant_json symplant_share symplant_exec symplant_link symplant_trace symplant_why symplant_scenario symplant_program symplant_panel symplant_host symplant_runtime)
if(SYMPLANT_BUILD_GENERATOR)
  list(APPEND targets symplant)
endif()
install(
  TARGETS ${targets}
  EXPORT symplantTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} ${development}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ${development}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} ${tool})
install(EXPORT symplantTargets NAMESPACE symplant:: DESTINATION ${package_dir} ${development})
foreach(floor tables engine plant condition fmi json share exec link trace why scenario program panel host)
  install(
    DIRECTORY ${PROJECT_SOURCE_DIR}/runtime/${floor}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/symplant ${development}
    FILES_MATCHING
    PATTERN "*.hpp")
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/runtime/program.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/symplant ${development})
install(
  DIRECTORY ${PROJECT_SOURCE_DIR}/templates
  DESTINATION ${CMAKE_INSTALL_DATADIR}/symplant ${tool}
  PATTERN program EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/templates/program DESTINATION ${CMAKE_INSTALL_DATADIR}/symplant ${tool})
install(FILES ${PROJECT_SOURCE_DIR}/generator/description/plant.schema.json
              ${PROJECT_SOURCE_DIR}/generator/naming/naming.schema.json
              ${PROJECT_SOURCE_DIR}/generator/suite/suite.schema.json
              ${PROJECT_SOURCE_DIR}/generator/view/model.schema.json
              ${PROJECT_SOURCE_DIR}/runtime/scenario/scenario.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/symplant/schema ${tool})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/generator/naming/profiles DESTINATION ${CMAKE_INSTALL_DATADIR}/symplant/naming ${tool})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/symplant ${tool})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libsymplant-dev ${development})

# Manual pages and completion, which the tool writes after it is linked (generator/app).
if(TARGET symplant AND NOT CMAKE_CROSSCOMPILING)
  set(share ${PROJECT_BINARY_DIR}/share)
  install(DIRECTORY ${share}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR} ${tool})
  install(DIRECTORY ${share}/bash-completion ${share}/zsh DESTINATION ${CMAKE_INSTALL_DATADIR} ${tool})
endif()

get_target_property(link_libraries symplant_link LINK_LIBRARIES)
set(SYMPLANT_LINKS_OPEN62541 OFF)
if("open62541::open62541" IN_LIST link_libraries)
  set(SYMPLANT_LINKS_OPEN62541 ON)
  install(FILES generator/cmake/FindOpen62541.cmake DESTINATION ${package_dir} ${development})
endif()
configure_package_config_file(${PROJECT_SOURCE_DIR}/generator/cmake/symplantConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/symplantConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/symplantConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/symplantConfig.cmake ${PROJECT_BINARY_DIR}/symplantConfigVersion.cmake
              generator/cmake/SymplantAddPlant.cmake generator/cmake/SymplantAddProgram.cmake
              generator/cmake/SymplantAddFmu.cmake generator/cmake/fmi_exports.map DESTINATION ${package_dir} ${development})
