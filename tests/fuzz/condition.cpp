// Any text as a condition: written out it must read the same, and its truth tables must match its tree.
#include <algorithm>
#include <functional>
#include <variant>
#include <vector>

#include "description/faults.hpp"
#include "fuzz/target.hpp"
#include "model/condition_text.hpp"
#include "model/plant_names.hpp"
#include "symplant/condition/expression.hpp"
#include "symplant/condition/resolve.hpp"
#include "symplant/condition/truth_table.hpp"

namespace symplant::fuzz {
namespace {

using condition::Expression;
using condition::Fault;
using condition::Location;
using condition::Tree;

void look_at_index(const Location& index, std::string_view text) {
  require(index.offset <= text.size() && index.length <= text.size() - index.offset, "a place lies outside the text");
}

/// A number so large or small that its exponent is cut.
bool is_far(const condition::Number& number) {
  constexpr std::int64_t kFar = std::int64_t{1} << 39;
  return number.exponent > kFar || number.exponent < -kFar;
}

void look_at(const condition::Name& name, std::string_view text) {
  look_at_index(name.index, text);
  const std::string_view there = text.substr(name.index.offset, name.index.length);
  require(there.starts_with('\'') || there == name.text, "a name is not what is at its place");
}

void look_at(const Expression& expression, std::string_view text) {
  for (const condition::Name& name : expression.names) look_at(name, text);
  for (const condition::Operand& operand : expression.operands) {
    look_at_index(operand.index, text);
    for (const condition::Name& name : operand.names) look_at(name, text);
    if (operand.output) look_at(*operand.output, text);
  }
  const std::size_t operands = expression.operands.size();
  const bool compares = expression.kind == Expression::Kind::comparison;
  require(compares ? operands == 2 || operands == 3 : operands == 0, "a number of operands that cannot be");
  const bool branch = expression.kind == Expression::Kind::all || expression.kind == Expression::Kind::any;
  const std::size_t children = expression.children.size();
  require(branch ? children >= 2 : children == (expression.kind == Expression::Kind::negation ? 1 : 0),
          "a number of parts that cannot be");
  for (const Expression& child : expression.children) look_at(child, text);
}

std::string quoted(const std::string& name) {
  std::string text = "'";
  for (const char c : name) text += c == '\'' ? "''" : std::string(1, c);
  return text + "'";
}

std::string written(const std::vector<condition::Name>& names) {
  std::string text;
  for (const condition::Name& name : names) text += (text.empty() ? "" : ".") + quoted(name.text);
  return text;
}

std::string written(const condition::Operand& operand) {
  const condition::Number& number = operand.number;
  if (!operand.names.empty()) {
    return written(operand.names) + (operand.output ? "[" + operand.output->text + "]" : "");
  }
  return (number.negative ? "-" : "") + (number.digits.empty() ? "0" : number.digits) + "e" +
         std::to_string(number.exponent);
}

std::string written(const Expression& expression);

/// In parentheses if it binds less tightly than its parent.
std::string part(const Expression& child, Expression::Kind parent) {
  const bool loose = child.kind == Expression::Kind::any ||
                     (child.kind == Expression::Kind::all && parent != Expression::Kind::any) ||
                     (child.kind == Expression::Kind::negation && parent == Expression::Kind::negation);
  return loose ? "(" + written(child) + ")" : written(child);
}

std::string written(const Expression& expression) {
  constexpr const char* kComparisons[] = {"<", "<=", "=", ">=", ">"};
  std::string text;
  switch (expression.kind) {
    case Expression::Kind::name:
      return written(expression.names);
    case Expression::Kind::comparison:
      text = written(expression.operands[0]) + kComparisons[static_cast<std::size_t>(expression.comparison)] +
             written(expression.operands[1]);
      return expression.operands.size() == 2 ? text : text + "+-" + written(expression.operands[2]);
    case Expression::Kind::negation:
      return "not " + part(expression.children.front(), expression.kind);
    case Expression::Kind::all:
    case Expression::Kind::any:
      for (const Expression& child : expression.children) {
        if (!text.empty()) text += expression.kind == Expression::Kind::all ? " and " : " or ";
        text += part(child, expression.kind);
      }
      return text;
  }
  return text;
}

bool same(const std::vector<condition::Name>& a, const std::vector<condition::Name>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const condition::Name& x, const condition::Name& y) { return x.text == y.text; });
}

bool same(const condition::Operand& a, const condition::Operand& b) {
  if (!same(a.names, b.names) || a.output.has_value() != b.output.has_value()) return false;
  if (a.output && a.output->text != b.output->text) return false;
  if (is_far(a.number)) return true;
  return a.number.negative == b.number.negative && a.number.digits == b.number.digits &&
         a.number.exponent == b.number.exponent;
}

