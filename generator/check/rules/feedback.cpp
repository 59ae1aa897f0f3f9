// Rules: operations without events, and events without operations.
#include <algorithm>
#include <array>
#include <set>

#include "check/rule.hpp"
#include "check/words.hpp"
#include "elements/material/part_words.hpp"
#include "text/ascii.hpp"
#include "text/shape.hpp"

namespace symplant::check {
namespace {

/// At the symbol of a state whose other side is missing. Alike findings in all devices of a type have one shape.
Finding at_side(const Find& find, const Unit& unit, const Symbol& symbol, std::string_view state) {
  Finding finding = find.at(symbol);
  const std::string type = class_name(unit.device);
  finding.as.subjects.shape = type.find('#') == std::string::npos ? text::shape_of(unit.path) : type;
  finding.follows(Kind::device, unit.path)
      .follows(Kind::missing, symbol_name(unit.path, other_side(symbol.direction), state));
  return finding;
}

/// Whether operations of this task have no feedback by nature, such as RESET2. The page of SP401 lists them.
bool needs_no_feedback(std::string_view task) {
  constexpr std::array<std::string_view, 9> kNoFeedback{"ACK", "BUZZER", "BYPASS", "HORN", "LAMP",
                                                        "LED", "MUTE",   "RESET",  "RST"};
  while (!task.empty() && text::is_digit(task.back())) task.remove_suffix(1);
  return std::ranges::any_of(kNoFeedback, [&](std::string_view word) { return text::equal_ignoring_case(word, task); });
}

void operation_without_event(const Find& find) {
  std::set<std::string> reported;  // under a custom naming rule: the tasks that some device of a class reports
  const auto key = [](const Unit& unit, const State& state) {
    return text::to_upper(fmt::format("{} {}", class_name(unit.device), state.name));
  };
  for (const Unit& unit : find.units) {
    for (const State& state : unit.states) {
      if (find.plant.pairing == nullptr) break;
      if (state.event != kNone) reported.insert(key(unit, state));
    }
  }
  for (const Unit& unit : find.units) {
    if (unit.events.empty() || unit.has_behaviour() || unit.is_archetype()) continue;  // user code or roles report
    for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
      const State& state = unit.states[s];
      if (state.operation == kNone || state.event != kNone || needs_no_feedback(state.name)) continue;
      if (s != unit.initial && !unit.reaches(s)) continue;
      if (find.plant.pairing != nullptr && reported.count(key(unit, state)) == 0) continue;
      const auto switches_on = [](const std::pair<std::uint32_t, bool>& output) { return output.second; };
      if (!unit.outputs.empty() && std::ranges::any_of(unit.outputs[s].enter, switches_on)) continue;
      const Symbol& symbol = find.symbols[unit.operations[state.operation]];
      at_side(find, unit, symbol, state.name)
          .say("`{}` commands `{}` of `{}`, but no event reports that state: add an event with task `{}`",
               symbol.name(), state.name, unit.path, state.name);
    }
  }
}

void event_without_operation(const Find& find, const Unit& unit) {
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    if (!is_left_alone(unit, s)) continue;
    const bool two_words = find.evidence_of(unit).two_words;  // SP401 or SP405 reports it
    if (two_words && !needs_no_feedback(unit.states[1 - s].name)) continue;
    const State& state = unit.states[s];
    const Symbol& symbol = find.symbols[unit.events[state.event]];
    at_side(find, unit, symbol, state.name)
        .say(
            "`{}` reports `{}` of `{}`, but no operation leads there: add operation `{}`, or number the tasks in "
            "order{}",
            symbol.name(), state.name, unit.path, state.name,
            unit.described == nullptr ? "" : ", or describe a transition");
  }
}

void event_not_driven(const Find& find, const Unit& unit) {
  if (!unit.operations.empty() || unit.initial_from == model::InitialFrom::description) return;
  if (unit.facet != nullptr && !unit.facet->linked) return;  // the score shows what nothing links
  std::vector<const Symbol*> left;
  for (const std::uint32_t event : unit.events) {
    const Symbol& symbol = find.symbols[event];
    if (symbol.initial == 0 && !model::is_driven(find.plant, symbol)) left.push_back(&symbol);
  }
  if (left.empty()) return;
  const std::string_view name = left.front()->name();
  Finding finding = find.at(*left.front());
  finding.follows(Kind::device, unit.path).follows(Kind::model, unit.path).follows(Kind::symbol, name);
  for (const State& state : unit.states) {
    finding.follows(Kind::missing, symbol_name(unit.path, Direction::operation, state.name));
  }
  finding.say("nothing drives `{}`{}; write Initial TRUE for a contact that is on in a healthy plant", name,
              left.size() == 1 ? "" : fmt::format(" and {} more events of `{}`", left.size() - 1, unit.path));
}

