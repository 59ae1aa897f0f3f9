// How the plant uses each I/O symbol: what reads an operation, what drives an event.
#include "symplant/why/symbol_use.hpp"

#include <algorithm>
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

/// What reads a condition, through the network of conditions that it is part of.
SymbolReader reader_of(const PlantTables& tables, std::uint32_t condition) {
  const tables::ConditionRow* row = &tables.conditions[condition];
  while (row->reader_kind == tables::ReaderKind::condition) {
    condition = row->reader;
    row = &tables.conditions[condition];
  }
  if (row->reader_kind == tables::ReaderKind::requirement) return {SymbolReader::Kind::requirement, row->reader};
  if (row->reader_kind == tables::ReaderKind::follow) {
    return {SymbolReader::Kind::event, tables.follows[row->reader].symbol};
  }
  if (row->reader_kind == tables::ReaderKind::malfunction) return {SymbolReader::Kind::malfunction, row->reader};
  if (row->reader_kind != tables::ReaderKind::unit) return reader_in_material(tables.material, *row);
  return {SymbolReader::Kind::unit, row->reader};
}

/// Calls `use` with the readers of an operation's bit or slot.
template <typename Watch, typename Of, typename Use>
void for_each_reader(const PlantTables& tables, std::span<const Watch> watches, Of of, std::uint32_t index, Use use) {
  auto at = std::lower_bound(watches.begin(), watches.end(), index,
                             [&](const Watch& watch, std::uint32_t value) { return of(watch) < value; });
  for (; at != watches.end() && of(*at) == index; ++at) use(reader_of(tables, at->condition));
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
