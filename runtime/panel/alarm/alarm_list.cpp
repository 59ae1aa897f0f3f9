// The alarms that a person must see.
#include "symplant/panel/alarm/alarm_list.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::panel {
namespace {

using tables::AlarmPriority;

constexpr std::size_t kMostChanged = 2 * AlarmList::kMost;

/// At most kLongestText bytes of a text in UTF-8, with a mark if it is cut.
std::string shortened(const std::string& text) {
  if (text.size() <= AlarmList::kLongestText) return text;
  constexpr std::string_view kCut = "…";
  std::size_t end = AlarmList::kLongestText - kCut.size();
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end).append(kCut);
}

std::string_view priority_name(AlarmPriority priority) {
  if (priority == AlarmPriority::high) return "high";
  return priority == AlarmPriority::medium ? "medium" : "low";
}

std::string_view source_name(Alarm::Source source) {
  if (source == Alarm::Source::alarm) return "alarm";
  return source == Alarm::Source::requirement ? "requirement" : "finding";
}

std::string_view state_name(const AlarmList::Entry& entry) {
  if (entry.shelved) return "shelved";
  if (!entry.on) return "gone";
  return entry.acknowledged ? "acknowledged" : "active";
}

std::string time_or_null(tables::Time time, bool has) { return has ? std::to_string(time) : "null"; }

void put_entry(std::string& json, const AlarmList::Entry& entry) {
  const Alarm& alarm = entry.alarm;
  put_comma(json);
  json += '{';
  put_member(json, "name", alarm.name);
  put(json, R"(,"state":"{}","on":{},"priority":"{}","source":"{}")", state_name(entry), entry.on,
      priority_name(alarm.priority), source_name(alarm.source));
  put_member(json, "of", alarm.of);
  put_member(json, "text", alarm.text);
  put(json, R"(,"station":{},"came":{},"went":{},"count":{},"until":{}}})", index_or_null(alarm.station, tables::kNone),
      entry.came, time_or_null(entry.went, !entry.on), entry.count, time_or_null(entry.shelved_until, entry.shelved));
}

}  // namespace

void AlarmList::mark(const std::string& name) {
  if (all_changed_) return;
  changed_.insert(name);
  if (changed_.size() <= kMostChanged) return;
  all_changed_ = true;
  changed_.clear();
}

void AlarmList::set_on(Entry& entry, bool on) {
  if (entry.on == on) return;
  entry.on = on;
  on ? on_.push_back(&entry) : static_cast<void>(on_.erase(std::find(on_.begin(), on_.end(), &entry)));
}

AlarmList::Entries::iterator AlarmList::remove(Entries::iterator entry) {
  set_on(entry->second, false);
  mark(entry->first);
  return entries_.erase(entry);
}

/// Whether there is room for one more, after the least urgent entry has left if need be.
bool AlarmList::make_room(const Alarm& alarm, bool stays) {
  if (entries_.size() < kMost) return true;
  ++dropped_;
  head_changed_ = true;
  const auto urgency = [](const Entry& entry) { return std::tuple(entry.on, entry.alarm.priority, entry.order); };
  const auto least = std::min_element(entries_.begin(), entries_.end(), [&](const auto& a, const auto& b) {
    return urgency(a.second) < urgency(b.second);
  });
  if (std::tuple(least->second.on, least->second.alarm.priority) > std::tuple(stays, alarm.priority)) return false;
  remove(least);
  return true;
}

void AlarmList::come(const Alarm& alarm, tables::Time time, bool stays) {
  auto found = entries_.find(alarm.name);
  if (found == entries_.end()) {
    if (!make_room(alarm, stays)) return;
    found = entries_.try_emplace(alarm.name).first;
  }
  Entry& entry = found->second;
  entry.alarm = alarm;
  entry.alarm.text = shortened(alarm.text);
  entry.came = entry.went = time;
  entry.acknowledged = false;
  ++entry.count;
  entry.order = ++order_;
  set_on(entry, stays);
  mark(found->first);
}

void AlarmList::go(std::string_view name, tables::Time time) {
  const auto found = entries_.find(name);
  if (found == entries_.end() || !found->second.on) return;
  Entry& entry = found->second;
  if (entry.acknowledged && !entry.shelved) return static_cast<void>(remove(found));
  set_on(entry, false);
  entry.went = time;
  mark(found->first);
}

std::size_t AlarmList::waiting() const {
  return static_cast<std::size_t>(std::count_if(entries_.begin(), entries_.end(), [](const auto& each) {
    return !each.second.acknowledged && !each.second.shelved;
  }));
}

