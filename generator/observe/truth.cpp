// Whether a condition holds, as far as it is known.
#include "observe/truth.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace symplant::observe {
namespace {

using condition::Atom;
using condition::Quantity;
using condition::Tree;
using tables::Comparison;

bool compares(Comparison comparison, double left, double right, double tolerance) {
  switch (comparison) {
    case Comparison::less:
      return left < right;
    case Comparison::less_equal:
      return left <= right;
    case Comparison::equal:
      return std::abs(left - right) <= tolerance;
    case Comparison::greater_equal:
      return left >= right;
    case Comparison::greater:
      return left > right;
  }
  return false;
}

double operand_of(const Atom& atom) {
  switch (atom.number) {
    case tables::NumberKind::signed_integer:
      return static_cast<double>(static_cast<std::int64_t>(atom.operand));
    case tables::NumberKind::unsigned_integer:
      return static_cast<double>(atom.operand);
    case tables::NumberKind::real:
      return std::bit_cast<double>(atom.operand);
  }
  return 0;
}

std::optional<double> quantity(const Quantity& of, const Known& known) {
  if (of.kind == Quantity::Kind::number) return of.number;
  return of.kind == Quantity::Kind::symbol ? known.value(of.of) : std::nullopt;
}

std::optional<bool> atom_holds(const Atom& atom, const Known& known) {
  switch (atom.kind) {
    case Atom::Kind::settled:
      return known.settled(atom.of, atom.state);
    case Atom::Kind::moving:
      return known.moving(atom.of);
    case Atom::Kind::bit: {
      const auto value = known.value(atom.of);
      return value ? std::optional(*value != 0) : std::nullopt;
    }
    case Atom::Kind::number: {
      const auto value = known.value(atom.of);
      return value ? std::optional(compares(atom.comparison, *value, operand_of(atom), 0)) : std::nullopt;
    }
    case Atom::Kind::compare: {
      const auto left = quantity(atom.left, known);
      const auto right = quantity(atom.right, known);
      if (!left || !right) return std::nullopt;
      return compares(atom.comparison, *left, *right, atom.tolerance);
    }
    case Atom::Kind::parts:
      return std::nullopt;
  }
  return std::nullopt;
}

/// `decides`: the value of one child that decides the whole.
std::optional<bool> joined(const Tree& tree, const Known& known, bool decides) {
  bool all_known = true;
  for (const Tree& child : tree.children) {
    const auto value = holds(child, known);
    if (value == decides) return decides;
    all_known = all_known && value.has_value();
  }
  return all_known ? std::optional(!decides) : std::nullopt;
}

}  // namespace

std::optional<bool> holds(const Tree& tree, const Known& known) {
  switch (tree.kind) {
    case Tree::Kind::constant:
      return tree.value;
    case Tree::Kind::atom:
      return atom_holds(tree.atom, known);
    case Tree::Kind::negation: {
      const auto value = holds(tree.children.front(), known);
      return value ? std::optional(!*value) : std::nullopt;
    }
    case Tree::Kind::all:
      return joined(tree, known, false);
    case Tree::Kind::any:
      return joined(tree, known, true);
  }
  return std::nullopt;
}

}  // namespace symplant::observe
