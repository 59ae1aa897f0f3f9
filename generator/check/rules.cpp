// What the rules about names share.
#include "check/rules.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "check/spelling/bent_words.hpp"
#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::check {

void narrow(diag::Location& location, const model::Symbol& symbol) {
  const text::Span part = symbol.reading.where();
  if (location.span.end - location.span.begin != symbol.name().size()) return;  // the whole row, or an unescaped cell
  location.span = {location.span.begin + part.begin, location.span.begin + part.end};
}

std::string_view faulty_part(const model::Symbol& symbol) {
  const text::Span part = symbol.reading.where();
  return symbol.name().substr(part.begin, part.end - part.begin);
}

diag::Subjects about_name(const model::PlantModel& plant, const model::Symbol& symbol) {
  diag::Subjects subjects = about(symbol).explaining({diag::Subject::Kind::name, std::string(symbol.name())});
  if (symbol.reading.fault == name::NameFault::wrong_number_of_levels) return subjects;
  std::string separator;
  text::append_utf8(separator, plant.rule->separator);
  const auto& levels = plant.rule->levels;
  const auto direction = std::find(levels.begin(), levels.end(), name::Level::direction);
  std::size_t end = 0;
  for (auto level = levels.begin(); level != direction && end != std::string_view::npos; ++level) {
    end = symbol.name().find(separator, level == levels.begin() ? 0 : end + separator.size());
  }
  if (end >= symbol.reading.where().begin) return subjects;
  const std::string_view path = symbol.name().substr(0, end);
  return std::move(subjects).explaining(side_of(path, symbol.direction)).explaining(model_of(path));
}

std::string_view consequence(const model::Symbol& symbol) {
  return symbol.direction == tables::Direction::event ? "no device drives it" : "it drives no device";
}

namespace {

/// Tasks of operations that have no feedback by nature. The page of SP401 lists them.
constexpr std::array<std::string_view, 9> kNoFeedback{"ACK", "BUZZER", "BYPASS", "HORN", "LAMP",
                                                      "LED", "MUTE",   "RESET",  "RST"};

bool overruled(const model::Symbol& symbol) {
  if (!symbol.address || symbol.reading.fault != name::NameFault::none) return false;
  return (symbol.reading.direction == name::Direction::operation) != (symbol.direction == tables::Direction::operation);
}

std::string task_key(std::string_view path, std::string_view task, bool operation) {
  return text::to_upper(path) + (operation ? " O " : " I ") + text::to_upper(task);
}

}  // namespace

std::vector<TaskClaim> task_claims(const model::PlantModel& plant) {
  std::map<std::string, std::uint32_t> dropped;
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const model::Symbol& symbol = plant.symbols[i];
    if (symbol.unmodelled != model::Unmodelled::task_taken) continue;
    dropped.emplace(
        task_key(symbol.reading.device_path(), symbol.reading.task(), symbol.direction == tables::Direction::operation),
        i);
  }
  std::vector<TaskClaim> claims;
  if (dropped.empty()) return claims;
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const model::Symbol& symbol = plant.symbols[i];
    if (symbol.reading.fault != name::NameFault::none || symbol.unmodelled == model::Unmodelled::task_taken) continue;
    if (symbol.type != tables::DataType::boolean) continue;
    const auto found = dropped.find(task_key(symbol.reading.device_path(), symbol.reading.task(),
                                             symbol.direction == tables::Direction::operation));
    if (found == dropped.end()) continue;
    if (overruled(symbol)) {
      claims.push_back({i, found->second, true});
    } else {
      claims.push_back({found->second, i, false});
    }
  }
  return claims;
}

bool switched_by_outputs(const model::Unit& unit, std::uint32_t event) {
  const auto is_in = [&](const auto& list) {
    return std::any_of(list.begin(), list.end(), [&](const auto& output) { return output.first == event; });
  };
  return std::any_of(unit.outputs.begin(), unit.outputs.end(),
                     [&](const model::Outputs& outputs) { return is_in(outputs.enter) || is_in(outputs.leave); });
}

OverruledNames::OverruledNames(const model::PlantModel& plant) {
  for (const model::Symbol& symbol : plant.symbols) {
    if (!overruled(symbol)) continue;
    names_.insert(task_key(symbol.reading.device_path(), symbol.reading.task(),
                           symbol.reading.direction == name::Direction::operation));
  }
}

bool OverruledNames::has(const model::Unit& unit, const model::State& state, name::Direction direction) const {
  return !names_.empty() && names_.count(task_key(unit.path, state.name, direction == name::Direction::operation)) != 0;
}

bool is_one_word_twice(const Subject& subject, const model::Unit& unit) {
  return evidence_of(subject, unit).two_words && bent_alike(unit.states[0].name, unit.states[1].name);
}

bool needs_no_feedback(std::string_view task) {
  while (!task.empty() && text::is_digit(task.back())) task.remove_suffix(1);
  return std::any_of(kNoFeedback.begin(), kNoFeedback.end(),
                     [&](std::string_view word) { return text::equal_ignoring_case(word, task); });
}

Unled unled(const Subject& subject, const model::Unit& unit, std::uint32_t state) {
  const model::State& of = unit.states[state];
  if (unit.operations.empty() || of.event == model::kNone || of.operation != model::kNone) return Unled::no;
  if (unit.reaches(state) || switched_by_outputs(unit, of.event)) return Unled::no;
  // The description gives the transitions: the list is not the cause.
  if (unit.described != nullptr && unit.described->only) return Unled::no;
  const model::UnitEvidence& evidence = evidence_of(subject, unit);
  if (evidence.two_words && !needs_no_feedback(unit.states[1 - state].name)) return Unled::two_words;
  if (subject.overruled.has(unit, of, name::Direction::operation)) return Unled::overruled;
  const auto& ambiguous = evidence.ambiguous_sequence;
  if (std::find(ambiguous.begin(), ambiguous.end(), state) != ambiguous.end()) return Unled::ambiguous;
  return Unled::no_operation;
}

}  // namespace symplant::check
