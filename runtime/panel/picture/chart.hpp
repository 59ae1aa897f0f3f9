// What changed lately, for charts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::panel {

/// The symbols and devices of a chart, and its times.
struct ChartWish {
  std::vector<std::uint32_t> symbols;
  std::vector<std::uint32_t> devices;
  tables::Time from = 0;
  tables::Time to = tables::kNever;
  std::uint64_t after = 0;  ///< only changes from this number on; 0: from `from` on
};

/// The latest changes of a run, of all symbols and devices, up to a fixed number. Used by one thread at a time.
class Chart {
 public:
  static constexpr std::size_t kMost = std::size_t{1} << 20;

  /// Both must outlive it.
  Chart(const trace::PlantNames& names, const trace::History& history) : names_(names), history_(history) {}

  /// To be called before History::apply(), which has the value before the change. O(1).
  void apply(const trace::Record& record);
  /// The plant was set to another state at `time`: what came before is forgotten.
  void set_back(tables::Time time);

  /// The JSON of an answer (docs/panel-interface.md). O(changes that are kept).
  std::string text(const ChartWish& wish, tables::Time now) const;

 private:
  struct Change {
    tables::Time time;
    std::uint64_t before;  ///< the value, or the packed state
    std::uint64_t after;
    std::uint32_t of;
    bool is_device;
  };

  const Change& at(std::uint64_t number) const { return changes_[number % kMost]; }
  std::uint64_t first_from(const ChartWish& wish, tables::Time& from) const;
  void put_value(std::string& json, std::uint32_t of, bool is_device, tables::Time time, std::uint64_t value) const;

  const trace::PlantNames& names_;
  const trace::History& history_;
  std::vector<Change> changes_;  ///< a ring, by number
  std::uint64_t next_ = 0;       ///< the number of changes so far
  std::uint64_t first_ = 0;      ///< the number of the first change that is kept
  tables::Time begin_ = 0;       ///< changes are complete from this time on
};

}  // namespace symplant::panel
