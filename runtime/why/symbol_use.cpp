// How the plant uses each I/O symbol: what reads an operation, what drives an event.
#include "symplant/why/symbol_use.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

namespace symplant::why {
namespace {

using tables::PlantTables;

/// The track that has a row of one of its tables.
template <class RowsOf>
std::uint32_t track_with(const tables::MaterialTables& material, std::uint32_t row, RowsOf rows_of) {
  const auto begins_before = [&](std::uint32_t index, const tables::TrackRow& track) {
    return index < rows_of(track).first + rows_of(track).count;
  };
  return static_cast<std::uint32_t>(
      std::upper_bound(material.tracks.begin(), material.tracks.end(), row, begins_before) - material.tracks.begin());
}

SymbolReader reader_in_material(const tables::MaterialTables& material, const tables::ConditionRow& row) {
  switch (row.reader_kind) {
    case tables::ReaderKind::transfer:
      return {SymbolReader::Kind::transfer, row.reader};
    case tables::ReaderKind::work:
      return {SymbolReader::Kind::work, row.reader};
    case tables::ReaderKind::source:
      return {SymbolReader::Kind::source, row.reader};
    default:
      break;
  }
  return {SymbolReader::Kind::track, track_with(material, row.reader, [&](const tables::TrackRow& track) {
            return row.reader_kind == tables::ReaderKind::drive  ? track.drives
                   : row.reader_kind == tables::ReaderKind::stop ? track.stops
                                                                 : track.ends;
          })};
}

bool has(const tables::Rows& rows, std::uint32_t index) {
  return index >= rows.first && index < rows.first + rows.count;
}

/// The value that has a row of its changes.
SymbolReader value_with_change(const tables::ValueTables& values, std::uint32_t change) {
  const auto has_it = [&](const tables::ValueRow& row) { return has(row.changes, change); };
  const auto found = std::find_if(values.rows.begin(), values.rows.end(), has_it);
  return {SymbolReader::Kind::value, static_cast<std::uint32_t>(found - values.rows.begin())};
}

/// The first unit with a transition whose time is a formula.
std::optional<SymbolReader> unit_with_time(const PlantTables& tables, std::uint32_t formula) {
  const auto is_it = [&](tables::Time time) {
    if (time >= 0) return false;
    const tables::RandomTime& row = tables.random_times[static_cast<std::size_t>(-1 - time)];
    return row.kind == tables::RandomTime::Kind::seconds && row.a == formula;
  };
  for (std::uint32_t unit = 0; unit < tables.units.size(); ++unit) {
    const tables::TypeRow& type = tables.types[tables.units[unit].type];
    for (const tables::Transition& transition : type.transitions) {
      const bool own = (transition.dt & tables::kOfDevice) != 0;
      const auto index = static_cast<std::uint32_t>(transition.dt & ~tables::kOfDevice);
      const tables::TransitionTimes& times = own ? tables.times[tables.units[unit].times + index] : type.times[index];
      if (is_it(times.after) || is_it(times.takes)) return SymbolReader{SymbolReader::Kind::unit, unit};
    }
  }
  return {};
}

/// What computes the formula that has an input.
std::optional<SymbolReader> reader_by_formula(const PlantTables& tables, std::uint32_t input) {
  const tables::ValueTables& values = tables.values;
  const auto reads = [&](const tables::FormulaRow& row) { return has(row.inputs, input); };
  const auto formula = static_cast<std::uint32_t>(std::find_if(values.formulas.begin(), values.formulas.end(), reads) -
                                                  values.formulas.begin());
  for (const tables::SignalRow& row : values.signals) {
    if (row.formula == formula) return SymbolReader{SymbolReader::Kind::event, row.symbol};
  }
  for (std::uint32_t change = 0; change < values.changes.size(); ++change) {
    if (values.changes[change].formula == formula) return value_with_change(values, change);
  }
  for (std::uint32_t value = 0; value < values.rows.size(); ++value) {
    const tables::ValueRow& row = values.rows[value];
    if (has({row.formula, row.formulas}, formula)) return SymbolReader{SymbolReader::Kind::value, value};
  }
  return unit_with_time(tables, formula);
}

/// What reads a condition, through the network of conditions that it is part of.
std::optional<SymbolReader> reader_of(const PlantTables& tables, std::uint32_t condition) {
  const tables::ConditionRow* row = &tables.conditions[condition];
  while (row->reader_kind == tables::ReaderKind::condition) {
    condition = row->reader;
    row = &tables.conditions[condition];
  }
  if (row->reader_kind == tables::ReaderKind::requirement) {
    return SymbolReader{SymbolReader::Kind::requirement, row->reader};
  }
  if (row->reader_kind == tables::ReaderKind::follow) {
    return SymbolReader{SymbolReader::Kind::event, tables.follows[row->reader].symbol};
  }
  if (row->reader_kind == tables::ReaderKind::malfunction) {
    return SymbolReader{SymbolReader::Kind::malfunction, row->reader};
  }
  if (row->reader_kind == tables::ReaderKind::change) return value_with_change(tables.values, row->reader);
  if (row->reader_kind == tables::ReaderKind::formula_input) return reader_by_formula(tables, row->reader);
  if (row->reader_kind != tables::ReaderKind::unit) return reader_in_material(tables.material, *row);
  return SymbolReader{SymbolReader::Kind::unit, row->reader};
}

/// Calls `use` with the readers of an operation's bit or slot.
template <typename Watch, typename Of, typename Use>
void for_each_reader(const PlantTables& tables, std::span<const Watch> watches, Of of, std::uint32_t index, Use use) {
  auto at = std::lower_bound(watches.begin(), watches.end(), index,
                             [&](const Watch& watch, std::uint32_t value) { return of(watch) < value; });
  for (; at != watches.end() && of(*at) == index; ++at) {
    if (const auto reader = reader_of(tables, at->condition)) use(*reader);
  }
}

}  // namespace

SymbolUse::SymbolUse(const PlantTables& tables) : leader_(tables.symbols.size()), drivers_(tables.symbols.size()) {
  find_leaders(tables);
  find_drivers(tables);
  find_readers(tables);
}

std::span<const SymbolReader> SymbolUse::readers(std::uint32_t symbol) const {
  const std::uint32_t leader = leader_[symbol];
  const auto begin = std::partition_point(readings_.begin(), readings_.end(),
                                          [&](const Reading& reading) { return reading.symbol < leader; });
  const auto end =
      std::partition_point(begin, readings_.end(), [&](const Reading& reading) { return reading.symbol == leader; });
  return std::span(readers_).subspan(static_cast<std::size_t>(begin - readings_.begin()),
                                     static_cast<std::size_t>(end - begin));
}

void SymbolUse::find_leaders(const PlantTables& tables) {
  for (std::uint32_t i = 0; i < leader_.size(); ++i) leader_[i] = i;
  for (const tables::SharedAddress& shared : tables.shared_addresses) leader_[shared.symbol] = shared.leader;
}

void SymbolUse::find_drivers(const PlantTables& tables) {
  std::vector<bool> has_behavior(tables.units.size());
  for (const tables::BehaviourUnit& row : tables.behaviour_units) {
    has_behavior[row.unit] = true;
    for (const std::uint32_t symbol : tables.behaviour_values.subspan(row.first_value, row.value_count)) {
      if (tables.symbols[symbol].direction() == tables::Direction::operation) {
        readings_.push_back({leader_[symbol], {SymbolReader::Kind::behavior, row.unit}});
      } else {
        drivers_[leader_[symbol]] = {SymbolDriver::Kind::behavior, row.unit};
      }
    }
  }
  for (const tables::SensorRow& sensor : tables.material.sensors) {
    drivers_[leader_[sensor.symbol]] = {SymbolDriver::Kind::part, sensor.location};
  }
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const tables::SymbolRow& symbol = tables.symbols[i];
    SymbolDriver& driver = drivers_[leader_[i]];
    if (driver.kind == SymbolDriver::Kind::part) continue;
    if (symbol.moved()) {
      driver = {symbol.unit == tables::kNone ? SymbolDriver::Kind::condition : SymbolDriver::Kind::unit, symbol.unit};
    } else if (symbol.unit != tables::kNone && has_behavior[symbol.unit] && driver.kind == SymbolDriver::Kind::none) {
      driver = {SymbolDriver::Kind::behavior, symbol.unit};
    }
  }
}