bool same(const Expression& a, const Expression& b) {
  if (a.kind != b.kind || a.children.size() != b.children.size() || !same(a.names, b.names)) return false;
  if (a.comparison != b.comparison) return false;
  const auto same_operand = [](const condition::Operand& x, const condition::Operand& y) { return same(x, y); };
  if (!std::equal(a.operands.begin(), a.operands.end(), b.operands.begin(), b.operands.end(), same_operand)) {
    return false;
  }
  const auto same = [](const Expression& x, const Expression& y) { return fuzz::same(x, y); };
  return std::equal(a.children.begin(), a.children.end(), b.children.begin(), same);
}

bool same(const Tree& a, const Tree& b) {
  if (a.kind != b.kind || a.children.size() != b.children.size()) return false;
  if (a.kind == Tree::Kind::atom && !(a.atom == b.atom)) return false;
  if (a.kind == Tree::Kind::constant && (a.value != b.value || a.atom.of != b.atom.of)) return false;
  return std::equal(a.children.begin(), a.children.end(), b.children.begin(),
                    [](const Tree& x, const Tree& y) { return same(x, y); });
}

/// The truth of an atom in one of many worlds; equal atoms have equal truths.
bool truth_of(const condition::Atom& atom, std::uint64_t world) {
  std::uint64_t mixed = world ^ std::hash<double>{}(atom.tolerance);
  for (const condition::Quantity& side : {atom.left, atom.right}) {
    mixed = mixed * 31 + std::uint64_t{side.of} * 5 + static_cast<std::uint64_t>(side.kind) +
            std::hash<double>{}(side.number);
  }
  for (const std::uint64_t part :
       {static_cast<std::uint64_t>(atom.kind), std::uint64_t{atom.of}, std::uint64_t{atom.state},
        static_cast<std::uint64_t>(atom.comparison), static_cast<std::uint64_t>(atom.number), atom.operand}) {
    mixed = (mixed ^ part ^ (mixed >> 29U)) * 0x9E3779B97F4A7C15U;
  }
  return (mixed >> 63U) != 0;
}

bool truth_of(const Tree& tree, std::uint64_t world) {
  const auto child = [world](const Tree& part) { return truth_of(part, world); };
  switch (tree.kind) {
    case Tree::Kind::constant:
      return tree.value;
    case Tree::Kind::atom:
      return truth_of(tree.atom, world);
    case Tree::Kind::negation:
      return !child(tree.children.front());
    case Tree::Kind::all:
      return std::all_of(tree.children.begin(), tree.children.end(), child);
    case Tree::Kind::any:
      return std::any_of(tree.children.begin(), tree.children.end(), child);
  }
  return false;
}

bool truth_of(const std::vector<condition::TruthTable>& tables, std::uint64_t world) {
  std::vector<bool> truths;
  for (const condition::TruthTable& table : tables) {
    require(table.inputs.size() <= condition::kMostInputs, "a table of too many inputs");
    std::uint64_t row = 0;
    for (std::size_t k = 0; k < table.inputs.size(); ++k) {
      const condition::Input& input = table.inputs[k];
      require(!input.is_table || input.table < truths.size(), "a table that stands behind its reader");
      const bool truth = input.is_table ? truths[input.table] : truth_of(input.atom, world);
      row |= std::uint64_t{truth} << k;
    }
    truths.push_back((table.truth >> row & 1U) != 0);
  }
  require(!truths.empty(), "a condition without a table");
  return truths.back();
}

void look_at_meaning(std::string_view text, const model::PlantNames& names) {
  const auto resolved = condition::parse_and_resolve(text, names);
  if (const auto* fault = std::get_if<Fault>(&resolved)) {
    look_at_index(fault->index, text);
    return;
  }
  const Tree& tree = std::get<Tree>(resolved);
  const auto again = condition::parse_and_resolve(model::condition_text(tree, fixed_plant()), names);
  require(std::holds_alternative<Tree>(again), "what a condition is written as is refused");
  require(same(tree, std::get<Tree>(again)), "what a condition is written as is another");
  const auto tables = condition::truth_tables(tree);
  for (std::uint64_t world = 1; world <= 16; ++world) {
    require(truth_of(tree, world) == truth_of(tables, world), "truth tables say other than the tree");
  }
}

}  // namespace
}  // namespace symplant::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symplant;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto parsed = condition::parse(text);
  if (const auto* fault = std::get_if<condition::Fault>(&parsed)) {
    fuzz::look_at_index(fault->index, text);
    fuzz::require(!fault->message.empty(), "a fault without words");
    return 0;
  }
  const auto& expression = std::get<condition::Expression>(parsed);
  fuzz::look_at(expression, text);
  const auto again = condition::parse(fuzz::written(expression));
  fuzz::require(std::holds_alternative<condition::Expression>(again), "what a condition is written as is no condition");
  fuzz::require(fuzz::same(expression, std::get<condition::Expression>(again)), "written and read, it is another");

  static std::vector<description::DescriptionFault> found;
  static std::vector<description::DescriptionFault> warned;
  static const description::Faults faults{found, warned};
  static const model::PlantNames names{fuzz::fixed_plant(), faults};
  fuzz::look_at_meaning(text, names);
  return 0;
}
