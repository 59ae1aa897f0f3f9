// The conditions of a plant's tables, read backward: from a condition to what it reads.
#include "symplant/why/conditions.hpp"

#include <algorithm>
#include <tuple>

namespace symplant::why {
namespace {

using condition::Atom;
using tables::PlantTables;

/// The symbols of a plane, by bit or slot.
std::vector<std::uint32_t> symbols_by_index(const PlantTables& tables, tables::Direction direction, bool bits) {
  std::vector<std::uint32_t> symbols;
  for (std::uint32_t s = 0; s < tables.symbols.size(); ++s) {
    const tables::SymbolRow& row = tables.symbols[s];
    if (row.direction() != direction || (row.type() == tables::DataType::boolean) != bits) continue;
    if (symbols.size() <= row.index) symbols.resize(row.index + 1, tables::kNone);
    symbols[row.index] = s;
  }
  return symbols;
}

Atom atom_of(const tables::UnitWatch& watch) {
  Atom atom;
  atom.kind = watch.state == tables::kMovingState ? Atom::Kind::moving : Atom::Kind::settled;
  atom.of = watch.unit;
  atom.state = watch.state == tables::kMovingState ? std::uint8_t{0} : watch.state;
  return atom;
}

Atom atom_of(const tables::ValueWatch& watch, Atom::Kind kind, std::uint32_t of) {
  Atom atom;
  atom.kind = kind;
  atom.of = of;
  atom.comparison = watch.comparison;
  atom.number = watch.kind;
  atom.operand = watch.operand;
  return atom;
}

/// Symbols by slot.
struct Slots {
  std::vector<std::uint32_t> operations;
  std::vector<std::uint32_t> events;
};

condition::Quantity quantity_of(const tables::Operand& operand, const PlantTables& tables, const Slots& slots) {
  using Kind = condition::Quantity::Kind;
  const auto symbol = [&](const std::vector<std::uint32_t>& symbols) {
    const std::uint32_t index = symbols[operand.of];
    return condition::Quantity{Kind::symbol, index, tables.symbols[index].type()};
  };
  switch (operand.kind) {
    case tables::Operand::Kind::number:
      break;
    case tables::Operand::Kind::output:
      return {Kind::output, operand.of};
    case tables::Operand::Kind::operation_value:
      return symbol(slots.operations);
    case tables::Operand::Kind::event_value:
      return symbol(slots.events);
    case tables::Operand::Kind::parts:
      return {Kind::parts, tables.material.counters[operand.of].location};
    case tables::Operand::Kind::weight:
      return {Kind::weight, operand.of};
  }
  return {Kind::number, 0, tables::DataType::boolean, operand.number};
}

/// The comparison of a row.
Atom atom_of(const tables::ComparisonRow& row, const PlantTables& tables, const Slots& slots) {
  Atom atom;
  atom.kind = Atom::Kind::compare;
  atom.comparison = row.comparison;
  atom.left = quantity_of(row.left, tables, slots);
  atom.right = quantity_of(row.right, tables, slots);
  atom.tolerance = row.tolerance;
  return atom;
}

}  // namespace

Conditions::Conditions(const PlantTables& tables) : tables_(tables) {
  const auto add_atom = [this](const auto& watch, const Atom& atom) {
    wires_.push_back({watch.condition, watch.input, {false, 0, atom}});
  };
  for (const tables::UnitWatch& watch : tables.unit_watches) add_atom(watch, atom_of(watch));
  for (const auto direction : {tables::Direction::operation, tables::Direction::event}) {
    const bool operation = direction == tables::Direction::operation;
    const auto bits = symbols_by_index(tables, direction, true);
    for (const tables::BitWatch& watch : operation ? tables.operation_watches : tables.event_watches) {
      Atom atom;
      atom.kind = Atom::Kind::bit;
      atom.of = bits[watch.bit];
      add_atom(watch, atom);
    }
    const auto slots = symbols_by_index(tables, direction, false);
    for (const tables::ValueWatch& watch : operation ? tables.operation_value_watches : tables.event_value_watches) {
      add_atom(watch, atom_of(watch, Atom::Kind::number, slots[watch.slot]));
    }
  }
  for (const tables::ValueWatch& watch : tables.part_watches) {
    const tables::PartCounterRow& counter = tables.material.counters[watch.slot];
    Atom atom = atom_of(watch, Atom::Kind::parts, counter.location);
    atom.part = counter.kind;
    add_atom(watch, atom);
  }
  if (!tables.values.comparisons.empty()) {
    const Slots slots{symbols_by_index(tables, tables::Direction::operation, false),
                      symbols_by_index(tables, tables::Direction::event, false)};
    for (const tables::ComparisonRow& row : tables.values.comparisons) add_atom(row, atom_of(row, tables, slots));
  }
  for (std::uint32_t c = 0; c < tables.conditions.size(); ++c) {
    const tables::ConditionRow& row = tables.conditions[c];
    if (row.reader_kind != tables::ReaderKind::condition) continue;
    wires_.push_back({row.reader, row.reader_input, {true, c, {}}});
  }
  std::sort(wires_.begin(), wires_.end(), [](const Wire& a, const Wire& b) {
    return std::tie(a.condition, a.input) < std::tie(b.condition, b.input);
  });
}

Network Conditions::network(std::uint32_t condition) const {
  Network network;
  add(condition, network);
  return network;
}

/// Adds a condition after those that it reads; returns its index.
std::uint32_t Conditions::add(std::uint32_t condition, Network& network) const {
  condition::TruthTable table{tables_.conditions[condition].truth, {}};
  auto wire = std::partition_point(wires_.begin(), wires_.end(),
                                   [condition](const Wire& other) { return other.condition < condition; });
  for (; wire != wires_.end() && wire->condition == condition; ++wire) {
    table.inputs.push_back(wire->from);
    if (wire->from.is_table) table.inputs.back().table = add(wire->from.table, network);
  }
  network.push_back(std::move(table));
  return static_cast<std::uint32_t>(network.size() - 1);
}

}  // namespace symplant::why
