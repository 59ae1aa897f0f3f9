// What changed lately, for charts.
#include "symplant/panel/picture/chart.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "symplant/panel/picture/json_text.hpp"

namespace symplant::panel {
namespace {

using trace::Record;

/// Of a packed state, what a chart shows.
constexpr std::uint64_t kShown = 0x1FFFF;  // state, target, moving

}  // namespace

void Chart::apply(const Record& record) {
  const bool is_device = record.kind == Record::Kind::unit;
  if (!is_device && record.kind != Record::Kind::change) return;
  const std::uint64_t before = is_device ? trace::pack_unit(history_.unit(record.of)) : history_.value(record.of);
  const Change change{record.time, before, record.value, record.of, is_device};
  if (is_device && (before & kShown) == (record.value & kShown)) return;
  if (changes_.size() < kMost) {
    changes_.push_back(change);
  } else {
    begin_ = at(first_).time;
    first_ = next_ + 1 - kMost;
    changes_[next_ % kMost] = change;
  }
  ++next_;
}

void Chart::set_back(tables::Time time) {
  changes_.clear();
  next_ += kMost - next_ % kMost;  // so that the numbers go on, and the ring begins at its first slot
  first_ = next_;
  begin_ = time;
}

/// The number of the first change to report; `from` becomes the time from which on they are complete.
std::uint64_t Chart::first_from(const ChartWish& wish, tables::Time& from) const {
  if (wish.after >= first_ && wish.after != 0) return std::min(wish.after, next_);
  from = std::max(wish.from, begin_);
  std::uint64_t low = first_;
  std::uint64_t high = next_;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    if (at(middle).time < from) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

void Chart::put_value(std::string& json, std::uint32_t of, bool is_device, tables::Time time,
                      std::uint64_t value) const {
  put_comma(json);
  if (is_device) {
    const plant::UnitView view = trace::unpack_unit(value);
    put(json, "[{},{},{}]", time, view.state, view.moving ? view.target : view.state);
  } else {
    put(json, "[{},{}]", time, trace::json_value(names_.tables().symbols[of].type(), value));
  }
}

std::string Chart::text(const ChartWish& wish, tables::Time now) const {
  tables::Time from = wish.from;
  const std::uint64_t first = first_from(wish, from);
  const bool continues = wish.after != 0 && wish.after >= first_;
  struct Series {
    std::string json = "[";
    bool begun = false;
  };
  std::map<std::pair<bool, std::uint32_t>, Series> series;
  for (const std::uint32_t symbol : wish.symbols) series[{false, symbol}];
  for (const std::uint32_t device : wish.devices) series[{true, device}];
  std::uint64_t number = first;
  for (; number < next_ && at(number).time <= wish.to; ++number) {
    const Change& change = at(number);
    const auto found = series.find({change.is_device, change.of});
    if (found == series.end()) continue;
    Series& of = found->second;
    if (!std::exchange(of.begun, true) && !continues)
      put_value(of.json, change.of, change.is_device, from, change.before);
    put_value(of.json, change.of, change.is_device, change.time, change.after);
  }
  std::string json = "{";
  put(json, "\"from\":{},\"to\":{},\"next\":{}", from, std::min(wish.to, now), number);
  const auto put_series = [&](std::string_view key, bool is_device, const std::vector<std::uint32_t>& wished) {
    put_key(json, key);
    json += '[';
    for (const std::uint32_t of : wished) {
      Series& found = series[{is_device, of}];
      if (!found.begun && !continues) {
        put_value(found.json, of, is_device, from,
                  is_device ? trace::pack_unit(history_.unit(of)) : history_.value(of));
        found.begun = true;
      }
      put_comma(json);
      json += found.json + "]";
    }
    json += ']';
  };
  put_series("symbols", false, wish.symbols);
  put_series("devices", true, wish.devices);
  return json + "}";
}

}  // namespace symplant::panel