/// Formulas, and comparisons of two operands, of numeric operations.
void SymbolUse::find_readers_of_numbers(const PlantTables& tables) {
  std::vector<std::uint32_t> leader_of_slot(tables.operation_slots);
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const tables::SymbolRow& symbol = tables.symbols[i];
    const bool is_number = symbol.type() != tables::DataType::boolean;
    if (is_number && symbol.direction() == tables::Direction::operation) leader_of_slot[symbol.index] = leader_[i];
  }
  const auto add = [&](std::uint32_t slot, const std::optional<SymbolReader>& reader) {
    if (reader) readings_.push_back({leader_of_slot[slot], *reader});
  };
  for (std::uint32_t n = 0; n < tables.values.inputs.size(); ++n) {
    const tables::FormulaInput& input = tables.values.inputs[n];
    if (input.kind == tables::FormulaInputKind::operation_value) add(input.of, reader_by_formula(tables, n));
  }
  for (const tables::ComparisonRow& row : tables.values.comparisons) {
    for (const tables::Operand* operand : {&row.left, &row.right}) {
      if (operand->kind == tables::Operand::Kind::operation_value) add(operand->of, reader_of(tables, row.condition));
    }
  }
}

void SymbolUse::find_readers(const PlantTables& tables) {
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const tables::SymbolRow& symbol = tables.symbols[i];
    if (symbol.direction() != tables::Direction::operation) continue;
    const auto add = [&](SymbolReader reader) { readings_.push_back({leader_[i], reader}); };
    if (symbol.type() == tables::DataType::boolean) {
      for_each_reader(
          tables, tables.operation_watches, [](const tables::BitWatch& watch) { return watch.bit; }, symbol.index, add);
    } else {
      for_each_reader(
          tables, tables.operation_value_watches, [](const tables::ValueWatch& watch) { return watch.slot; },
          symbol.index, add);
    }
  }
  find_readers_of_numbers(tables);
  for (std::uint32_t d = 0; d < tables.material.drives.size(); ++d) {
    const std::uint32_t symbol = tables.material.drives[d].symbol;
    if (symbol == tables::kNone || tables.symbols[symbol].direction() != tables::Direction::operation) continue;
    const auto drives_of = [](const tables::TrackRow& track) { return track.drives; };
    readings_.push_back({leader_[symbol], {SymbolReader::Kind::track, track_with(tables.material, d, drives_of)}});
  }
  const auto key = [](const Reading& reading) {
    return std::tuple(reading.symbol, reading.reader.kind, reading.reader.index);
  };
  std::sort(readings_.begin(), readings_.end(), [&](const Reading& a, const Reading& b) { return key(a) < key(b); });
  readings_.erase(std::unique(readings_.begin(), readings_.end()), readings_.end());
  readers_.reserve(readings_.size());
  for (const Reading& reading : readings_) readers_.push_back(reading.reader);
}

}  // namespace symplant::why
