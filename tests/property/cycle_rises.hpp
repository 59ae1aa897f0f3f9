// Counts the events that rise within a cycle: a case with more than the engine remembers cannot be compared.
#pragma once

#include <cstdint>
#include <deque>
#include <set>
#include <vector>

#include "support/reference/reference.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::property {

/// In real time the engine keeps the last 64 rises (of one instant in one word each) for *event too short*. It does not
/// report an older event that the PLC may miss within one cycle (runtime/core/short_events.hpp).
class CycleRises {
 public:
  explicit CycleRises(const tables::PlantTables& tables) : tables_(&tables) {}

  void clear() { times_.clear(); }
  /// Records what happened; true if the engine may have forgotten a rise.
  bool too_many(const std::vector<reference::InstantRecord>& instants, tables::Time cycle) {
    constexpr std::size_t kRemembered = 64;
    if (cycle == 0) return false;
    for (const reference::InstantRecord& instant : instants) {
      times_.insert(times_.end(), words_of(instant), instant.time);
      while (times_.size() > kRemembered) times_.pop_front();
      if (times_.size() == kRemembered && instant.time - times_.front() <= cycle) return true;
    }
    return false;
  }

 private:
  std::size_t words_of(const reference::InstantRecord& instant) const {
    std::set<std::uint32_t> words;
    for (const auto& [symbol, value] : instant.changes) {
      const tables::SymbolRow& row = tables_->symbols[symbol];
      const bool event = row.direction() == tables::Direction::event && row.type() == tables::DataType::boolean;
      if (event && (value != 0) != row.inverted()) words.insert(row.index / 64);
    }
    return words.size();
  }

  const tables::PlantTables* tables_;
  std::deque<tables::Time> times_;
};

}  // namespace symplant::property
