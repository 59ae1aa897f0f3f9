// SP405 two-words-one-state: two words may mean one state.
#include <fmt/format.h>

#include <algorithm>

#include "check/rules.hpp"
#include "check/spelling/bent_words.hpp"
#include "check/spelling/device_classes.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kTwoWordsOneStatePage =
    R"(One task of a device has only an operation, another only an event, and they look like two forms of one word: `O_CLAMP` and
`I_CLAMPED`. Other tasks of the device have their own findings.

**What the model loses.** If both words mean one state, the device has one state too many: it goes to CLAMP, and CLAMPED never
comes on. A program that waits for it waits forever.

**How to fix it.** Spell both alike (`O_CLAMP`, `I_CLAMP`). If they are two states, add the operation or the event that is
missing.
)";

/// A task of a unit that has an operation, and one that has an event.
struct WordPair {
  std::uint32_t commanded;
  std::uint32_t reported;
};

/// The two symbols. If both words mean one state, neither of the symbols that the two tasks lack is missing.
diag::Subjects about_pair(const model::PlantModel& plant, const model::Unit& unit, WordPair pair) {
  const model::State& commanded = unit.states[pair.commanded];
  const model::State& reported = unit.states[pair.reported];
  diag::Subjects subjects =
      about(event_of(plant, unit, reported.event), operation_of(plant, unit, commanded.operation));
  subjects.explains = {missing(plant, unit.path, tables::Direction::event, commanded.name),
                       missing(plant, unit.path, tables::Direction::operation, reported.name), model_of(unit.path)};
  subjects.follows = subjects.explains;
  subjects.follows.push_back(device(unit.path));
  return subjects;
}

void report(const Rule& rule, const model::PlantModel& plant, const model::Unit& unit, WordPair pair,
            diag::Diagnostics& diagnostics) {
  const model::Symbol& operation = operation_of(plant, unit, unit.states[pair.commanded].operation);
  const model::Symbol& event = event_of(plant, unit, unit.states[pair.reported].event);
  diagnostics.add(
      rule.info, about_pair(plant, unit, pair),
      fmt::format("`{}` and `{}`: do `{}` and `{}` mean the same state? spell them the same, or `{}` is never reported",
                  operation.name(), event.name(), operation.reading.task, event.reading.task, event.reading.task),
      location_of(plant, event), {{location_of(plant, operation), "the operation"}});
}

/// A state that is reported and not commanded, nor led to by anything but its number.
bool is_only_reported(const model::Unit& unit, std::uint32_t state) {
  const model::State& of = unit.states[state];
  return of.event != model::kNone && of.operation == model::kNone && state != unit.rest &&
         std::none_of(unit.transitions.begin(), unit.transitions.end(), [&](const model::Transition& transition) {
           return transition.to == state && transition.origin != model::Origin::inferred;
         });
}

/// Of a device with further tasks: forms of one word.
void report_bent_words(const Rule& rule, const model::PlantModel& plant, const model::Unit& unit,
                       diag::Diagnostics& diagnostics) {
  if (unit.operations.empty() || unit.events.empty() || unit.states.size() < 2) return;
  if (unit.has_behaviour() || !unit.outputs.empty()) return;  // other events may report the state
  for (std::uint32_t c = 0; c < unit.states.size(); ++c) {
    const model::State& commanded = unit.states[c];
    if (commanded.operation == model::kNone || commanded.event != model::kNone) continue;
    for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
      if (!is_only_reported(unit, s) || !bent_alike(commanded.name, unit.states[s].name)) continue;
      report(rule, plant, unit, {c, s}, diagnostics);
      break;
    }
  }
}

/// Whether siblings have the other side of a word: SP414 reports what is missing.
bool are_two_states(const Subject& subject, const model::Unit& unit) {
  const auto location = static_cast<std::uint32_t>(&unit - subject.plant.units.data());
  return std::any_of(unit.states.begin(), unit.states.end(), [&](const model::State& state) {
    const bool commanded = state.operation != model::kNone;
    const auto other = commanded ? tables::Direction::event : tables::Direction::operation;
    return subject.classes.expects(location, other, state.name, false) == Expected::yes;
  });
}

void check_two_words_one_state(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (is_one_word_twice(subject, unit)) {
      if (are_two_states(subject, unit)) continue;
      const std::uint32_t commanded = unit.states[0].operation != model::kNone ? 0 : 1;
      report(rule, plant, unit, {commanded, 1 - commanded}, diagnostics);
    } else {
      report_bent_words(rule, plant, unit, diagnostics);
    }
  }
}

}  // namespace

const Rule kTwoWordsOneState{{"SP405", "two-words-one-state", diag::Severity::warning, "two words may mean one state",
                              kTwoWordsOneStatePage, diag::Rank::words},
                             check_two_words_one_state};

}  // namespace symplant::check
