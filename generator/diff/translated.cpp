// The old model in the names of the new one.
#include "diff/translated.hpp"

#include <map>
#include <set>
#include <string_view>
#include <unordered_map>

namespace symplant::diff {
namespace {

/// By list and row: the symbol of the row; kNone for a row that is no I/O symbol.
std::vector<std::vector<std::uint32_t>> symbols_by_row(const model::PlantModel& plant) {
  std::vector<std::vector<std::uint32_t>> by_row;
  for (const model::PlantList& list : plant.lists) by_row.emplace_back(list.table->rows.size(), kNone);
  for (std::uint32_t s = 0; s < plant.symbols.size(); ++s) {
    const model::Symbol& symbol = plant.symbols[s];
    const auto row = static_cast<std::size_t>(symbol.row - plant.lists[symbol.list].table->rows.data());
    by_row[symbol.list][row] = s;
  }
  return by_row;
}

/// Counts the pairs of symbols of an old device by the new devices of their partners.
class Votes {
 public:
  Votes(const model::PlantModel& after, const std::vector<std::uint32_t>& symbols) : after_(after), symbols_(symbols) {}

  void add(const std::vector<std::uint32_t>& olds) {
    for (const std::uint32_t old : olds) {
      const std::uint32_t now = symbols_[old];
      if (now != kNone && after_.symbols[now].unit != kNone) ++counts_[after_.symbols[now].unit];
      ++total_;
    }
  }

  /// The new device that has more than half of the symbols of both; kNone without one.
  std::uint32_t winner() const {
    for (const auto& [unit, count] : counts_) {
      const std::size_t size = after_.units[unit].operations.size() + after_.units[unit].events.size();
      if (2 * count > size && 2 * count > total_) return unit;
    }
    return kNone;
  }

 private:
  const model::PlantModel& after_;
  const std::vector<std::uint32_t>& symbols_;
  std::map<std::uint32_t, std::size_t> counts_;
  std::size_t total_ = 0;
};

/// The symbol at an index of operations or events; kNone for none.
std::uint32_t symbol_at(const std::vector<std::uint32_t>& side, std::uint32_t index) {
  return index == kNone ? kNone : side[index];
}

}  // namespace

std::vector<std::uint32_t> symbols_after(const model::PlantModel& before, const model::PlantModel& after,
                                         const SymbolPairs& pairs) {
  const auto old_rows = symbols_by_row(before);
  const auto new_rows = symbols_by_row(after);
  std::vector<std::uint32_t> result(before.symbols.size(), kNone);
  for (std::size_t list = 0; list < old_rows.size(); ++list) {
    for (std::size_t row = 0; row < old_rows[list].size(); ++row) {
      const RowRef& now = pairs.after[list][row];
      if (old_rows[list][row] != kNone && now.exists()) result[old_rows[list][row]] = new_rows[now.list][now.row];
    }
  }
  return result;
}

std::vector<std::uint32_t> units_after(const model::PlantModel& before, const model::PlantModel& after,
                                       const std::vector<std::uint32_t>& symbols) {
  std::unordered_map<std::string_view, std::uint32_t> by_path;
  for (std::uint32_t u = 0; u < after.units.size(); ++u) by_path.emplace(after.units[u].path, u);
  std::vector<std::uint32_t> result(before.units.size(), kNone);
  std::vector<bool> taken(after.units.size());
  for (std::uint32_t u = 0; u < before.units.size(); ++u) {
    const auto found = by_path.find(before.units[u].path);
    if (found == by_path.end() || taken[found->second]) continue;
    result[u] = found->second;
    taken[found->second] = true;
  }
  for (std::uint32_t u = 0; u < before.units.size(); ++u) {
    if (result[u] != kNone) continue;
    Votes votes(after, symbols);
    votes.add(before.units[u].operations);
    votes.add(before.units[u].events);
    const std::uint32_t winner = votes.winner();
    if (winner == kNone || taken[winner]) continue;
    result[u] = winner;
    taken[winner] = true;
  }
  return result;
}

std::vector<std::uint32_t> renamed_states(const model::Unit& before, const model::Unit& after,
                                          const std::vector<std::uint32_t>& symbols) {
  std::set<std::string_view> old_names;
  std::map<std::uint32_t, std::uint32_t> by_symbol;  // old states by the new symbol that is theirs
  for (const model::State& state : before.states) old_names.insert(state.name);
  std::set<std::string_view> new_names;
  for (const model::State& state : after.states) new_names.insert(state.name);
  for (std::uint32_t s = 0; s < before.states.size(); ++s) {
    const model::State& state = before.states[s];
    if (new_names.count(state.name) != 0) continue;
    for (const std::uint32_t symbol :
         {symbol_at(before.operations, state.operation), symbol_at(before.events, state.event)}) {
      if (symbol != kNone && symbols[symbol] != kNone) by_symbol.emplace(symbols[symbol], s);
    }
  }
  std::vector<std::uint32_t> result(after.states.size(), kNone);
  std::set<std::uint32_t> taken;
  for (std::uint32_t s = 0; s < after.states.size(); ++s) {
    const model::State& state = after.states[s];
    if (old_names.count(state.name) != 0) continue;
    for (const std::uint32_t symbol :
         {symbol_at(after.operations, state.operation), symbol_at(after.events, state.event)}) {
      const auto old = by_symbol.find(symbol);
      if (result[s] == kNone && old != by_symbol.end() && taken.insert(old->second).second) result[s] = old->second;
    }
  }
  return result;
}

model::PlantModel translated(const model::PlantModel& before, const model::PlantModel& after,
                             const std::vector<std::uint32_t>& symbols, const std::vector<std::uint32_t>& units) {
  model::PlantModel plant = before;
  for (std::size_t s = 0; s < symbols.size(); ++s) {
    if (symbols[s] == kNone) continue;
    const model::Symbol& now = after.symbols[symbols[s]];
    plant.symbols[s].row = now.row;
    plant.symbols[s].list = now.list;  // a row belongs to its list
    const std::uint32_t unit = plant.symbols[s].unit;
    if (unit != kNone && units[unit] == now.unit) plant.symbols[s].reading = now.reading;
  }
  for (std::size_t u = 0; u < units.size(); ++u) {
    if (units[u] == kNone) continue;
    const model::Unit& now = after.units[units[u]];
    plant.units[u].path = now.path;
    const std::vector<std::uint32_t> states = renamed_states(before.units[u], now, symbols);
    for (std::size_t s = 0; s < states.size(); ++s) {
      if (states[s] != kNone) plant.units[u].states[states[s]].name = now.states[s].name;
    }
  }
  return plant;
}

}  // namespace symplant::diff
