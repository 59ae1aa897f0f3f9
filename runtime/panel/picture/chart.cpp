// What changed lately, for charts.
#include "symplant/panel/picture/chart.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

#include "symplant/panel/picture/json_text.hpp"

namespace symplant::panel {
namespace {

using trace::Record;

/// Of a packed state, what a chart shows.
constexpr std::uint64_t kShown = 0x1FFFF;  // state, target, moving

}  // namespace

void Chart::Ring::add(const Change& change) {
  if (changes_.size() < kMost) {
    changes_.push_back(change);
  } else {
    begin_ = at(first_).time;
    first_ = next_ + 1 - kMost;
    changes_[next_ % kMost] = change;
  }
  ++next_;
}

void Chart::Ring::set_back(tables::Time time) {
  changes_.clear();
  next_ += kMost - next_ % kMost;  // so that the numbers go on, and the ring begins at its first slot
  first_ = next_;
  begin_ = time;
}

std::uint64_t Chart::Ring::first_at(tables::Time from) const {
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

void Chart::apply(const Record& record) {
  if (record.kind == Record::Kind::change) {
    changes_.add({record.time, history_.value(record.of), record.value, record.of, Of::symbol});
  } else if (record.kind == Record::Kind::unit) {
    const std::uint64_t before = now_of(Of::device, record.of);
    if ((before & kShown) == (record.value & kShown)) return;
    changes_.add({record.time, before, record.value, record.of, Of::device});
  } else if (record.kind == Record::Kind::value) {
    values_.add({record.time, now_of(Of::value, record.of), record.value, record.of, Of::value});
  }
}

void Chart::set_back(tables::Time time) {
  changes_.set_back(time);
  values_.set_back(time);
}

std::uint64_t Chart::now_of(Of kind, std::uint32_t of) const {
  switch (kind) {
    case Of::symbol:
      return history_.value(of);
    case Of::device:
      return trace::pack_unit(history_.unit(of));
    case Of::value:
      break;
  }
  return std::bit_cast<std::uint64_t>(history_.output(of));
}

void Chart::put_value(std::string& json, std::uint32_t of, Of kind, tables::Time time, std::uint64_t value) const {
  put_comma(json);
  if (kind == Of::device) {
    const plant::UnitView view = trace::unpack_unit(value);
    put(json, "[{},{},{}]", time, view.state, view.moving ? view.target : view.state);
  } else {
    const tables::DataType type = kind == Of::value ? tables::DataType::lreal : names_.tables().symbols[of].type();
    put(json, "[{},{}]", time, trace::json_value(type, value));
  }
}

/// The lists of an answer.
struct Chart::Answer {
  struct Series {
    std::string json = "[";
    bool begun = false;
  };

  /// Adds the changes of a ring, from the one at `from` on, or from `after` on if they are kept. Returns the number of
  /// the next one.
  std::uint64_t add(const Chart& chart, const Ring& ring, std::uint64_t after, tables::Time to) {
    const bool continues = ring.continues(after);
    std::uint64_t number = continues ? std::min(after, ring.next()) : ring.first_at(from);
    for (; number < ring.next() && ring.at(number).time <= to; ++number) {
      const Change& change = ring.at(number);
      const auto found = series.find({change.kind, change.of});
      if (found == series.end()) continue;
      Series& of = found->second;
      if (!std::exchange(of.begun, true) && !continues) {
        chart.put_value(of.json, change.of, change.kind, from, change.before);
      }
      chart.put_value(of.json, change.of, change.kind, change.time, change.after);
    }
    return number;
  }

  tables::Time from;
  std::map<std::pair<Of, std::uint32_t>, Series> series = {};
};

std::string Chart::text(const ChartWish& wish, tables::Time now) const {
  const bool of_values = !wish.values.empty();
  const bool continues = changes_.continues(wish.after);
  const bool values_continue = values_.continues(wish.after_value);
  Answer answer{wish.from};
  if (!continues) answer.from = std::max(answer.from, changes_.begin());
  if (of_values && !values_continue) answer.from = std::max(answer.from, values_.begin());
  for (const std::uint32_t symbol : wish.symbols) answer.series[{Of::symbol, symbol}];
  for (const std::uint32_t device : wish.devices) answer.series[{Of::device, device}];
  for (const std::uint32_t value : wish.values) answer.series[{Of::value, value}];
  const std::uint64_t next = answer.add(*this, changes_, wish.after, wish.to);
  const std::uint64_t next_value = answer.add(*this, values_, wish.after_value, wish.to);
  std::string json = "{";
  put(json, "\"from\":{},\"to\":{},\"next\":{}", answer.from, std::min(wish.to, now), next);
  const auto put_series = [&](std::string_view key, Of kind, const std::vector<std::uint32_t>& wished, bool goes_on) {
    put_key(json, key);
    json += '[';
    for (const std::uint32_t of : wished) {
      Answer::Series& found = answer.series[{kind, of}];
      const bool is_known = kind != Of::value || history_.shows(of);
      if (!found.begun && !goes_on && is_known) {
        put_value(found.json, of, kind, answer.from, now_of(kind, of));
        found.begun = true;
      }
      put_comma(json);
      json += found.json + "]";
    }
    json += ']';
  };
  put_series("symbols", Of::symbol, wish.symbols, continues);
  put_series("devices", Of::device, wish.devices, continues);
  if (of_values) {
    put(json, ",\"next_value\":{}", next_value);
    put_series("values", Of::value, wish.values, values_continue);
  }
  return json + "}";
}

}  // namespace symplant::panel
