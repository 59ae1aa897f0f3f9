// Sequence numbers: the decimal digits at a task's end, of any length.
#pragma once

#include <string_view>

namespace symplant::model {

/// The digits at the end of a task without leading zeros ("0" for zeros alone); empty where it ends in none.
std::string_view sequence_number(std::string_view task);

/// Compares two sequence numbers as numbers, however long: negative, 0, positive. None comes after all.
int compare_sequence(std::string_view a, std::string_view b);

}  // namespace symplant::model
