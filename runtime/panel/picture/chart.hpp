// What changed lately, for charts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::panel {

/// The symbols, devices and values (by their outputs) of a chart, and its times.
struct ChartWish {
  std::vector<std::uint32_t> symbols;
  std::vector<std::uint32_t> devices;
  std::vector<std::uint32_t> values;
  tables::Time from = 0;
  tables::Time to = tables::kNever;
  std::uint64_t after = 0;        ///< only changes from this number on; 0: from `from` on
  std::uint64_t after_value = 0;  ///< the same for values
};

/// The latest changes of a run, of all symbols and devices, and those of values that a trace shows; up to a fixed
/// number of both, so that values that change all the time leave the others their room. Used by one thread at a time.
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
  enum class Of : std::uint8_t { symbol, device, value };
  struct Change {
    tables::Time time;
    std::uint64_t before;  ///< the value, the packed state, or the bits of an output
    std::uint64_t after;
    std::uint32_t of;
    Of kind;
  };
  /// The latest changes, by their number.
  class Ring {
   public:
    void add(const Change& change);
    void set_back(tables::Time time);
    const Change& at(std::uint64_t number) const { return changes_[number % kMost]; }
    std::uint64_t next() const { return next_; }
    tables::Time begin() const { return begin_; }
    /// Whether all changes from a number on are kept.
    bool continues(std::uint64_t after) const { return after != 0 && after >= first_; }
    /// The number of the first change at a time or later.
    std::uint64_t first_at(tables::Time from) const;

   private:
    std::vector<Change> changes_;  ///< a ring, by number
    std::uint64_t next_ = 0;       ///< the number of changes so far
    std::uint64_t first_ = 0;      ///< the number of the first change that is kept
    tables::Time begin_ = 0;       ///< changes are complete from this time on
  };
  struct Answer;

  std::uint64_t now_of(Of kind, std::uint32_t of) const;
  void put_value(std::string& json, std::uint32_t of, Of kind, tables::Time time, std::uint64_t value) const;

  const trace::PlantNames& names_;
  const trace::History& history_;
  Ring changes_;  ///< of symbols and devices
  Ring values_;
};

}  // namespace symplant::panel
