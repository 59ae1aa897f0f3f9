// Compares two traces change by change.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "compare/difference.hpp"
#include "compare/numbers.hpp"
#include "compare/offsets.hpp"
#include "symplant/tables/nearest.hpp"
#include "symplant/tables/pattern.hpp"

namespace symplant::compare {
namespace {

using tables::Time;
using Kind = Difference::Kind;

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

bool matches_any(const std::vector<std::string>& patterns, const std::string& name) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return tables::matches_pattern(name, pattern); });
}

/// A warning of a pattern of `--only` that no element matches, which may be a mistake.
std::string unmatched(const std::vector<std::string>& patterns, const Recording& expected, const Recording& actual) {
  for (const std::string& pattern : patterns) {
    const auto matches = [&](const Series& series) { return tables::matches_pattern(series.name, pattern); };
    if (std::none_of(expected.series.begin(), expected.series.end(), matches) &&
        std::none_of(actual.series.begin(), actual.series.end(), matches)) {
      return fmt::format("no symbol with a change matches `{}`", pattern);
    }
  }
  return "";
}

/// When a symbol comes on for the first time; nothing if it does not.
std::optional<Time> first_on(const Recording& recorded, const std::string& name) {
  const Series* const series = recorded.find({name, Series::Kind::boolean, {}, {}, {}});
  if (series == nullptr) return std::nullopt;
  for (const Series::Change& change : series->changes) {
    if (change.value != 0) return change.time;
  }
  return std::nullopt;
}

std::string never_on(const Recording& recorded, const std::string& name) {
  if (recorded.find({name, Series::Kind::boolean, {}, {}, {}}) != nullptr) {
    return fmt::format("`{}` never comes on in {}", name, recorded.name);
  }
  tables::NearestName nearest(name);
  for (const Series& series : recorded.series) nearest.offer(series.name);
  for (const char* const word : {"none", "follow"}) nearest.offer(word);
  return fmt::format("{} has no change of `{}`{}", recorded.name, name,
                     nearest.name().empty() ? "" : fmt::format("; did you mean `{}`?", nearest.name()));
}

/// The index of the first change that is one: recordings begin with a value of each symbol, which may be off.
std::size_t first_change(const Series& series) {
  return series.kind != Series::Kind::parts && !series.changes.empty() && series.changes[0].value == 0 ? 1 : 0;
}

/// The walk over EXPECTED's changes that are on or off, or parts.
class Walk {
 public:
  Walk(Comparison& result, const Options& options, Time offset)
      : result_(result),
        expected_(*result.expected),
        actual_(*result.actual),
        follows_(options.align == Align::follow),
        offsets_(offset),
        places_(expected_.series.size()) {}

  void pair_with(std::size_t series, const Series* actual) {
    places_[series] = {true, actual};
    if (actual != nullptr) places_[series].cursor = first_change(*actual);
  }

  void run() {
    for (std::size_t i = 0; i < expected_.order.size();) i = run_time(i);
    for (std::size_t s = 0; s < places_.size(); ++s) {
      Place& place = places_[s];
      if (!place.compared || place.actual == nullptr || place.actual->kind == Series::Kind::number) continue;
      pass_over(*place.actual, place, place.actual->changes.size());
    }
  }

  /// All changes of an element that EXPECTED does not have.
  void unexpected(const Series& actual) {
    Place place{true, &actual};
    place.cursor = first_change(actual);
    pass_over(actual, place, actual.changes.size());
  }

  const Offsets& offsets() const { return offsets_; }
  std::size_t behind_expected() const { return behind_expected_; }
  std::size_t behind_actual() const { return behind_actual_; }

 private:
  /// Where the walk is in one element.
  struct Place {
    bool compared = false;
    const Series* actual = nullptr;
    std::size_t next = 0;             ///< of EXPECTED's changes
    std::size_t cursor = 0;           ///< of ACTUAL's changes: those before are paired or unexpected
    std::optional<Time> offset = {};  ///< of its last pair
    std::size_t missing = kNone;      ///< the difference about the change before, if that is missing
  };

