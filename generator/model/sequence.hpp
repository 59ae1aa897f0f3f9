// Sequence numbers: the decimal digits at a task's end, of any length.
#pragma once

#include <string_view>

namespace symplant::model {

/// The digits at the end of a task without leading zeros ("0" if all are zeros); empty if there are no digits.
std::string_view sequence_number(std::string_view task);

/// Compares two sequence numbers of any length: negative, 0, positive. An empty one comes last.
int compare_sequence(std::string_view a, std::string_view b);

}  // namespace symplant::model
