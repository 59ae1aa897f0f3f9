// Lowers symbols: their slots in the planes, their initial values and the symbols that they follow.
#include "lower/lower_symbols.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/large_memory.hpp"
#include "model/classify.hpp"

namespace symplant::lower {
namespace {

using model::kNone;

tables::AddressForm form_of(const model::Symbol& symbol) {
  if (!symbol.address) return tables::AddressForm::none;
  if (symbol.address->area == address::Area::memory) return tables::AddressForm::internal;
  // The checks report an address whose size differs from the symbol's; it has no number on a link.
  if (static_cast<int>(symbol.address->size) != model::data_type_bits(symbol.type)) return tables::AddressForm::none;
  if (!symbol.address->plain || symbol.address->number > 0xFFFF'FFFF) return tables::AddressForm::other;
  return tables::AddressForm::number;
}

class SymbolLowering {
 public:
  SymbolLowering(const model::PlantModel& plant, const std::vector<std::uint32_t>& symbol_bits, BitPlane& operations,
                 BitPlane& events, EngineTables& tables)
      : plant_(plant), symbol_bits_(symbol_bits), operations_(operations), events_(events), tables_(tables) {}

  void run() {
    find_leaders_of_types();
    base::reserve_large(tables_.symbols, plant_.symbols.size());
    std::size_t text = 0;  // an upper bound: no name is longer than its row
    for (const model::PlantList& list : plant_.lists) text += list.table->source->text().size();
    base::reserve_large(tables_.symbol_names, text);
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      const model::Symbol& symbol = plant_.symbols[i];
      tables::SymbolRow row{};
      row.index = index_of(i);
      row.unit = symbol.unit;
      const tables::AddressForm form = form_of(symbol);
      row.number = form == tables::AddressForm::number ? static_cast<std::uint32_t>(symbol.address->number) : 0;
      row.row = symbol.row->line;
      row.kind = tables::symbol_kind(symbol.type, symbol.direction, form, moved(i), symbol.inverted);
      tables_.symbols.push_back(row);
      tables_.symbol_names.append(symbol.name()).push_back('\0');
      tables_.symbol_names.append(symbol.written_address()).push_back('\0');
      if (const std::uint32_t leader = leader_of(i); leader != i) tables_.shared_addresses.push_back({i, leader});
      if (keeps_initial(i)) tables_.initial_values.push_back({i, initial_of(symbol)});
    }
  }

 private:
  std::uint32_t index_of(std::uint32_t i) {
    const model::Symbol& symbol = plant_.symbols[i];
    const bool operation = symbol.direction == tables::Direction::operation;
    if (symbol.type != tables::DataType::boolean) {
      return operation ? tables_.operation_slots++ : tables_.event_slots++;
    }
    if (symbol_bits_[i] != kNone) return symbol_bits_[i];
    return (operation ? operations_ : events_).take(1);
  }

  /// The position of an event in its unit.
  std::uint32_t location_of(std::uint32_t event) const {
    return symbol_bits_[event] - tables_.units[plant_.symbols[event].unit].event_bit;
  }

  /// Whether a symbol acts: an operation of a unit that moves, or an event that its unit or a condition drives.
  bool moved(std::uint32_t i) const {
    const model::Symbol& symbol = plant_.symbols[i];
    if (symbol.driven_without_unit()) return true;
    if (symbol.unit == kNone) return false;
    const model::Unit& unit = plant_.units[symbol.unit];
    if (symbol.direction == tables::Direction::operation) return unit.moves();
    return unit.moves_event(location_of(i));
  }

  /// The symbol that the engine keeps this one equal to; itself if it leads. Numbers of different types on one address
  /// have a leader for each type, the first: the links know how each type reads the same register.
  std::uint32_t leader_of(std::uint32_t i) const {
    const model::Symbol& symbol = plant_.symbols[i];
    if (symbol.leader == kNone) return i;
    if (plant_.symbols[symbol.leader].type == symbol.type) return symbol.leader;
    const auto first = first_of_type_.find({symbol.leader, symbol.type});
    return first == first_of_type_.end() ? i : first->second;
  }

  void find_leaders_of_types() {
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      const model::Symbol& symbol = plant_.symbols[i];
      if (symbol.leader == kNone || plant_.symbols[symbol.leader].type == symbol.type) continue;
      first_of_type_.try_emplace({symbol.leader, symbol.type}, i);
    }
  }

  /// The Initial in the form of tables::InitialValue.
  static std::uint64_t initial_of(const model::Symbol& symbol) {
    if (symbol.type != tables::DataType::boolean) return symbol.initial;
    return (symbol.initial != 0) != symbol.inverted ? 1 : 0;
  }

  /// Whether a symbol starts with its Initial: a numeric symbol or a BOOL event of no state that follows no other and
  /// no condition, and that no part drives.
  bool keeps_initial(std::uint32_t i) const {
    const model::Symbol& symbol = plant_.symbols[i];
    if (initial_of(symbol) == 0 || leader_of(i) != i || symbol.driven_without_unit()) return false;
    if (symbol.type != tables::DataType::boolean) return true;
    if (symbol.direction == tables::Direction::operation) return false;
    return symbol.unit == kNone || !set_at_start(i);
  }

  /// Whether its unit decides how an event starts: it or an event on its address belongs to a state, or entering the
  /// initial state switches it.
  bool set_at_start(std::uint32_t event) const {
    const model::Unit& unit = plant_.units[plant_.symbols[event].unit];
    const std::uint64_t mask = std::uint64_t{1} << location_of(event);
    const std::vector<tables::EventMasks>& enter = tables_.types[tables_.units[plant_.symbols[event].unit].type].enter;
    const tables::EventMasks& first = enter[unit.initial];
    if (((first.on | first.off) & mask) != 0) return true;
    return std::any_of(unit.states.begin(), unit.states.end(), [&](const model::State& state) {
      if (state.event == kNone) return false;
      const std::uint32_t symbol = unit.events[state.event];
      return symbol == event || plant_.symbols[symbol].leader == event;
    });
  }

  const model::PlantModel& plant_;
  const std::vector<std::uint32_t>& symbol_bits_;
  BitPlane& operations_;
  BitPlane& events_;
  EngineTables& tables_;
  std::map<std::pair<std::uint32_t, tables::DataType>, std::uint32_t> first_of_type_;  ///< by the address leader
};

}  // namespace

void lower_symbols(const model::PlantModel& plant, const std::vector<std::uint32_t>& symbol_bits, BitPlane& operations,
                   BitPlane& events, EngineTables& tables) {
  SymbolLowering(plant, symbol_bits, operations, events, tables).run();
}

}  // namespace symplant::lower
