// Evaluates conditions by walking their trees.
#include <bit>

#include "support/reference/material.hpp"
#include "support/reference/value_condition.hpp"

namespace symplant::reference {
namespace {

template <class Number>
bool compares(Number value, tables::Comparison comparison, Number operand) {
  switch (comparison) {
    case tables::Comparison::less:
      return value < operand;
    case tables::Comparison::less_equal:
      return value <= operand;
    case tables::Comparison::equal:
      return value == operand;
    case tables::Comparison::greater_equal:
      return value >= operand;
    case tables::Comparison::greater:
      return value > operand;
  }
  return false;
}

bool number_holds(const condition::Atom& atom, std::uint64_t value) {
  switch (atom.number) {
    case tables::NumberKind::signed_integer:
      return compares(static_cast<std::int64_t>(value), atom.comparison, static_cast<std::int64_t>(atom.operand));
    case tables::NumberKind::unsigned_integer:
      return compares(value, atom.comparison, atom.operand);
    case tables::NumberKind::real:
      return compares(std::bit_cast<double>(value), atom.comparison, std::bit_cast<double>(atom.operand));
  }
  return false;
}

/// The other numbering of the same side: outputs in the order of all outputs, numeric symbols by their index.
tables::Operand operand_of(const condition::Quantity& quantity) {
  using Kind = tables::Operand::Kind;
  switch (quantity.kind) {
    case condition::Quantity::Kind::number:
      break;
    case condition::Quantity::Kind::output:
      return {Kind::output, {}, quantity.of, 0};
    case condition::Quantity::Kind::symbol:
      return {Kind::event_value, {}, quantity.of, 0};
    case condition::Quantity::Kind::parts:
      return {Kind::parts, {}, quantity.of, 0};
    case condition::Quantity::Kind::weight:
      return {Kind::weight, {}, quantity.of, 0};
  }
  return {Kind::number, {}, 0, quantity.number};
}

bool sides_hold(const condition::Atom& atom, const World& world) {
  return holds(operand_of(atom.left), atom.comparison, operand_of(atom.right), atom.tolerance, {*world.rules, world});
}

bool atom_holds(const condition::Atom& atom, const World& world) {
  switch (atom.kind) {
    case condition::Atom::Kind::settled:
      return !world.units[atom.of].moving && world.units[atom.of].state == atom.state;
    case condition::Atom::Kind::moving:
      return world.units[atom.of].moving;
    case condition::Atom::Kind::bit:
      return effective(world.symbols[atom.of]) != 0;
    case condition::Atom::Kind::number:
      return number_holds(atom, effective(world.symbols[atom.of]));
    case condition::Atom::Kind::compare:
      return sides_hold(atom, world);
    case condition::Atom::Kind::parts:
      return number_holds(atom, parts_at(world.material, atom.of, atom.part));
  }
  return false;
}

}  // namespace

std::uint64_t effective(const SymbolWorld& symbol) {
  if (symbol.forced) return symbol.forced_value;
  if (symbol.broken.kind == SymbolOverride::Kind::value) return symbol.broken.value;
  return symbol.broken.kind == SymbolOverride::Kind::opposite ? symbol.value ^ 1 : symbol.value;
}

bool is_on(const Rules& rules, const World& world, std::uint32_t symbol) {
  return rules.turned(symbol, effective(world.symbols[symbol])) != 0;
}

bool holds(const condition::Tree& tree, const World& world) {
  switch (tree.kind) {
    case condition::Tree::Kind::constant:
      return tree.value;
    case condition::Tree::Kind::atom:
      return atom_holds(tree.atom, world);
    case condition::Tree::Kind::negation:
      return !holds(tree.children[0], world);
    case condition::Tree::Kind::all:
      for (const condition::Tree& child : tree.children) {
        if (!holds(child, world)) return false;
      }
      return true;
    case condition::Tree::Kind::any:
      for (const condition::Tree& child : tree.children) {
        if (holds(child, world)) return true;
      }
      return false;
  }
  return false;
}

}  // namespace symplant::reference
