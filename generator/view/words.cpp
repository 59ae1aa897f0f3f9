// Texts about the parts of a model.
#include "view/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "model/classify.hpp"
#include "model/condition_text.hpp"

namespace symplant::view {

using model::kNone;

std::string time_text(tables::Time time) {
  if (time % tables::kSecond == 0) return fmt::format("{} s", time / tables::kSecond);
  if (time % tables::kMillisecond != 0) return fmt::format("{} ns", time);
  if (time < tables::kSecond) return fmt::format("{} ms", time / tables::kMillisecond);
  std::string text = fmt::format("{}.{:03}", time / tables::kSecond, time % tables::kSecond / tables::kMillisecond);
  while (text.back() == '0') text.pop_back();
  return text + " s";
}

std::string duration_text(const description::Duration& duration) {
  switch (duration.kind) {
    case description::Duration::Kind::fixed:
      break;
    case description::Duration::Kind::uniform:
      return time_text(duration.a) + " to " + time_text(duration.b);
    case description::Duration::Kind::normal:
      return time_text(duration.a) + " (sigma " + time_text(duration.b) + ")";
    case description::Duration::Kind::seconds:
      return "(" + *duration.formula + ") s";
  }
  return time_text(duration.a);
}

std::string_view origin_text(model::Origin origin) {
  switch (origin) {
    case model::Origin::given:
      return "given";
    case model::Origin::derived:
      return "derived";
    case model::Origin::inferred:
      return "inferred";
  }
  return "";
}

std::string_view initial_key(model::InitialFrom from) {
  switch (from) {
    case model::InitialFrom::description:
      return "description";
    case model::InitialFrom::initial_column:
      return "initial-column";
    case model::InitialFrom::rest_state:
      return "rest-state";
    case model::InitialFrom::sequence:
      return "sequence";
    case model::InitialFrom::row_order:
      return "row-order";
    case model::InitialFrom::naming:
      return "naming";
  }
  return "";
}

std::string_view initial_reason(model::InitialFrom from) {
  switch (from) {
    case model::InitialFrom::description:
      return "as the description says";
    case model::InitialFrom::initial_column:
      return "its event alone has Initial TRUE";
    case model::InitialFrom::rest_state:
      return "its rest state";
    case model::InitialFrom::sequence:
      return "first in sequence";
    case model::InitialFrom::row_order:
      return "by row order only";
    case model::InitialFrom::naming:
      return "as the naming rule says";
  }
  return "";
}

std::string_view unmodelled_key(model::Account reason) {
  switch (reason) {
    case model::Account::modelled:
      return "";
    case model::Account::numeric:
      return "numeric";
    case model::Account::task_taken:
      return "task-taken";
    case model::Account::unit_too_large:
      return "unit-too-large";
    case model::Account::no_operation:
    case model::Account::no_event:
      return "unpaired";
    case model::Account::no_direction:
      return "no-direction";
    case model::Account::no_rule:
      return "no-rule";
    case model::Account::ignored:
      return "ignored";
    case model::Account::named_internal:
      return "internal";
    case model::Account::operator_panel:
      return "operator";
    case model::Account::data:
      return "data";
    case model::Account::interlock:
      return "interlock";
    case model::Account::constant:
      return "constant";
    case model::Account::role_none:
      return "none";
    case model::Account::follows:
      return "follows";
    case model::Account::shows_value:
      return "signal";
    case model::Account::senses_parts:
      return "senses-parts";
    case model::Account::plain:
      return "plain";
    case model::Account::condition:
      break;
  }
  return "";
}

std::string_view unmodelled_reason(model::Account reason) {
  switch (reason) {
    case model::Account::modelled:
      return "";
    case model::Account::numeric:
      return "numeric: states come from BOOL symbols only";
    case model::Account::task_taken:
      return "another symbol of its device has its task and direction";
    case model::Account::unit_too_large:
      return "its device has more symbols or states than a device may have";
    case model::Account::no_operation:
    case model::Account::no_event:
      return "no symbol of the other direction fits it";
    case model::Account::no_direction:
      return "neither its address nor its name says a direction";
    case model::Account::no_rule:
      return "its name does not follow the naming rule";
    case model::Account::ignored:
      return "the naming rule ignores it";
    case model::Account::named_internal:
      return "internal by its name";
    case model::Account::operator_panel:
      return "operator panel";
    case model::Account::data:
      return "data: a bit of a number, or one of several symbols of one text";
    case model::Account::interlock:
      return "interlock: a permission between two machines";
    case model::Account::constant:
      return "constant: a contact that keeps its value";
    case model::Account::role_none:
      return "of no role, by the naming rule";
    case model::Account::follows:
      return "driven by a condition";
    case model::Account::shows_value:
      return "driven by a formula";
    case model::Account::senses_parts:
      return "driven by a sensor of parts";
    case model::Account::plain:
      return "plain: plant.json says that it belongs to no device";
    case model::Account::condition:
      break;
  }
  return "";
}

std::string operation_text(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t operation) {
  return "O_" + std::string(plant.symbols[unit.operations[operation]].reading.task());
}

std::string event_text(const model::PlantModel& plant, const model::Unit& unit, std::uint32_t event) {
  return "I_" + std::string(plant.symbols[unit.events[event]].reading.task());
}

std::vector<std::string_view> inferences(const model::Unit& unit) {
  std::vector<std::string_view> sentences;
  if (unit.rest_added) sentences.push_back("the only state got a counterpart without an event");
  if (unit.single_solenoid) sentences.push_back("one operation and two events: a single solenoid");
  return sentences;
}

std::vector<std::pair<std::uint32_t, bool>> switched(const model::Unit& unit, std::uint32_t state, bool entering) {
  std::vector<std::pair<std::uint32_t, bool>> events;
  if (unit.states[state].event != kNone) events.emplace_back(unit.states[state].event, entering);
  if (unit.outputs.empty()) return events;
  const auto& more = entering ? unit.outputs[state].enter : unit.outputs[state].leave;
  events.insert(events.end(), more.begin(), more.end());
  return events;
}

std::string value_text(tables::DataType type, std::uint64_t value) {
  using tables::DataType;
  switch (type) {
    case DataType::boolean:
      return value == 0 ? "FALSE" : "TRUE";
    case DataType::real:
    case DataType::lreal:
      return fmt::format("{}", std::bit_cast<double>(value));
    case DataType::sint:
    case DataType::int_:
    case DataType::dint:
    case DataType::lint:
      return fmt::format("{}", static_cast<std::int64_t>(value));
    default:
      return fmt::format("{}", value);
  }
}

std::vector<model::Transition> spring_returns(const model::Unit& unit) {
  std::vector<model::Transition> routes;
  if (unit.actuation != tables::Actuation::spring) return routes;
  for (std::uint32_t from = 0; from < unit.states.size(); ++from) {
    if (from == unit.rest) continue;
    const auto taken = std::find_if(unit.transitions.begin(), unit.transitions.end(), [&](const model::Transition& t) {
      return t.from == from && t.to == unit.rest && (t.on != kNone || t.spring_return);
    });
    if (taken != unit.transitions.end() && taken->spring_return) continue;
    model::Transition route;
    route.from = from;
    route.to = unit.rest;
    route.during = taken == unit.transitions.end() ? kNone : taken->during;
    route.takes = taken == unit.transitions.end() ? description::Duration::fixed(unit.travel) : taken->takes;
    route.spring_return = true;
    routes.push_back(route);
  }
  return routes;
}

TransitionText transition_text(const model::Transition& transition, const model::Unit& unit,
                               const model::PlantModel& plant) {
  TransitionText text;
  text.on = transition.spring_return ? "spring"
            : transition.on == kNone ? "by itself"
                                     : operation_text(plant, unit, transition.on);
  if (transition.once) text.on += ", once";
  if (transition.when != kNone) text.when = model::condition_text(unit.conditions[transition.when], plant);
  if (transition.during != kNone) text.during = model::condition_text(unit.conditions[transition.during], plant);
  for (const tables::TransitionNumber& number : tables::kTransitionNumbers) {
    const std::uint32_t value = transition.numbers.*number.member;
    if (value != 0) text.numbers += fmt::format("{}{} {}", text.numbers.empty() ? "" : ", ", number.key, value);
  }
  if (!transition.after.is_zero()) text.after = "after " + duration_text(transition.after);
  if (transition.on != kNone || transition.spring_return || !transition.takes.is_zero()) {
    text.takes = "takes " + duration_text(transition.takes);
  }
  return text;
}

}  // namespace symplant::view
