// Collects the changes of a recording in the order in which a file has them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "recording/recording.hpp"

namespace symplant::recording {

class Collector {
 public:
  /// The recording must outlive this object.
  explicit Collector(Recording& recording) : recording_(recording) {}

  /// Says that a program writes these symbols. Only series that are added afterwards are marked.
  void add_written(std::string symbol) { written_.insert(std::move(symbol)); }

  /// The index of the series of an element, which is added if it is new. O(1).
  std::uint32_t series_of(Series::Kind kind, std::string_view name, std::string_view part = {});
  /// The index of the series of a symbol. If it is new, it has `kind`. O(1), less if the symbol is that of the last
  /// call.
  std::uint32_t symbol(Series::Kind kind, std::string_view name);

  /// Times must not decrease.
  void add(std::uint32_t series, tables::Time time, double value) {
    recording_.series[series].changes.push_back({time, value});
    if (recording_.order.empty() || last_time_ != time) end_time();
    last_time_ = time;
    recording_.order.push_back(series);
  }
  /// Forgets all changes.
  void clear();
  /// Call once, after the last change.
  void finish() { end_time(); }

 private:
  /// Puts the operations of the time that ends first.
  void end_time();

  Recording& recording_;
  std::unordered_set<std::string> written_;  ///< by programs
  tables::Time last_time_ = 0;
  std::size_t begin_ = 0;  ///< of the changes of the last time in the order
  std::string key_;        ///< reused
};

}  // namespace symplant::recording