  /// A change of EXPECTED without a counterpart so far.
  struct Open {
    std::uint32_t series;
    std::size_t at;
  };

  /// How far ACTUAL's change is from its time: by the nearer offset.
  Time delay(const Place& place, Time expected, Time actual) const {
    const Time by_any = actual - expected - offsets_.last();
    if (!follows_ || !place.offset) return by_any;
    const Time by_own = actual - expected - *place.offset;
    return std::abs(by_own) < std::abs(by_any) ? by_own : by_any;
  }

  /// All changes of one time. What has no counterpart is looked for again once the others are paired: it may follow
  /// from one of them, which is late. Returns where the next time begins.
  std::size_t run_time(std::size_t i) {
    const Time time = time_of(i);
    open_.clear();
    for (; i < expected_.order.size() && time_of(i) == time; ++i) {
      const std::uint32_t series = expected_.order[i];
      Place& place = places_[series];
      const std::size_t at = place.next++;
      if (at < first_change(expected_.series[series])) continue;
      if (place.compared && expected_.series[series].kind != Series::Kind::number) open_.push_back({series, at});
    }
    if (time + offsets_.last() > actual_.end + result_.window) {
      behind_expected_ += open_.size();
      return i;
    }
    result_.changes += open_.size();
    for (const bool also_late : {false, true, true}) {
      std::erase_if(open_, [&](const Open& one) { return is_paired(one, also_late); });
    }
    for (const Open& one : open_) miss(expected_.series[one.series], places_[one.series], one.at);
    return i;
  }

  Time time_of(std::size_t i) const {
    const std::uint32_t series = expected_.order[i];
    const auto& changes = expected_.series[series].changes;
    return changes[std::min(places_[series].next, changes.size() - 1)].time;
  }

  bool is_paired(const Open& one, bool also_late) {
    const Series& of = expected_.series[one.series];
    Place& place = places_[one.series];
    if (place.actual == nullptr) return false;
    const Series::Change& change = of.changes[one.at];
    if (const std::size_t found = within_window(place, change); found != kNone) {
      pair(*place.actual, place, change, found);
      return true;
    }
    const std::size_t found = also_late ? next_free(place, change) : kNone;
    if (found == kNone) return false;
    const Time there = place.actual->changes[found].time;
    const Time by = delay(place, change.time, there);
    if (one.at + 1 < of.changes.size() && there >= of.changes[one.at + 1].time + (there - by - change.time))
      return false;
    add({by > 0 ? Kind::late : Kind::early, &of, change.time, std::abs(by), change.value, change.value});
    pair(*place.actual, place, change, found);
    return true;
  }

  /// The first free change to the same value whose time is right.
  std::size_t within_window(const Place& place, const Series::Change& change) const {
    const Time latest =
        std::max(offsets_.last(), place.offset.value_or(offsets_.last())) + change.time + result_.window;
    const auto& changes = place.actual->changes;
    for (std::size_t i = place.cursor; i < changes.size() && changes[i].time <= latest; ++i) {
      if (changes[i].value == change.value && std::abs(delay(place, change.time, changes[i].time)) <= result_.window) {
        return i;
      }
    }
    return kNone;
  }

  static std::size_t next_free(const Place& place, const Series::Change& change) {
    const auto& changes = place.actual->changes;
    for (std::size_t i = place.cursor; i < changes.size(); ++i) {
      if (changes[i].value == change.value) return i;
    }
    return kNone;
  }

  void pair(const Series& actual, Place& place, const Series::Change& change, std::size_t found) {
    pass_over(actual, place, found);
    place.cursor = found + 1;
    place.missing = kNone;
    if (!follows_) return;
    place.offset = actual.changes[found].time - change.time;
    offsets_.add(change.time, *place.offset);
  }

