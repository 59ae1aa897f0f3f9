// Parses and evaluates conditions that compare two operands.
//
// A number and an integer (a symbol or a number of parts) compare exactly, as everywhere; all else compares as doubles.
#include "support/reference/value_condition.hpp"

#include <algorithm>
#include <cstdlib>

#include "support/reference/formula_text.hpp"
#include "support/reference/material.hpp"
#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

using tables::Comparison;

struct ComparisonSign {
  std::string_view text;
  Comparison comparison;
};
constexpr ComparisonSign kComparisonSigns[] = {{"<", Comparison::less},
                                               {"<=", Comparison::less_equal},
                                               {"=", Comparison::equal},
                                               {">=", Comparison::greater_equal},
                                               {">", Comparison::greater}};

template <class Number>
bool compared(Number a, Comparison comparison, Number b) {
  switch (comparison) {
    case Comparison::less:
      return a < b;
    case Comparison::less_equal:
      return a <= b;
    case Comparison::equal:
      return a == b;
    case Comparison::greater_equal:
      return a >= b;
    case Comparison::greater:
      return a > b;
  }
  return false;
}

/// Both ends hold, too.
bool is_within(double a, double b, double tolerance) { return a >= b - tolerance && a <= b + tolerance; }

class ConditionParser {
 public:
  explicit ConditionParser(std::string_view text) : tokens_(text) {}

  CompareTree parse() {
    CompareTree tree = any();
    tokens_.expect_end();
    return tree;
  }

 private:
  CompareTree any() {
    CompareTree tree = all();
    while (tokens_.accept_word("or", true)) tree = joined(CompareTree::Kind::any, {tree, all()});
    return tree;
  }
  CompareTree all() {
    CompareTree tree = part();
    while (tokens_.accept_word("and", true)) tree = joined(CompareTree::Kind::all, {tree, part()});
    return tree;
  }
  CompareTree part() {
    if (tokens_.accept_word("not", true)) return joined(CompareTree::Kind::negation, {part()});
    if (!tokens_.accept_sign("(")) return atom();
    CompareTree tree = any();
    tokens_.expect_sign(")");
    return tree;
  }
  CompareTree atom() {
    CompareTree tree;
    tree.left = operand();
    for (const ComparisonSign& sign : kComparisonSigns) {
      if (!tokens_.accept_sign(sign.text)) continue;
      tree.kind = CompareTree::Kind::comparison;
      tree.comparison = sign.comparison;
      tree.right = operand();
      if (tokens_.accept_sign("+")) tree.tolerance = tolerance(tree);
      return tree;
    }
    if (!tree.left.name) throw std::runtime_error("a comparison expected after a number");
    return tree;
  }
  double tolerance(const CompareTree& tree) {
    tokens_.expect_sign("-");
    if (tree.comparison != Comparison::equal) throw std::runtime_error("`+-` without `=`");
    if (tokens_.next().kind != Token::Kind::number) throw std::runtime_error("a number expected after `+-`");
    return double_of(tokens_.take().text);
  }
  CompareOperand operand() {
    CompareOperand operand;
    const bool negative = tokens_.accept_sign("-");
    if (!negative && tokens_.next().kind != Token::Kind::number && !tokens_.is_sign("+")) {
      operand.name = tokens_.dotted_name();
      return operand;
    }
    if (!negative) tokens_.accept_sign("+");
    if (tokens_.next().kind != Token::Kind::number) throw std::runtime_error("a number expected");
    const std::string text = tokens_.take().text;
    const bool special = text.find_first_of("#_") != std::string::npos;
    operand.number = double_of(text);
    operand.exact = special ? static_cast<long double>(operand.number) : std::strtold(text.c_str(), nullptr);
    if (!negative) return operand;
    operand.number = -operand.number;
    operand.exact = -operand.exact;
    return operand;
  }
  static CompareTree joined(CompareTree::Kind kind, std::vector<CompareTree> children) {
    CompareTree tree;
    tree.kind = kind;
    tree.children = std::move(children);
    return tree;
  }

  Tokens tokens_;
};

/// The number of an operand that is an integer.
std::optional<long double> integer_of(const CompareOperand& operand, const Sight& sight) {
  if (!operand.name) return {};
  if (operand.input.kind == Input::Kind::parts) {
    return static_cast<long double>(parts_at(sight.world.material, operand.input.of, operand.input.part));
  }
  if (operand.input.kind != Input::Kind::number) return {};
  return as_integer(sight.rules.model->symbols[operand.input.of].type,
                    effective(sight.world.symbols[operand.input.of]));
}

double number_of(const CompareOperand& operand, const Sight& sight) {
  return operand.name ? number_of(sight, operand.input) : operand.number;
}

bool comparison_holds(const CompareTree& tree, const Sight& sight) {
  const double left = number_of(tree.left, sight);
  const double right = number_of(tree.right, sight);
  if (tree.tolerance) return is_within(left, right, *tree.tolerance);
  const auto left_integer = integer_of(tree.left, sight);
  const auto right_integer = integer_of(tree.right, sight);
  if (left_integer && !tree.right.name) return compared(*left_integer, tree.comparison, tree.right.exact);
  if (right_integer && !tree.left.name) return compared(tree.left.exact, tree.comparison, *right_integer);
  return compared(left, tree.comparison, right);
}

double number_of(const tables::Operand& operand, const Sight& sight) {
  using Kind = tables::Operand::Kind;
  switch (operand.kind) {
    case Kind::number:
      return operand.number;
    case Kind::output:
      return number_of(sight, output_at(sight.rules, operand.of));
    case Kind::operation_value:
    case Kind::event_value:
      return number_of(sight, {Input::Kind::number, operand.of, 0});
    case Kind::parts:
      return number_of(sight, {Input::Kind::parts, operand.of, kNone});
    case Kind::weight:
      return number_of(sight, {Input::Kind::weight, operand.of, 0});
  }
  return 0;
}

}  // namespace

CompareTree parse_condition(std::string_view text) { return ConditionParser(text).parse(); }

bool holds(const CompareTree& tree, const Sight& sight) {
  const auto child_holds = [&](const CompareTree& child) { return holds(child, sight); };
  switch (tree.kind) {
    case CompareTree::Kind::truth:
      return number_of(tree.left, sight) != 0;
    case CompareTree::Kind::comparison:
      return comparison_holds(tree, sight);
    case CompareTree::Kind::negation:
      return !child_holds(tree.children[0]);
    case CompareTree::Kind::all:
      return std::all_of(tree.children.begin(), tree.children.end(), child_holds);
    case CompareTree::Kind::any:
      return std::any_of(tree.children.begin(), tree.children.end(), child_holds);
  }
  return false;
}

bool holds(const tables::Operand& left, tables::Comparison comparison, const tables::Operand& right, double tolerance,
           const Sight& sight) {
  const double a = number_of(left, sight);
  const double b = number_of(right, sight);
  return comparison == Comparison::equal ? is_within(a, b, tolerance) : compared(a, comparison, b);
}

}  // namespace symplant::reference
