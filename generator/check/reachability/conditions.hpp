// The conditions of a plant with their locations in the description.
#pragma once

#include <string_view>
#include <vector>

#include "check/rule.hpp"
#include "symplant/condition/tree.hpp"

namespace symplant::check {

/// A condition of a device, written out: `when` of a transition, or an input of a behavior.
struct WrittenCondition {
  const model::Unit* unit;
  const condition::Tree* tree;
  std::string_view text;
  bool is_when;
  description::Pointer pointer;  ///< of the first location where the device has this text
};

/// Those of devices, in the order of their devices. O(transitions).
std::vector<WrittenCondition> conditions_of(const Subject& subject);

}  // namespace symplant::check