  /// What ACTUAL has before its change `to` is unexpected.
  void pass_over(const Series& actual, Place& place, std::size_t to) {
    bool half = false;  // the change before is a difference that may become a pulse
    for (; place.cursor < to; ++place.cursor) {
      const Series::Change& change = actual.changes[place.cursor];
      if (change.time > expected_.end + offsets_.last() + result_.window) {
        ++behind_actual_;
        continue;
      }
      if (half && actual.kind == Series::Kind::boolean) {
        half = false;
        close_pulse(result_.differences.back(), change.time);
        continue;
      }
      half = true;
      add({Kind::unexpected, &actual, change.time, 0, 0, change.value});
    }
  }

  void miss(const Series& of, Place& place, std::size_t at) {
    if (place.missing != kNone && of.kind == Series::Kind::boolean) {
      close_pulse(result_.differences[std::exchange(place.missing, kNone)], of.changes[at].time);
      return;
    }
    place.missing = result_.differences.size();
    add({Kind::missing, &of, of.changes[at].time, 0, of.changes[at].value, 0});
  }

  static void close_pulse(Difference& difference, Time end) {
    difference.is_pulse = true;
    difference.by = end - difference.time;
  }

  void add(const Difference& difference) { result_.differences.push_back(difference); }

  Comparison& result_;
  const Recording& expected_;
  const Recording& actual_;
  bool follows_;
  Offsets offsets_;
  std::vector<Place> places_;
  std::vector<Open> open_;
  std::size_t behind_expected_ = 0;
  std::size_t behind_actual_ = 0;
};

std::size_t changes_after(const Series& series, Time time) {
  return static_cast<std::size_t>(std::count_if(series.changes.begin(), series.changes.end(),
                                                [&](const Series::Change& change) { return change.time > time; }));
}

class Comparer {
 public:
  Comparer(const Recording& expected, const Recording& actual, const Options& options) : options_(options) {
    result_.expected = &expected;
    result_.actual = &actual;
    result_.window =
        std::min(options.window.value_or(2 * std::max(expected.resolution, actual.resolution)), kLatestTime);
  }

  Comparison run() {
    result_.warning = unmatched(options_.only, *result_.expected, *result_.actual);
    const Time offset = offset_at_begin();
    Walk walk(result_, options_, offset);
    choose(walk);
    if (!result_.error.empty()) return std::move(result_);
    walk.run();
    for (const Series* const extra : extra_) {
      if (extra->kind != Series::Kind::number) walk.unexpected(*extra);
    }
    compare_numbers(walk);
    add_ends(walk);
    drop_unseen_pulses();
    const Time exact_to = std::max(result_.expected->resolution, result_.actual->resolution);
    for (Difference& difference : result_.differences) difference.exact_to = exact_to;
    std::stable_sort(result_.differences.begin(), result_.differences.end(),
                     [](const Difference& a, const Difference& b) { return a.time < b.time; });
    return std::move(result_);
  }

 private:
  Time offset_at_begin() {
    if (options_.align != Align::symbol) return 0;
    std::array<Time, 2> times{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Recording& recorded = i == 0 ? *result_.expected : *result_.actual;
      const auto on = first_on(recorded, options_.align_symbol);
      if (!on && result_.error.empty()) result_.error = never_on(recorded, options_.align_symbol);
      times[i] = on.value_or(0);
    }
    return times[1] - times[0];
  }

  bool chosen(const Series& series) const {
    if (series.kind == Series::Kind::parts && !(result_.expected->has_parts && result_.actual->has_parts)) return false;
    return is_chosen(options_, series.name);
  }

  void choose(Walk& walk) {
    const Recording& expected = *result_.expected;
    const Recording& actual = *result_.actual;
    for (std::size_t s = 0; s < expected.series.size(); ++s) {
      const Series& series = expected.series[s];
      if (!chosen(series)) continue;
      const Series* const other = actual.find(series);
      if (other == nullptr && !actual.of_plant) {
        result_.not_recorded.push_back(&series);
        continue;
      }
      if (other != nullptr && other->kind != series.kind && result_.error.empty()) {
        result_.error = fmt::format("`{}` is a BOOL in one of the traces and a number in the other", series.name);
      }
      result_.compared.push_back(&series);
      walk.pair_with(s, other);
    }
    for (const Series& series : actual.series) {
      if (!chosen(series) || expected.find(series) != nullptr) continue;
      if (!expected.of_plant) {
        result_.not_recorded.push_back(&series);
        continue;
      }
      result_.compared.push_back(&series);
      extra_.push_back(&series);
    }
  }

