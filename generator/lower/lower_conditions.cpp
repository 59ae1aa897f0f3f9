// Lowers conditions: truth tables, the symbols and units that they watch, and their readers.
#include "lower/lower_conditions.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "elements/follow/lower.hpp"
#include "elements/malfunction/lower.hpp"
#include "elements/material/lower.hpp"
#include "elements/requirement/lower.hpp"
#include "elements/value/lower.hpp"
#include "symplant/condition/truth_table.hpp"
#include "symplant/condition/type_info.hpp"

namespace symplant::lower {
namespace {

/// The elements with conditions, in the order of their rows.
constexpr std::array kElements{lower_requirements, lower_follows, lower_material, lower_malfunctions, lower_values};

/// A table that reads another table of a network, and the input.
struct Reader {
  std::uint32_t table = 0;  ///< index in the network
  std::uint8_t input = 0;
};

/// The readers of all tables except the last one, which is the whole condition.
std::vector<Reader> readers_of(const std::vector<condition::TruthTable>& network) {
  std::vector<Reader> readers(network.size());
  for (std::uint32_t t = 0; t < network.size(); ++t) {
    const auto& inputs = network[t].inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if (inputs[i].is_table) readers[inputs[i].table] = {t, static_cast<std::uint8_t>(i)};
    }
  }
  return readers;
}

class ConditionLowering {
 public:
  ConditionLowering(const model::PlantModel& plant, EngineTables& tables) : plant_(plant), tables_(tables) {}

  void run() {
    for (std::uint32_t u = 0; u < plant_.units.size(); ++u) lower_unit(u);
    lower_elements();
    add_inner_tables();
    sort_watches();
  }

 private:
  void lower_unit(std::uint32_t u) {
    const model::Unit& unit = plant_.units[u];
    if (unit.conditions.empty()) return;
    tables_.conditioned_units.push_back({u, next_condition()});
    for (const condition::Tree& tree : unit.conditions) add_condition(tree, tables::ReaderKind::unit, u, 0);
  }

  void lower_elements() {
    const AddCondition add = [this](const condition::Tree& tree, tables::ReaderKind kind, std::uint32_t row,
                                    std::uint8_t input) {
      const std::uint32_t position = next_condition();
      add_condition(tree, kind, row, input);
      return position;
    };
    for (const auto lower : kElements) lower(plant_, add, tables_);
  }

  /// The counter of the parts at a location, of a kind or of all.
  std::uint32_t counter_of(std::uint32_t location, std::uint32_t kind) {
    const auto [found, added] =
        counters_.try_emplace({location, kind}, static_cast<std::uint32_t>(tables_.material.counters.size()));
    if (added) tables_.material.counters.push_back({location, kind});
    return found->second;
  }

  std::uint32_t next_condition() const { return static_cast<std::uint32_t>(tables_.conditions.size()); }

  void add_condition(const condition::Tree& tree, tables::ReaderKind kind, std::uint32_t reader, std::uint8_t input) {
    std::vector<condition::TruthTable> network = condition::truth_tables(tree);
    const std::uint32_t position = next_condition();
    tables_.conditions.push_back({network.back().truth, reader, input, kind});
    add_watches(network.back(), position);
    if (network.size() > 1) networks_.push_back({position, std::move(network)});
  }

  void add_inner_tables() {
    for (const auto& [whole, network] : networks_) {
      const std::vector<Reader> readers = readers_of(network);
      const auto inner = static_cast<std::uint32_t>(network.size() - 1);
      const std::uint32_t first = next_condition();
      for (std::uint32_t t = 0; t < inner; ++t) {
        const Reader& reader = readers[t];
        tables_.conditions.push_back({network[t].truth, reader.table == inner ? whole : first + reader.table,
                                      reader.input, tables::ReaderKind::condition});
        add_watches(network[t], first + t);
      }
    }
  }

  void add_watches(const condition::TruthTable& table, std::uint32_t condition) {
    for (std::size_t i = 0; i < table.inputs.size(); ++i) {
      if (!table.inputs[i].is_table) add_watch(table.inputs[i].atom, condition, static_cast<std::uint8_t>(i));
    }
  }

  void add_watch(const condition::Atom& atom, std::uint32_t condition, std::uint8_t input) {
    using Kind = condition::Atom::Kind;
    switch (atom.kind) {
      case Kind::settled:
        tables_.unit_watches.push_back({atom.of, condition, atom.state, input});
        return;
      case Kind::moving:
        tables_.unit_watches.push_back({atom.of, condition, tables::kMovingState, input});
        return;
      case Kind::bit: {
        const tables::SymbolRow& symbol = tables_.symbols[atom.of];
        (symbol.direction() == tables::Direction::operation ? tables_.operation_watches : tables_.event_watches)
            .push_back({symbol.index, condition, input});
        return;
      }
      case Kind::number: {
        const tables::SymbolRow& symbol = tables_.symbols[atom.of];
        (symbol.direction() == tables::Direction::operation ? tables_.operation_value_watches
                                                            : tables_.event_value_watches)
            .push_back({atom.operand, symbol.index, condition, input, atom.comparison, atom.number});
        return;
      }
      case Kind::compare:
        tables_.values.comparisons.push_back(
            {operand(atom.left), operand(atom.right), atom.tolerance, condition, input, atom.comparison});
        return;
      case Kind::parts:
        tables_.part_watches.push_back(
            {atom.operand, counter_of(atom.of, atom.part), condition, input, atom.comparison, atom.number});
        return;
    }
  }

  tables::Operand operand(const condition::Quantity& quantity) {
    using Kind = condition::Quantity::Kind;
    switch (quantity.kind) {
      case Kind::number:
        break;
      case Kind::output:
        return {tables::Operand::Kind::output, {}, quantity.of, 0};
      case Kind::symbol: {
        const tables::SymbolRow& symbol = tables_.symbols[quantity.of];
        const bool operation = symbol.direction() == tables::Direction::operation;
        return {operation ? tables::Operand::Kind::operation_value : tables::Operand::Kind::event_value,
                condition::info_of(symbol.type()).kind, symbol.index, 0};
      }
      case Kind::parts:
        return {tables::Operand::Kind::parts, {}, counter_of(quantity.of, tables::kNone), 0};
      case Kind::weight:
        return {tables::Operand::Kind::weight, {}, quantity.of, 0};
    }
    return {tables::Operand::Kind::number, {}, 0, quantity.number};
  }

  /// Sorts watches by what they watch, then by condition and input, so that equal plants have equal tables.
  void sort_watches() {
    const auto by = [](auto& rows, auto what) {
      std::sort(rows.begin(), rows.end(), [what](const auto& a, const auto& b) {
        return std::tie(a.*what, a.condition, a.input) < std::tie(b.*what, b.condition, b.input);
      });
    };
    by(tables_.unit_watches, &tables::UnitWatch::unit);
    by(tables_.operation_watches, &tables::BitWatch::bit);
    by(tables_.event_watches, &tables::BitWatch::bit);
    by(tables_.operation_value_watches, &tables::ValueWatch::slot);
    by(tables_.event_value_watches, &tables::ValueWatch::slot);
    by(tables_.part_watches, &tables::ValueWatch::slot);
  }

  struct Network {
    std::uint32_t whole;  ///< the condition of the last table
    std::vector<condition::TruthTable> tables;
  };

  const model::PlantModel& plant_;
  EngineTables& tables_;
  std::vector<Network> networks_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> counters_;  ///< by location and kind
};

}  // namespace

void lower_conditions(const model::PlantModel& plant, EngineTables& tables) { ConditionLowering(plant, tables).run(); }

}  // namespace symplant::lower
