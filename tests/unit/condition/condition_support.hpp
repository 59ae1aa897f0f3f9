// Expressions and trees as short texts.
#pragma once

#include <string>
#include <variant>

#include "support/catch.hpp"
#include "symplant/condition/resolve.hpp"

namespace symplant::test {

inline std::string comparison_text(tables::Comparison comparison) {
  constexpr const char* kTexts[] = {"<", "<=", "=", ">=", ">"};
  return kTexts[static_cast<std::size_t>(comparison)];
}

inline std::string text_of(const condition::Operand& operand) {
  const condition::Number& number = operand.number;
  if (operand.names.empty())
    return (number.negative ? "-" : "") + number.digits + "e" + std::to_string(number.exponent);
  std::string text;
  for (const condition::Name& name : operand.names) text += (text.empty() ? "" : ".") + name.text;
  return operand.output ? text + "[" + operand.output->text + "]" : text;
}

/// A fault as "offset+length message".
inline std::string text_of(const condition::Fault& fault) {
  return std::to_string(fault.index.offset) + "+" + std::to_string(fault.index.length) + " " + fault.message;
}

/// Prefix notation: `(or a (not D.S))`.
inline std::string text_of(const condition::Expression& expression) {
  using Kind = condition::Expression::Kind;
  std::string text;
  switch (expression.kind) {
    case Kind::name:
      for (const condition::Name& name : expression.names) text += (text.empty() ? "" : ".") + name.text;
      return text;
    case Kind::comparison:
      text = text_of(expression.operands[0]) + comparison_text(expression.comparison) + text_of(expression.operands[1]);
      return expression.operands.size() > 2 ? text + "+-" + text_of(expression.operands[2]) : text;
    case Kind::negation:
      text = "(not";
      break;
    case Kind::all:
      text = "(and";
      break;
    case Kind::any:
      text = "(or";
      break;
  }
  for (const condition::Expression& child : expression.children) text += " " + text_of(child);
  return text + ")";
}

/// The tree of a valid condition; else the fault as "offset+length message".
inline std::string parsed(std::string_view text) {
  const auto result = condition::parse(text);
  if (const auto* fault = std::get_if<condition::Fault>(&result)) return text_of(*fault);
  return text_of(std::get<condition::Expression>(result));
}

}  // namespace symplant::test
