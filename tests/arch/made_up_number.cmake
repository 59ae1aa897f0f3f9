# Adds a made-up number of transitions, `urgency`, to a copy of the product, counts the files that this changes, and
# compiles what walks the list of numbers. What the engine does with a number comes on top: one file, rarely two.
# -DROOT=... -DCOMPILER=... -DINCLUDES=a|b -DFOLDER=...
set(most 6)
string(REPLACE "|" ";" INCLUDES "${INCLUDES}")
list(TRANSFORM INCLUDES PREPEND -I)
file(REMOVE_RECURSE ${FOLDER})
file(COPY ${ROOT}/runtime/tables DESTINATION ${FOLDER}/runtime)
file(MAKE_DIRECTORY ${FOLDER}/include/symplant)
file(CREATE_LINK ${FOLDER}/runtime/tables ${FOLDER}/include/symplant/tables SYMBOLIC)
set(changed "")

# add(FILE BEFORE TEXT): TEXT in front of BEFORE, which the file has once.
function(add FILE BEFORE TEXT)
  if(NOT EXISTS ${FOLDER}/${FILE})
    file(READ ${ROOT}/${FILE} content)
    file(WRITE ${FOLDER}/${FILE} "${content}")
  endif()
  file(READ ${FOLDER}/${FILE} content)
  string(FIND "${content}" "${BEFORE}" at)
  string(FIND "${content}" "${BEFORE}" last REVERSE)
  if(at EQUAL -1 OR NOT at EQUAL last)
    message(FATAL_ERROR "${FILE} must have this once:\n${BEFORE}")
  endif()
  string(REPLACE "${BEFORE}" "${TEXT}${BEFORE}" content "${content}")
  file(WRITE ${FOLDER}/${FILE} "${content}")
  list(APPEND changed ${FILE})
  list(REMOVE_DUPLICATES changed)
  set(changed "${changed}" PARENT_SCOPE)
endfunction()

add(runtime/tables/tables.hpp "  std::uint32_t weight = 0;" "  std::uint32_t urgency = 0;\n")
add(runtime/tables/tables.hpp "{\"weight\", &TransitionNumbers::weight" "{\"urgency\", &TransitionNumbers::urgency, false},\n  ")
add(runtime/tables/io_model.hpp "  /// Its operation works once:"
    "  constexpr Move urgency(std::uint32_t number) const noexcept {
    Move move = *this;
    move.numbers.urgency = number;
    return move;
  }
")
add(generator/description/plant.schema.json "        \"weight\": {\n" "        \"urgency\": { \"type\": \"integer\", \"minimum\": 1 },\n")
add(generator/view/model.schema.json "        \"weight\": {" "        \"urgency\": { \"type\": \"integer\", \"minimum\": 1 },\n")

list(LENGTH changed count)
if(count GREATER most)
  message(FATAL_ERROR "${count} files to change for a number of transitions, at most ${most} are allowed: ${changed}")
endif()

file(WRITE ${FOLDER}/walk.cpp [[
// A number that is only in the list reaches what walks the list.
#include "symplant/tables/fields.hpp"
#include "symplant/tables/io_model.hpp"

using namespace symplant::tables;
enum class State : unsigned char { a };
constexpr Move<State> kMove = Move<State>{State::a, Dt{}}.urgency(3).weight(5);

constexpr std::uint64_t digest() {
  std::uint64_t sum = 0;
  fields(kMove.numbers, [&](std::uint64_t number) { sum = 10 * sum + number; });
  return sum;
}
static_assert(digest() == 35 && kTransitionNumbers[0].key == "urgency");
static_assert(kMove.numbers != TransitionNumbers{.urgency = 0, .weight = 5});
]])
execute_process(COMMAND ${COMPILER} -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I${FOLDER}/include ${INCLUDES} ${FOLDER}/walk.cpp
                RESULT_VARIABLE code OUTPUT_VARIABLE errors ERROR_VARIABLE errors)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${errors}")
endif()
# The schemas are still JSON.
foreach(schema generator/description/plant.schema.json generator/view/model.schema.json)
  file(READ ${FOLDER}/${schema} json)
  string(JSON kind TYPE "${json}")
endforeach()
message(STATUS "${count} files: ${changed}")
