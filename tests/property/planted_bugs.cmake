# Layers with planted bugs: copies of their sources in which a variable of the program switches one of the bugs on.
#
# symplant_planted_bug(LAYER NAME FROM TO): the text FROM, which occurs once in the layer, is TO in the copy. In TO the
# word BUG is replaced by the condition that this bug is on. If it is off, TO must do the same as FROM.
function(symplant_planted_bug LAYER NAME FROM TO)
  get_property(names DIRECTORY PROPERTY symplant_planted_bugs)
  list(APPEND names ${NAME})
  list(LENGTH names number)
  set_property(DIRECTORY PROPERTY symplant_planted_bugs ${names})
  set_property(DIRECTORY APPEND PROPERTY symplant_planted_in_${LAYER} ${number})
  file(CONFIGURE OUTPUT planted/${number}.from CONTENT "@FROM@" @ONLY)
  file(CONFIGURE OUTPUT planted/${number}.to CONTENT "@TO@" @ONLY)
endfunction()

# symplant_planted_layer(LAYER FOLDER): the object library symplant_LAYER_planted, all sources of the layer with its bugs.
# A program that contains its objects does not use those of the layer's library.
function(symplant_planted_layer LAYER FOLDER)
  set(copy ${CMAKE_CURRENT_BINARY_DIR}/planted/${LAYER})
  set(script ${PROJECT_SOURCE_DIR}/tests/property/plant_bugs.cmake)
  get_property(numbers DIRECTORY PROPERTY symplant_planted_in_${LAYER})
  get_target_property(sources symplant_${LAYER} SOURCES)
  set(files "")
  set(originals "")
  set(copies "")
  set(others "")
  set(texts "")
  foreach(source ${sources})
    if(IS_ABSOLUTE ${source})
      list(APPEND others ${source})
      continue()
    endif()
    list(APPEND files ${source})
    list(APPEND originals ${FOLDER}/${source})
    list(APPEND copies ${copy}/${source})
    get_source_file_property(alone ${FOLDER}/${source} TARGET_DIRECTORY symplant_${LAYER} SKIP_UNITY_BUILD_INCLUSION)
    if(alone)
      set_source_files_properties(${copy}/${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
  foreach(number ${numbers})
    list(APPEND texts ${CMAKE_CURRENT_BINARY_DIR}/planted/${number}.from ${CMAKE_CURRENT_BINARY_DIR}/planted/${number}.to)
  endforeach()
  string(REPLACE ";" "," numbers "${numbers}")
  string(REPLACE ";" "," files "${files}")
  add_custom_command(
    OUTPUT ${copies}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${FOLDER} -DCOPY=${copy} -DBUGS=${CMAKE_CURRENT_BINARY_DIR}/planted
            "-DFILES=${files}" "-DNUMBERS=${numbers}" -P ${script}
    DEPENDS ${originals} ${texts} ${script}
    VERBATIM)
  add_library(symplant_${LAYER}_planted OBJECT ${copies} ${others})
  add_dependencies(symplant_${LAYER}_planted symplant_${LAYER})
  target_include_directories(symplant_${LAYER}_planted PRIVATE $<TARGET_PROPERTY:symplant_${LAYER},INCLUDE_DIRECTORIES>)
  target_compile_options(symplant_${LAYER}_planted PRIVATE $<TARGET_PROPERTY:symplant_${LAYER},COMPILE_OPTIONS>)
  target_link_libraries(symplant_${LAYER}_planted PRIVATE symplant_options)
endfunction()

# symplant_planted_tests(PROGRAM PREFIX PLANTS): a test for each planted bug: PROGRAM must find it in this number of plants. If none
# is on it must find nothing. SYMPLANT_FIRST_PLANT_OF_NAME: where to begin, for a bug that few plants show.
function(symplant_planted_tests PROGRAM PREFIX PLANTS)
  get_property(names DIRECTORY PROPERTY symplant_planted_bugs)
  set(number 0)
  add_test(NAME ${PREFIX}.none COMMAND ${PROGRAM} --quiet --plants 100)
  set_tests_properties(${PREFIX}.none PROPERTIES TIMEOUT 600 LABELS mutants)
  foreach(name ${names})
    math(EXPR number "${number} + 1")
    set(drawn "")
    if(SYMPLANT_BUGS_WITHOUT_VALUES AND number LESS_EQUAL SYMPLANT_BUGS_WITHOUT_VALUES)
      set(drawn --no-values)
    endif()
    if(DEFINED SYMPLANT_FIRST_PLANT_OF_${name})
      list(APPEND drawn --seed ${SYMPLANT_FIRST_PLANT_OF_${name}})
    endif()
    add_test(NAME ${PREFIX}.${name} COMMAND ${PROGRAM} --bug ${number} --wrong --quiet --plants ${PLANTS} ${drawn})
    set_tests_properties(${PREFIX}.${name} PROPERTIES TIMEOUT 600 LABELS mutants)
  endforeach()
endfunction()
