// The alarms that a person must see, after ISA-18.2 and IEC 62682.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/panel/alarm/alarm.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::panel {

/// An alarm leaves the list when it is both gone and acknowledged. A shelved one stays until its time is over; then it
/// is unacknowledged if it is still on, else it leaves. Bounded: kMost alarms with short texts. Times are plant time,
/// in ns. Used by one thread at a time.
class AlarmList {
 public:
  static constexpr std::size_t kMost = 1000;
  static constexpr std::size_t kLongestText = 500;  ///< bytes

  struct Entry {
    Alarm alarm;
    bool on = false;
    bool acknowledged = false;
    tables::Time came = 0;
    tables::Time went = 0;  ///< valid if it is not on
    tables::Time acknowledged_at = 0;
    tables::Time shelved_at = 0;
    tables::Time shelved_until = tables::kNever;
    bool shelved = false;
    std::uint64_t count = 0;  ///< how often it came since it is in the list
    std::uint64_t order = 0;  ///< grows with each alarm that comes or comes back
  };

  /// An alarm came. With `stays` it is on until go(); else it came and went at once. In a full list it replaces the
  /// least urgent entry, those that are gone first; if all are more urgent, it is not added. O(log alarms), O(alarms)
  /// in a full list.
  void come(const Alarm& alarm, tables::Time time, bool stays);
  /// Ignored if it is not on. O(alarms that are on).
  void go(std::string_view name, tables::Time time);

  /// How many are neither acknowledged nor shelved. O(alarms).
  std::size_t waiting() const;
  bool acknowledge(std::string_view name, tables::Time now);  ///< false: not in the list
  void acknowledge_all(tables::Time now);                     ///< all but the shelved ones
  bool shelve(std::string_view name, tables::Time until, tables::Time now);
  bool unshelve(std::string_view name);  ///< false: it is not shelved
  /// The horn is off until the next alarm of high priority comes.
  void silence() {
    silenced_ = order_;
    head_changed_ = true;
  }
  /// Ends the shelving of those whose time is over. O(1) if no time is over.
  void advance_to(tables::Time now);

  /// The plant was set back to `time`: what came or was done later is forgotten. What `stays()` is kept as it is. What
  /// came later and `lasts()` at that time, too, came before: it is on. An alarm that went later counts as on.
  void forget_after(tables::Time time, const std::function<bool(const Alarm&)>& stays,
                    const std::function<bool(const Alarm&)>& lasts);

  /// Null: not in the list.
  const Entry* find(std::string_view name) const;
  /// The name in the list that is nearest to a mistyped one; empty: none is near.
  std::string_view nearest(std::string_view name) const;
  /// Those that are on.
  const std::vector<Entry*>& on() const { return on_; }
  std::size_t size() const { return entries_.size(); }
  /// Whether an alarm of high priority is neither acknowledged nor shelved, and came after the last silence().
  /// O(alarms).
  bool horn() const;
  /// How many alarms the list had no room for.
  std::uint64_t dropped() const { return dropped_; }

  bool has_changes() const { return all_changed_ || head_changed_ || !changed_.empty(); }
  /// Appends the whole list as an object. O(alarms).
  void put_all(std::string& json) const;
  /// Appends what changed since forget_changes(). O(alarms) for the horn.
  void put_changes(std::string& json) const;
  void forget_changes();

 private:
  using Entries = std::map<std::string, Entry, std::less<>>;

  void set_on(Entry& entry, bool on);
  void mark(const std::string& name);
  Entries::iterator remove(Entries::iterator entry);
  bool make_room(const Alarm& alarm, bool stays);
  Entries::iterator unshelve(Entries::iterator entry);
  void put_head(std::string& json, bool all) const;

  Entries entries_;
  std::vector<Entry*> on_;
  std::set<std::string, std::less<>> changed_;  ///< names, also of entries that left
  bool all_changed_ = false;                    ///< `changed_` has not all of them
  bool head_changed_ = false;                   ///< horn or dropped
  tables::Time next_ = tables::kNever;          ///< not after the earliest end of a shelving
  std::uint64_t order_ = 0;
  std::uint64_t silenced_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace symplant::panel
