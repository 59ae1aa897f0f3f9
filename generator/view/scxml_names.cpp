// Names and conditions in SCXML.
#include "view/scxml_names.hpp"

#include <fmt/format.h>

#include "model/condition_text.hpp"
#include "text/identifier.hpp"

namespace symplant::view {
namespace {

using condition::Atom;
using condition::Quantity;
using condition::Tree;

std::string_view operator_text(tables::Comparison comparison) {
  return comparison == tables::Comparison::equal ? "==" : model::comparison_text(comparison);
}

}  // namespace

ScxmlNames::ScxmlNames(const model::PlantModel& plant) {
  text::IdentifierScope scope;
  scope.unique("plant");
  for (const model::Unit& unit : plant.units) {
    units_.push_back(scope.unique(unit.path));
    text::IdentifierScope own;
    std::vector<std::string>& states = states_.emplace_back();
    for (const model::State& state : unit.states) states.push_back(own.unique(state.name));
  }
  for (const model::Symbol& symbol : plant.symbols) symbols_.push_back(scope.unique(symbol.name()));
  for (std::uint32_t i = 0; i < plant.material.locations(); ++i) {
    locations_.push_back(scope.unique(plant.material.location_name(i)));
  }
  for (const model::PartKind& kind : plant.material.kinds) kinds_.push_back(scope.unique(kind.name));
}

std::string ScxmlNames::parts(const condition::Atom& atom) const {
  std::string variable = "parts_" + locations_[atom.of];
  if (atom.part != model::kNone) variable.append("_").append(kinds_[atom.part]);
  return variable;
}

std::string ScxmlNames::side(const Quantity& quantity, std::vector<std::string>& variables) const {
  switch (quantity.kind) {
    case Quantity::Kind::number:
      return fmt::format("{}", quantity.number);
    case Quantity::Kind::output:
      variables.push_back(fmt::format("output_{}", quantity.of));
      break;
    case Quantity::Kind::symbol:
      variables.push_back(variable(quantity.of));
      break;
    case Quantity::Kind::parts:
      variables.push_back("parts_" + locations_[quantity.of]);
      break;
    case Quantity::Kind::weight:
      variables.push_back("weight_" + locations_[quantity.of]);
      break;
  }
  return variables.back();
}

std::string ScxmlNames::compared(const Atom& atom, std::vector<std::string>& variables) const {
  const std::string left = side(atom.left, variables);
  const std::string right = side(atom.right, variables);
  if (atom.tolerance == 0) return fmt::format("{} {} {}", left, operator_text(atom.comparison), right);
  return fmt::format("Math.abs({} - ({})) <= {}", left, right, atom.tolerance);
}

std::string ScxmlNames::expression(const Tree& tree, std::vector<std::string>& variables) const {
  switch (tree.kind) {
    case Tree::Kind::constant:
      return tree.value ? "true" : "false";
    case Tree::Kind::negation: {
      const std::string child = expression(tree.children.front(), variables);
      return "!(" + child + ")";
    }
    case Tree::Kind::all:
    case Tree::Kind::any: {
      std::string text;
      for (const Tree& child : tree.children) {
        const bool in_parentheses = child.kind == Tree::Kind::all || child.kind == Tree::Kind::any;
        const std::string part = expression(child, variables);
        text.append(text.empty() ? "" : tree.kind == Tree::Kind::all ? " && " : " || ");
        text.append(in_parentheses ? "(" + part + ")" : part);
      }
      return text;
    }
    case Tree::Kind::atom:
      break;
  }
  switch (tree.atom.kind) {
    case Atom::Kind::settled:
      return "In('" + state(tree.atom.of, tree.atom.state) + "')";
    case Atom::Kind::moving:
      variables.push_back(moving(tree.atom.of));
      return variables.back();
    case Atom::Kind::bit:
      variables.push_back(variable(tree.atom.of));
      return variables.back();
    case Atom::Kind::number:
      variables.push_back(variable(tree.atom.of));
      return fmt::format("{} {} {}", variables.back(), operator_text(tree.atom.comparison),
                         model::operand_text(tree.atom));
    case Atom::Kind::compare:
      return compared(tree.atom, variables);
    case Atom::Kind::parts:
      variables.push_back(parts(tree.atom));
      return fmt::format("{} {} {}", variables.back(), operator_text(tree.atom.comparison),
                         model::operand_text(tree.atom));
  }
  return "";
}

}  // namespace symplant::view
