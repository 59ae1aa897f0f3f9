// The conditions of a plant with their locations in the description.
#pragma once

#include <string_view>
#include <vector>

#include "check/reachability/decide.hpp"
#include "check/rule.hpp"
#include "symplant/condition/tree.hpp"

namespace symplant::check {

/// A condition of a device, written out: `when` or `while` of a transition, or an input of a behavior.
struct WrittenCondition {
  const model::Unit* unit;
  const condition::Tree* tree;
  std::string_view text;
  /// The first transition with this text; null for an input of a behavior.
  const model::Transition* transition;
  std::string_view key;  ///< `when` or `while` of the transition; the name of the input
  Verdict verdict;       ///< if every state of every device is possible

  /// Of the first location where the device has this text.
  description::Pointer pointer() const;
};

/// Those of devices, in the order of their devices. Examines each once: O(transitions) plus
/// decide() for each.
std::vector<WrittenCondition> conditions_of(const Subject& subject);

}  // namespace symplant::check
