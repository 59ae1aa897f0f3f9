// The operands that a Logix export names.
#include "read/rockwell/operands.hpp"

#include <algorithm>

#include "read/rockwell/aliases.hpp"
#include "text/ascii.hpp"

namespace symplant::read {

bool is_module_io(std::string_view operand) {
  const OperandParts parts = split_operand(operand);
  const std::size_t colon = parts.base.rfind(':');
  if (parts.tail.empty() || colon == std::string_view::npos || colon + 1 == parts.base.size()) return false;
  std::string_view part = parts.base.substr(colon + 1);
  if (part.size() > 1 && text::upper(part.front()) == 'S') part.remove_prefix(1);
  const char area = text::upper(part.front());
  const std::string_view number = part.substr(1);
  return (area == 'I' || area == 'O') && std::all_of(number.begin(), number.end(), text::is_digit);
}

void RockwellOperands::reserve(std::size_t expected) {
  base::reserve_large(operands_, expected);
  numbers_ = base::IndexTable(expected);
}

std::uint32_t RockwellOperands::number_of(std::string_view operand) {
  const auto next = static_cast<std::uint32_t>(operands_.size());
  const std::uint32_t number = numbers_.find_or_add(text::hash_ignoring_case(operand), next, [&](std::uint32_t other) {
    return text::equal_ignoring_case(operands_[other].text, operand);
  });
  if (number == next) operands_.push_back({operand, {}});
  return number;
}

std::uint32_t RockwellOperands::parent_of(std::uint32_t number) {
  const Operand& operand = operands_[number];
  if (operand.parent_known) return operand.parent;
  const std::size_t end =
      operand.text.size() > kLongestOperand ? std::string_view::npos : operand.text.find_last_of(".[");
  const bool has_parent = end != std::string_view::npos && end != 0;
  const std::uint32_t parent = has_parent ? number_of(operand.text.substr(0, end)) : kNone;
  operands_[number].parent = parent;
  operands_[number].parent_known = true;
  return parent;
}

void RockwellOperands::mark_wholes(std::uint32_t number) {
  for (number = parent_of(number); number != kNone && !operands_[number].is_whole; number = parent_of(number)) {
    operands_[number].is_whole = true;
  }
}

}  // namespace symplant::read
