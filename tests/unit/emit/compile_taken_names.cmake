# Generates plants whose file name is used by C, C++ or CMake, with devices of such names, and compiles
# every file of them.
set(devices
    NULL EOF errno I linux unix class int operator Plant Device Symbol Operation Event State kI kO kS kEnter kLeave
    kTargets kTransitions kTypes kUnits kTimes kRandomTimes kSymbols kTables kInitialValues kSharedAddresses kDisables
    kConditions kConditionedUnits kUnitWatches kOperationWatches kEventWatches kOperationValueWatches kEventValueWatches
    kRequirements kBehaviourUnits kBehaviourValues kUnitNames kStateNames kSymbolNames kRequirementNames kBehaviourNames
    kOperation kEvent kNone kNumber kOther kFree T link tables symplant std row array span string 1ST 2ND
    time index signal uint8 OwnedPlant main)
set(list "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial\n")
set(number 0)
foreach(device IN LISTS devices)
  # A task of each device is such a name, too, so that no two share a type.
  foreach(task "O_${device}" "I_${device}" "O_default1" "I_default1")
    math(EXPR number "${number} + 1")
    string(SUBSTRING ${task} 0 1 direction)
    if(direction STREQUAL O)
      set(address "%QX${number}")
    else()
      set(address "%IX${number}")
    endif()
    string(APPEND list "VAR_GLOBAL,L_P_${device}_${task},,${address},BOOL,FALSE\n")
  endforeach()
endforeach()

string(SUBSTRING "${list}" 0 400 short_list)
string(FIND "${short_list}" "\n" end REVERSE)
string(SUBSTRING "${short_list}" 0 ${end} short_list)

set(flags -std=c++20 -Wall -Wextra -Wpedantic -Werror -fsyntax-only)
string(REPLACE "|" ";" includes "${INCLUDES}")
foreach(include IN LISTS includes)
  list(APPEND flags "-I${include}")
endforeach()
file(REMOVE_RECURSE ${FOLDER})
set(failed "")
foreach(
  plant
  time
  index
  signal
  link
  log
  read
  select
  errno
  NULL
  class
  std
  core
  tables
  Plant
  T
  line1
  1st
  "two words"
  unix)
  set(folder "${FOLDER}/${plant}")
  if(plant STREQUAL line1)
    file(WRITE "${folder}/${plant}.csv" "${list}")
  else() # each device once is enough
    file(WRITE "${folder}/${plant}.csv" "${short_list}")
  endif()
  execute_process(COMMAND ${TOOL} generate "${folder}/${plant}.csv" -o "${folder}/out" RESULT_VARIABLE code
                  OUTPUT_QUIET ERROR_VARIABLE said)
  if(NOT code EQUAL 0)
    message("${plant}: generate gave ${code}\n${said}")
    list(APPEND failed ${plant})
    continue()
  endif()
  execute_process(COMMAND ${COMPILER} ${flags} tables_gen.cpp main_gen.cpp WORKING_DIRECTORY "${folder}/out"
                  RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT code EQUAL 0)
    string(SUBSTRING "${said}" 0 1500 said)
    message("${plant} does not compile:\n${said}")
    list(APPEND failed "${plant}")
  endif()
endforeach()
if(failed)
  list(REMOVE_DUPLICATES failed)
  message(FATAL_ERROR "these plants do not compile: ${failed}")
endif()
