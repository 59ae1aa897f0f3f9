// Evaluates conditions and expectations of a scenario.
#include "symplant/scenario/evaluate.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "symplant/condition/type_info.hpp"
#include "symplant/tables/compare.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::scenario {
namespace {

double number_of(const condition::Quantity& quantity, const plant::Plant& plant) noexcept {
  switch (quantity.kind) {
    case condition::Quantity::Kind::number:
      break;
    case condition::Quantity::Kind::output:
      return plant.output(quantity.of);
    case condition::Quantity::Kind::symbol:
      return tables::number_of(condition::info_of(quantity.type).kind, value_of(plant, quantity.of));
    case condition::Quantity::Kind::parts:
      return static_cast<double>(plant.parts(quantity.of));
    case condition::Quantity::Kind::weight:
      return plant.weight(quantity.of);
  }
  return quantity.number;
}

bool holds(const condition::Atom& atom, const plant::Plant& plant) noexcept {
  switch (atom.kind) {
    case condition::Atom::Kind::settled: {
      const plant::UnitView unit = plant.unit(atom.of);
      return !unit.moving && unit.state == atom.state;
    }
    case condition::Atom::Kind::moving:
      return plant.unit(atom.of).moving;
    case condition::Atom::Kind::bit:
      return value_of(plant, atom.of) != 0;
    case condition::Atom::Kind::parts:
      return tables::holds({atom.operand, 0, 0, 0, atom.comparison, atom.number}, parts_at(plant, atom.of, atom.part));
    case condition::Atom::Kind::compare:
      return tables::compares_near(number_of(atom.left, plant), atom.comparison, number_of(atom.right, plant),
                                   atom.tolerance);
    case condition::Atom::Kind::number:
      break;
  }
  return tables::holds({atom.operand, 0, 0, 0, atom.comparison, atom.number}, value_of(plant, atom.of));
}

}  // namespace

std::uint64_t value_of(const plant::Plant& plant, std::uint32_t symbol) noexcept {
  const tables::SymbolRow& row = plant.tables().symbols[symbol];
  const bool operation = row.direction() == tables::Direction::operation;
  if (row.type() == tables::DataType::boolean) {
    return (operation ? plant.operation(row.index) : plant.event(row.index)) ? 1 : 0;
  }
  return operation ? plant.operation_value(row.index) : plant.event_value(row.index);
}

std::uint64_t parts_at(const plant::Plant& plant, std::uint32_t location, std::uint32_t kind) noexcept {
  const std::uint32_t all = plant.parts(location);
  if (kind == tables::kNone) return all;
  std::uint64_t count = 0;
  for (std::uint32_t i = 0; i < all; ++i) count += plant.part(location, i).kind == kind ? 1U : 0U;
  return count;
}

bool equal_values(tables::DataType type, std::uint64_t a, std::uint64_t b) noexcept {
  if (!trace::is_real(type)) return a == b;
  const double x = std::bit_cast<double>(a);
  const double y = std::bit_cast<double>(b);
  return x == y || (std::isnan(x) && std::isnan(y));
}

bool holds(const condition::Tree& tree, const plant::Plant& plant) noexcept {
  const auto holds_here = [&plant](const condition::Tree& child) { return holds(child, plant); };
  switch (tree.kind) {
    case condition::Tree::Kind::constant:
      return tree.value;
    case condition::Tree::Kind::atom:
      return holds(tree.atom, plant);
    case condition::Tree::Kind::negation:
      return !holds(tree.children.front(), plant);
    case condition::Tree::Kind::all:
      return std::all_of(tree.children.begin(), tree.children.end(), holds_here);
    case condition::Tree::Kind::any:
      break;
  }
  return std::any_of(tree.children.begin(), tree.children.end(), holds_here);
}

bool holds(const Expectation& expectation, const plant::Plant& plant) noexcept {
  if (expectation.condition && !holds(*expectation.condition, plant)) return false;
  return std::all_of(expectation.values.begin(), expectation.values.end(), [&](const SymbolValue& wanted) {
    return equal_values(plant.tables().symbols[wanted.symbol].type(), value_of(plant, wanted.symbol), wanted.value);
  });
}

}  // namespace symplant::scenario