  void compare_numbers(const Walk& walk) {
    const Recording& expected = *result_.expected;
    const Recording& actual = *result_.actual;
    const Time until = std::min(expected.end, actual.end - walk.offsets().last()) + result_.window;
    const Limits limits{result_.window, options_.tolerance, until};
    for (const Series* const series : result_.compared) {
      if (series->kind != Series::Kind::number) continue;
      const bool extra = expected.find(*series) == nullptr;
      const Series* const other = actual.find(*series);
      const Series none{series->name, series->kind, {}, {}, {}};
      const std::size_t before = result_.differences.size();
      add_deviations(extra ? none : *series, other, walk.offsets(), limits, result_.differences);
      for (std::size_t i = before; i < result_.differences.size(); ++i) result_.differences[i].of = series;
      if (!extra) {
        const std::size_t behind = changes_after(*series, until);
        result_.changes += series->changes.size() - behind;
        behind_expected_ += behind;
      }
      if (other != nullptr) behind_actual_ += changes_after(*other, until + walk.offsets().last());
    }
  }

  /// A trace has every change, a recording only what its readings see.
  void drop_unseen_pulses() {
    const auto shortest = [&](const Recording& without) {
      return without.of_plant ? 0 : std::min(result_.window, 2 * without.resolution);
    };
    const Time in_expected = shortest(*result_.expected);
    const Time in_actual = shortest(*result_.actual);
    std::erase_if(result_.differences, [&](const Difference& difference) {
      return difference.is_pulse && difference.by < (difference.kind == Kind::missing ? in_actual : in_expected);
    });
  }

  /// Changes of one trace after the end of the other.
  void add_ends(const Walk& walk) {
    const auto add = [&](Kind kind, Time end, std::size_t changes) {
      if (changes == 0) return;
      Difference found{kind, nullptr, end};
      found.changes = changes;
      result_.differences.push_back(found);
    };
    add(Kind::actual_ends, result_.actual->end, walk.behind_expected() + behind_expected_);
    add(Kind::expected_ends, result_.expected->end, walk.behind_actual() + behind_actual_);
  }

  const Options& options_;
  Comparison result_;
  std::vector<const Series*> extra_;  ///< those that only ACTUAL has
  std::size_t behind_expected_ = 0;
  std::size_t behind_actual_ = 0;
};

}  // namespace

Comparison compare(const Recording& expected, const Recording& actual, const Options& options) {
  return Comparer(expected, actual, options).run();
}

bool is_chosen(const Options& options, const std::string& name) {
  return (options.only.empty() || matches_any(options.only, name)) && !matches_any(options.ignore, name);
}

void drop_unsure(Comparison& comparison) {
  const Time sure = std::min(comparison.expected->end, comparison.actual->end) - comparison.window;
  std::erase_if(comparison.differences, [&](const Difference& difference) {
    const bool alone = difference.kind == Kind::missing || difference.kind == Kind::unexpected;
    return comparison.window > 0 && alone && difference.time > sure;
  });
}

Align align_of(std::string_view text) {
  if (text == "none") return Align::none;
  return text == "follow" ? Align::follow : Align::symbol;
}

std::optional<double> parse_tolerance(std::string_view text) {
  const bool percent = text.ends_with('%');
  if (percent) text.remove_suffix(1);
  double share = 0;
  const auto [at, error] = std::from_chars(text.data(), text.data() + text.size(), share);
  if (error != std::errc() || at != text.data() + text.size() || !std::isfinite(share) || share < 0)
    return std::nullopt;
  if (!percent && share != 0) return std::nullopt;
  return share / 100;
}

}  // namespace symplant::compare
