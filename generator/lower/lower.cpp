// The one lowering.
#include "lower/lower.hpp"

#include <map>
#include <tuple>

#include "lower/type_table.hpp"
#include "model/classify.hpp"

namespace symplant::lower {
namespace {

using model::kNone;

/// Deals out bits of a plane so that those of one unit lie in one word.
class BitPlane {
 public:
  std::uint32_t take(std::size_t count) {
    if (used_ % 64 + count > 64) used_ = (used_ + 63) / 64 * 64;
    const auto first = static_cast<std::uint32_t>(used_);
    used_ += count;
    return first;
  }
  std::uint32_t size() const { return static_cast<std::uint32_t>((used_ + 63) / 64 * 64); }

 private:
  std::size_t used_ = 0;
};

core::AddressForm form_of(const model::Symbol& symbol) {
  if (!symbol.address) return core::AddressForm::none;
  // An address of another size than the symbol's is a fault that the checks report; it has no place on a link.
  if (static_cast<int>(symbol.address->size) != model::data_type_bits(symbol.type)) return core::AddressForm::none;
  if (!symbol.address->plain || symbol.address->number > 0xFFFF'FFFF) return core::AddressForm::other;
  return core::AddressForm::number;
}

class Lowering {
 public:
  explicit Lowering(const model::PlantModel& plant) : plant_(plant) {}

  EngineTables run() {
    tables_.name = plant_.name;
    tables_.list = plant_.list_name();
    lower_units();
    lower_symbols();
    lower_state_names();
    tables_.operation_bits = operations_.size();
    tables_.event_bits = events_.size();
    tables_.finish();
    return std::move(tables_);
  }

 private:
  void lower_units() {
    symbol_index_.assign(plant_.symbols.size(), kNone);
    tables_.units.reserve(plant_.units.size());
    for (std::uint32_t u = 0; u < plant_.units.size(); ++u) {
      const model::Unit& unit = plant_.units[u];
      core::UnitRow row{};
      row.type = types_.type_of(plant_, u, tables_.types);
      row.operation_bit = operations_.take(unit.operations.size());
      row.event_bit = events_.take(unit.events.size());
      row.times = times_of(row.type, unit);
      row.initial = static_cast<std::uint8_t>(unit.initial);
      for (std::uint32_t i = 0; i < unit.operations.size(); ++i) {
        symbol_index_[unit.operations[i]] = row.operation_bit + i;
      }
      for (std::uint32_t i = 0; i < unit.events.size(); ++i) symbol_index_[unit.events[i]] = row.event_bit + i;
      tables_.units.push_back(row);
      tables_.unit_names.append(unit.path).push_back('\0');
    }
  }

  /// Units with equal times share their entries.
  std::uint32_t times_of(std::uint32_t type, const model::Unit& unit) {
    std::vector<std::int64_t> key{type};
    for (const model::Transition& t : unit.transitions) key.insert(key.end(), {t.after, t.takes});
    const auto [found, added] = times_.try_emplace(std::move(key), static_cast<std::uint32_t>(tables_.times.size()));
    if (added) {
      tables_.times.push_back({0, model::kDefaultTravel});
      for (const model::Transition& t : unit.transitions) tables_.times.push_back({t.after, t.takes});
    }
    return found->second;
  }

  void lower_symbols() {
    tables_.symbols.reserve(plant_.symbols.size());
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      const model::Symbol& symbol = plant_.symbols[i];
      core::SymbolRow row{};
      row.index = index_of(i);
      row.unit = symbol.unit == kNone ? core::kNoUnit : symbol.unit;
      const core::AddressForm form = form_of(symbol);
      row.number = form == core::AddressForm::number ? static_cast<std::uint32_t>(symbol.address->number) : 0;
      row.row = symbol.row->line;
      row.kind = core::symbol_kind(symbol.type, symbol.direction, form, moved(i));
      tables_.symbols.push_back(row);
      tables_.symbol_names.append(symbol.name()).push_back('\0');
      tables_.symbol_names.append(symbol.written_address()).push_back('\0');
      if (follows(symbol)) tables_.shared_addresses.push_back({i, symbol.leader});
      if (keeps_initial(symbol)) tables_.initial_values.push_back({i, symbol.initial});
    }
  }

  /// An operation moves its unit; an event is moved by it.
  bool moved(std::uint32_t i) const {
    const model::Symbol& symbol = plant_.symbols[i];
    if (symbol.unit == kNone) return false;
    const model::Unit& unit = plant_.units[symbol.unit];
    if (symbol.direction == core::Direction::operation) return unit.moves();
    const std::uint32_t place = symbol_index_[i] - tables_.units[symbol.unit].event_bit;
    return unit.moves_event(place);
  }

  std::uint32_t index_of(std::uint32_t i) {
    const model::Symbol& symbol = plant_.symbols[i];
    const bool operation = symbol.direction == core::Direction::operation;
    if (symbol.type != core::DataType::boolean) {
      return operation ? tables_.operation_slots++ : tables_.event_slots++;
    }
    if (symbol_index_[i] != kNone) return symbol_index_[i];
    return (operation ? operations_ : events_).take(1);
  }

  /// Kept equal by the engine. Numbers of different types on one address are told apart by the links, which know how
  /// each type reads the same register.
  bool follows(const model::Symbol& symbol) const {
    return symbol.leader != kNone && plant_.symbols[symbol.leader].type == symbol.type;
  }

  /// Numeric symbols and unmodelled BOOL events stand at their Initial, unless they follow another.
  bool keeps_initial(const model::Symbol& symbol) const {
    if (symbol.initial == 0 || follows(symbol)) return false;
    if (symbol.type != core::DataType::boolean) return true;
    return symbol.direction == core::Direction::event && symbol.unit == kNone;
  }

  void lower_state_names() {
    for (const Type& type : tables_.types) {
      for (const model::State& state : plant_.units[type.example].states) {
        tables_.state_names.append(state.name).push_back('\0');
      }
    }
  }

  const model::PlantModel& plant_;
  EngineTables tables_;
  TypeTable types_;
  BitPlane operations_;
  BitPlane events_;
  std::vector<std::uint32_t> symbol_index_;
  std::map<std::vector<std::int64_t>, std::uint32_t> times_;
};

}  // namespace

EngineTables lower(const model::PlantModel& plant) { return Lowering(plant).run(); }

}  // namespace symplant::lower
