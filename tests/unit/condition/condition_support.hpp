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

/// Prefix notation: `(or a (not D.S))`.
inline std::string text_of(const condition::Expression& expression) {
  using Kind = condition::Expression::Kind;
  std::string text;
  switch (expression.kind) {
    case Kind::name:
    case Kind::comparison:
      for (const condition::Name& name : expression.names) text += (text.empty() ? "" : ".") + name.text;
      if (expression.kind == Kind::comparison) {
        text += comparison_text(expression.comparison) + (expression.number.negative ? "-" : "") +
                expression.number.digits + "e" + std::to_string(expression.number.exponent);
      }
      return text;
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
  if (const auto* fault = std::get_if<condition::Fault>(&result)) {
    return std::to_string(fault->index.offset) + "+" + std::to_string(fault->index.length) + " " + fault->message;
  }
  return text_of(std::get<condition::Expression>(result));
}

}  // namespace symplant::test
