// Fills the list of alarms from the records and findings of a run.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/panel/alarm/alarm_list.hpp"
#include "symplant/panel/alarm/lasting.hpp"
#include "symplant/panel/view.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/history.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::panel {

/// The alarms of a plant: the operations and values of `alarms` in the description, requirements, and findings. Used by
/// one thread at a time, for each record in their order, together with a History. before() and after() are O(1) while
/// no requirement is violated and no finding lasts, else O(what lasts) in each instant.
class AlarmSources {
 public:
  /// `names`, `history` and `list` must outlive it. O(plant).
  AlarmSources(const trace::PlantNames& names, const trace::History& history, const View& view, tables::Time now,
               AlarmList& list);

  /// Before History::apply().
  void before(const trace::Record& record) {
    if (record.time != time_) settle();
    time_ = record.time;
  }
  /// After it.
  void after(const trace::Record& record) {
    is_settled_ = false;
    if (record.kind == trace::Record::Kind::change && !of_symbol_.empty()) {
      if (const std::uint32_t alarm = of_symbol_[record.of]; alarm != tables::kNone) look(alarm, record.time);
    } else if (record.kind == trace::Record::Kind::value && !of_output_.empty()) {
      if (const std::uint32_t alarm = of_output_[record.of]; alarm != tables::kNone) look(alarm, record.time);
    }
  }
  void finding(const trace::FoundThing& found, const std::string& words);
  /// Ends what no longer lasts after the last record, and the shelving of alarms whose time is over at `now`.
  void settle(tables::Time now);
  /// The plant was set to another state, and the history has it: the list has what came until `until`, as it is at
  /// `now`.
  void set_back(tables::Time until, tables::Time now);

 private:
  struct Source {
    Alarm alarm;
    std::uint32_t symbol = tables::kNone;
    std::uint32_t output = tables::kNone;
    std::uint64_t number = 0;  ///< of an integer while it is on
  };

  void add(const AlarmView& alarm, const View& view);
  void look(std::uint32_t source, tables::Time time);
  void look_at_all(tables::Time now);
  void settle();
  std::uint32_t station_of(const trace::FoundThing& found) const;

  const trace::PlantNames& names_;
  const trace::History& history_;
  AlarmList& list_;
  Lasting lasting_;
  std::vector<Source> sources_;
  std::vector<std::uint32_t> of_symbol_;  ///< a source or kNone; empty: none has a source
  std::vector<std::uint32_t> of_output_;
  std::vector<std::uint32_t> stations_;  ///< by unit
  tables::Time time_;                    ///< of the last record
  bool is_settled_ = true;
};

}  // namespace symplant::panel