bool AlarmList::acknowledge(std::string_view name, tables::Time now) {
  const auto found = entries_.find(name);
  if (found == entries_.end()) return false;
  Entry& entry = found->second;
  if (entry.shelved || entry.acknowledged) return true;
  if (!entry.on) {
    remove(found);
    return true;
  }
  entry.acknowledged = true;
  entry.acknowledged_at = now;
  mark(found->first);
  return true;
}

void AlarmList::acknowledge_all(tables::Time now) {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries_) names.push_back(name);
  for (const std::string& name : names) acknowledge(name, now);
}

bool AlarmList::shelve(std::string_view name, tables::Time until, tables::Time now) {
  const auto found = entries_.find(name);
  if (found == entries_.end()) return false;
  Entry& entry = found->second;
  entry.shelved = true;
  entry.shelved_at = now;
  entry.shelved_until = until;
  next_ = std::min(next_, until);
  mark(found->first);
  return true;
}

/// It is unacknowledged if it is on, else it leaves. Returns the entry after it.
AlarmList::Entries::iterator AlarmList::unshelve(Entries::iterator found) {
  Entry& entry = found->second;
  entry.shelved = false;
  if (!entry.on) return remove(found);
  entry.acknowledged = false;
  entry.order = ++order_;
  mark(found->first);
  return std::next(found);
}

bool AlarmList::unshelve(std::string_view name) {
  const auto found = entries_.find(name);
  if (found == entries_.end() || !found->second.shelved) return false;
  unshelve(found);
  return true;
}

void AlarmList::advance_to(tables::Time now) {
  if (now < next_) return;
  next_ = tables::kNever;
  for (auto each = entries_.begin(); each != entries_.end();) {
    const Entry& entry = each->second;
    if (entry.shelved && entry.shelved_until <= now) {
      each = unshelve(each);
      continue;
    }
    if (entry.shelved) next_ = std::min(next_, entry.shelved_until);
    ++each;
  }
}

void AlarmList::forget_after(tables::Time time, const std::function<bool(const Alarm&)>& stays,
                             const std::function<bool(const Alarm&)>& lasts) {
  for (auto each = entries_.begin(); each != entries_.end();) {
    Entry& entry = each->second;
    const bool kept = entry.on && stays(entry.alarm);
    if (kept) entry.came = std::min(entry.came, std::max<tables::Time>(time, 0));
    if (entry.came > time && !kept) {
      if (!lasts(entry.alarm)) {
        each = remove(each);
        continue;
      }
      entry.came = std::max<tables::Time>(time, 0);  // it came before, too
      if (!entry.on) set_on(entry, true);
    }
    if (entry.shelved && entry.shelved_at > time) entry.shelved = false;
    if (entry.acknowledged && entry.acknowledged_at > time) entry.acknowledged = kept;
    if (!entry.on && entry.went > time && !stays(entry.alarm)) set_on(entry, true);
    ++each;
  }
  dropped_ = 0;
  all_changed_ = true;
  changed_.clear();
}

const AlarmList::Entry* AlarmList::find(std::string_view name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second;
}

std::string_view AlarmList::nearest(std::string_view name) const {
  tables::NearestName nearest(name);
  for (const auto& [known, entry] : entries_) nearest.offer(known);
  return nearest.name();
}

bool AlarmList::horn() const {
  return std::any_of(entries_.begin(), entries_.end(), [this](const auto& each) {
    const Entry& entry = each.second;
    return entry.alarm.priority == AlarmPriority::high && !entry.acknowledged && !entry.shelved &&
           entry.order > silenced_;
  });
}

void AlarmList::put_head(std::string& json, bool all) const {
  put(json, R"({{"all":{},"horn":{},"dropped":{})", all, horn(), dropped_);
  json += R"(,"list":[)";
}

void AlarmList::put_all(std::string& json) const {
  put_head(json, true);
  for (const auto& [name, entry] : entries_) put_entry(json, entry);
  json += R"(],"left":[]})";
}

void AlarmList::put_changes(std::string& json) const {
  if (all_changed_) {
    put_all(json);
  } else {
    put_head(json, false);
    std::string left;
    for (const std::string& name : changed_) {
      if (const Entry* const entry = find(name); entry != nullptr) {
        put_entry(json, *entry);
      } else {
        left.append(left.empty() ? "" : ",").append(trace::json_string(name));
      }
    }
    json += R"(],"left":[)" + left + "]}";
  }
}

void AlarmList::forget_changes() {
  changed_.clear();
  all_changed_ = head_changed_ = false;
}

}  // namespace symplant::panel
