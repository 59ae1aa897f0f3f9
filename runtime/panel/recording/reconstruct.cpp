// Adds to the records of a trace what it does not hold.
#include "symplant/panel/recording/reconstruct.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "symplant/panel/recording/stays.hpp"

namespace symplant::panel {
namespace {

using trace::Record;

/// The states of devices, from their events and operations.
class States {
 public:
  explicit States(const trace::PlantNames& names)
      : names_(names),
        events_(names.tables().units.size()),
        operations_(events_.size()),
        last_(events_.size(), kUnknown) {}

  void change(std::uint32_t symbol, bool on) {
    const tables::SymbolRow& row = names_.tables().symbols[symbol];
    if (row.unit == tables::kNone || row.type() != tables::DataType::boolean) return;
    const tables::UnitRow& unit = names_.tables().units[row.unit];
    const bool operation = row.direction() == tables::Direction::operation;
    const std::uint32_t first = operation ? unit.operation_bit : unit.event_bit;
    std::uint64_t& word = (operation ? operations_ : events_)[row.unit];
    const std::uint64_t bit = std::uint64_t{1} << (row.index - first);
    word = on != row.inverted() ? word | bit : word & ~bit;
    touched_.insert(row.unit);
  }

  /// Calls `add(unit, view)` for each device that is in another state than at the last call.
  template <class Add>
  void end_instant(Add add) {
    for (const std::uint32_t unit : touched_) {
      const plant::UnitView view = view_of(unit);
      const std::uint64_t word = trace::pack_unit(view);
      if (std::exchange(last_[unit], word) != word) add(unit, word);
    }
    touched_.clear();
  }

 private:
  static constexpr std::uint64_t kUnknown = ~std::uint64_t{0};

  plant::UnitView view_of(std::uint32_t unit) const {
    const tables::UnitRow& row = names_.tables().units[unit];
    const tables::TypeRow& type = names_.tables().types[row.type];
    std::uint64_t of_states = 0;
    for (const tables::EventMasks& enter : type.enter) of_states |= enter.on;
    const std::uint64_t on = events_[unit] & of_states;
    for (std::uint8_t state = 0; state < type.states; ++state) {
      if (type.enter[state].on == on) return {state, state, false, false, false, false, 0, 0, 0};
    }
    const std::uint8_t from =
        last_[unit] == kUnknown ? static_cast<std::uint8_t>(row.initial) : static_cast<std::uint8_t>(last_[unit]);
    std::uint8_t to = from;
    for (std::uint8_t operation = 0; operation < type.operations; ++operation) {
      const bool commands = (operations_[unit] >> operation & 1) != 0;
      if (commands && type.operation_targets[operation] != tables::kNoState) to = type.operation_targets[operation];
    }
    return {from, to, true, false, false, false, 0, 0, 0};
  }

  const trace::PlantNames& names_;
  std::vector<std::uint64_t> events_;
  std::vector<std::uint64_t> operations_;
  std::vector<std::uint64_t> last_;  ///< pack_unit
  std::set<std::uint32_t> touched_;
};

/// Sets the times of moves: from a record of a device that moves to its next one.
void set_times(std::vector<Record>& records) {
  std::map<std::uint32_t, std::size_t> moves;  ///< a device -> its record
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (records[i].kind != Record::Kind::unit) continue;
    if (const auto open = moves.find(records[i].of); open != moves.end()) {
      plant::UnitView view = trace::unpack_unit(records[open->second].value);
      view.remaining = records[i].time - records[open->second].time;
      records[open->second].value = trace::pack_motion(view);
      moves.erase(open);
    }
    if (trace::unpack_unit(records[i].value).moving) moves[records[i].of] = i;
  }
}

}  // namespace

std::vector<Record> reconstruct(std::vector<Record> records, const trace::PlantNames& names) {
  Stays stays(records, names);
  const auto turns = stays.turns();
  auto turn = turns.begin();
  States states(names);
  std::vector<Record> all;
  all.reserve(records.size() * 2);
  std::set<std::uint32_t> tracks;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Record& record = records[i];
    for (; turn != turns.end() && turn->first < record.time; ++turn) {
      stays.append(turn->second, turn->first, all);
      all.back().last = true;
    }
    for (; turn != turns.end() && turn->first == record.time; ++turn) tracks.insert(turn->second);
    all.push_back(record);
    all.back().last = false;
    if (record.kind == Record::Kind::change) states.change(record.of, record.value != 0);
    if (record.kind == Record::Kind::part_move) {
      for (const auto location :
           {static_cast<std::uint32_t>(record.value >> 32), static_cast<std::uint32_t>(record.value)}) {
        if (location < names.tables().material.tracks.size()) tracks.insert(location);
      }
    }
    if (i + 1 < records.size() && records[i + 1].time == record.time) continue;
    states.end_instant([&](std::uint32_t unit, std::uint64_t word) {
      all.push_back({record.time, word, unit, Record::Kind::unit});
    });
    for (const std::uint32_t track : tracks) stays.append(track, record.time, all);
    tracks.clear();
    all.back().last = true;
  }
  set_times(all);
  return all;
}

}  // namespace symplant::panel