/// A state that is reported and not commanded, nor led to by anything but its number.
bool is_only_reported(const Unit& unit, const State& state) {
  const auto index = static_cast<std::uint32_t>(&state - unit.states.data());
  return state.event != kNone && state.operation == kNone && index != unit.rest &&
         std::ranges::none_of(unit.transitions, [&](const Transition& transition) {
           return transition.to == index && transition.origin != model::Origin::inferred;
         });
}

void two_words_one_state(const Find& find, const Unit& unit) {
  if (unit.has_behaviour() || !unit.outputs.empty()) return;  // other events may report the state
  for (const State& commanded : unit.states) {
    if (commanded.operation == kNone || commanded.event != kNone) continue;
    const auto reported = std::ranges::find_if(unit.states, [&](const State& state) {
      const bool only = find.evidence_of(unit).two_words ? state.event != kNone : is_only_reported(unit, state);
      return only && bent_alike(commanded.name, state.name);
    });
    if (reported == unit.states.end()) continue;
    const Symbol& operation = find.symbols[unit.operations[commanded.operation]];
    const Symbol& event = find.symbols[unit.events[reported->event]];
    Finding finding = find.at(event);
    // If both words mean one state, neither of the symbols that the two tasks lack is missing.
    finding.lacks(symbol_name(unit.path, Direction::event, commanded.name), unit.path)
        .lacks(symbol_name(unit.path, Direction::operation, reported->name), unit.path);
    finding.as.subjects.follows = finding.as.subjects.explains;
    finding.also(Kind::symbol, operation.name())
        .follows(Kind::device, unit.path)
        .see(operation, "the operation")
        .say("`{}` and `{}`: do `{}` and `{}` mean the same state? spell them the same, or `{}` is never reported",
             operation.name(), event.name(), operation.reading.task(), event.reading.task(), event.reading.task());
  }
}

constexpr Rule kFeedbackRules[] = {
    {"SP401", "operation-without-event", kWarning, operation_without_event, "no event reports a commanded state",
     "A device has `O_P2` and other events, but no `I_P2`. Devices of one type make one finding. Devices without any "
     "event are not checked, nor are tasks without feedback: ACK, BUZZER, BYPASS, HORN, LAMP, LED, MUTE, RESET and "
     "RST.",
     "No input reports the state: a program that waits for it waits forever.",
     "Add the event, or spell both alike. In plant.json, `outputs` can switch another event.", Rank::last, For::named},
    {"SP402", "event-without-operation", kWarning, event_without_operation, "no operation leads to an event's state",
     "It is neither a spring's rest state nor the next one of a sequence. Devices of one type make one finding.",
     "The event never comes on by itself.",
     "Add the operation, spell both alike, number tasks, or describe a transition or `outputs`.", Rank::last,
     For::named},
    {"SP404", "event-not-driven", kNote, event_not_driven, "inputs of the PLC that no device drives",
     "A device has events and no operation: a push button, a light barrier, a healthy contact (emergency stop, air).",
     "The inputs keep their initial values until a scenario, a link or a person sets them.",
     "Write Initial TRUE if it is on in a healthy plant, or describe what drives it.", Rank::last, For::named},
    {"SP405", "two-words-one-state", kWarning, two_words_one_state, "two words may mean one state",
     "A task with only an operation and one with only an event look like forms of one word: `O_CLAMP`, `I_CLAMPED`.",
     "The device goes to CLAMP, and CLAMPED never comes on.",
     "Spell both alike. If they are two states, add the side that is missing.", Rank::words, For::levels},
};

}  // namespace

bool is_left_alone(const Unit& unit, std::uint32_t state) {
  const State& of = unit.states[state];
  if (unit.operations.empty() || of.event == kNone || of.operation != kNone || unit.reaches(state)) return false;
  if (unit.described != nullptr && unit.described->only) return false;  // the list is not the cause
  const auto switches = [&](const auto& outputs) {
    return std::ranges::any_of(outputs, [&](const auto& output) { return output.first == of.event; });
  };
  return std::ranges::none_of(unit.outputs,
                              [&](const model::Outputs& all) { return switches(all.enter) || switches(all.leave); });
}

std::span<const Rule> feedback_rules() { return kFeedbackRules; }

}  // namespace symplant::check
