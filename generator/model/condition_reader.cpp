// Reads the conditions of plant.json.
#include "model/condition_reader.hpp"

#include <utility>
#include <variant>

#include "symplant/condition/resolve.hpp"
#include "text/pattern.hpp"

namespace symplant::model {

bool ConditionReader::resolve(std::string_view text, const description::Pointer& pointer, condition::Tree& tree) {
  auto resolved = condition::parse_and_resolve(text, names_);
  if (auto* fault = std::get_if<condition::Fault>(&resolved)) {
    faults_.add(pointer, std::move(fault->message), description::FaultKind::condition, fault->index.offset);
    return false;
  }
  tree = std::move(std::get<condition::Tree>(resolved));
  return true;
}

bool ConditionReader::resolve_made(const std::string& text, const MatchedNames& matched,
                                   const description::Pointer& pointer, condition::Tree& tree, std::string* lacking) {
  if (!text::has_braces(text)) return resolve(text, pointer, tree);
  const auto made = make(text, matched, pointer);
  if (!made) return false;
  auto parsed = condition::parse(*made);
  auto* fault = std::get_if<condition::Fault>(&parsed);
  if (fault == nullptr) {
    auto resolved = condition::resolve(std::get<condition::Expression>(parsed), names_);
    if (auto* found = std::get_if<condition::Tree>(&resolved)) {
      tree = std::move(*found);
      return true;
    }
    std::string& message = std::get<condition::Fault>(resolved).message;
    if (lacking != nullptr) {
      *lacking = std::move(message);
      return false;
    }
    faults_.add(pointer, std::move(message), description::FaultKind::condition);
    return false;
  }
  faults_.add(pointer, description::ticked(*made) + ": " + fault->message, description::FaultKind::condition);
  return false;
}

bool ConditionReader::formula(const std::string& text, const MatchedNames* matched, const description::Pointer& pointer,
                              condition::Formula& formula, std::string* lacking) {
  const bool has_braces = matched != nullptr && text::has_braces(text);
  const auto made = has_braces ? make(text, *matched, pointer) : std::optional<std::string>(text);
  if (!made) return false;
  auto parsed = condition::parse_formula(*made, names_);
  if (auto* found = std::get_if<condition::Formula>(&parsed)) {
    formula = std::move(*found);
    return true;
  }
  const condition::Fault& fault = std::get<condition::Fault>(parsed);
  if (has_braces && lacking != nullptr && fault.of_name) {
    *lacking = fault.message;
  } else if (has_braces) {
    faults_.add(pointer, description::ticked(*made) + ": " + fault.message, description::FaultKind::condition);
  } else {
    faults_.add(pointer, fault.message, description::FaultKind::condition, fault.index.offset);
  }
  return false;
}

std::optional<std::string> ConditionReader::make(const std::string& text, const MatchedNames& matched,
                                                 const description::Pointer& pointer) {
  text::Replaced made = matched.replace(text);
  if (made.unknown.empty()) return std::move(made.text);
  faults_.add(pointer, description::ticked(made.unknown) + " is unknown here; use one of " + matched.choices(),
              description::FaultKind::unknown_name);
  return std::nullopt;
}

}  // namespace symplant::model
