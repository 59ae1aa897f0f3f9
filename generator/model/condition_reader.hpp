// Reads the conditions of plant.json.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "description/faults.hpp"
#include "model/matched_names.hpp"
#include "model/plant_names.hpp"
#include "symplant/condition/formula.hpp"
#include "symplant/condition/tree.hpp"

namespace symplant::model {

/// Reads texts with names of a plant, and reports what is wrong with them. The plant and the faults must outlive it.
/// Making one costs O(units + symbols).
class ConditionReader {
 public:
  ConditionReader(const PlantModel& plant, description::Faults& faults) : faults_(faults), names_(plant, faults) {}

  /// False, and a fault, if the text is not a condition of this plant.
  bool resolve(std::string_view text, const description::Pointer& pointer, condition::Tree& tree);
  /// As resolve(), for a text under a pattern, in which names in braces refer to `matched`. If `lacking` is not null,
  /// an unknown name is not a fault: `lacking` gets the message.
  bool resolve_made(const std::string& text, const MatchedNames& matched, const description::Pointer& pointer,
                    condition::Tree& tree, std::string* lacking = nullptr);
  /// Reads a formula; `matched` is null for a text without names in braces. Otherwise as resolve_made().
  bool formula(const std::string& text, const MatchedNames* matched, const description::Pointer& pointer,
               condition::Formula& formula, std::string* lacking);
  /// The text with the names in braces replaced; nothing, and a fault, if one is unknown.
  std::optional<std::string> make(const std::string& text, const MatchedNames& matched,
                                  const description::Pointer& pointer);
  PlantNames& names() { return names_; }

 private:
  description::Faults& faults_;
  PlantNames names_;
};

}  // namespace symplant::model
