// SP321 series-broken: one number of a series of names does not fit.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "check/rules.hpp"
#include "text/ascii.hpp"
#include "text/shape.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kSeriesBrokenPage =
    R"(Symbols on addresses one after the other have names or comments that differ only in their last number. The numbers rise by one, or
double as the weights of bits do (1, 2, 4 ... 64, 128), except for one: `CODE_64` and then `CODE_12`. Most often a digit is missing.

**What the model loses.** The symbol with the wrong number is paired with another one, or with none.

**How to fix it.** Write the number that continues the series.
)";

constexpr std::size_t kShortestSeries = 6;

/// A symbol with an address and the last number of its name or comment.
struct Numbered {
  const model::Symbol* symbol;
  std::uint64_t number;
  std::string_view digits;
};

std::optional<Numbered> numbered(const model::Symbol& symbol, std::string_view text) {
  const auto is_digit = [](char c) { return text::is_digit(c); };
  const auto last = std::find_if(text.rbegin(), text.rend(), is_digit);
  if (last == text.rend()) return std::nullopt;
  const auto before = std::find_if_not(last, text.rend(), is_digit);
  const auto begin = static_cast<std::size_t>(text.rend() - before);
  const std::string_view digits = text.substr(begin, static_cast<std::size_t>(before - last));
  std::uint64_t value = 0;
  if (digits.size() > 9) return std::nullopt;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return Numbered{&symbol, value, digits};
}

/// What a series has at an index, by its first number: `1, 2, 3` or `1, 2, 4`.
using Series = std::uint64_t (*)(std::uint64_t first, std::size_t index);
std::uint64_t by_one(std::uint64_t first, std::size_t index) { return first + index; }
std::uint64_t doubling(std::uint64_t first, std::size_t index) { return first << std::min<std::size_t>(index, 31); }

/// The index of the one member that does not fit, if all others do. The first two numbers fit.
std::optional<std::size_t> odd_one(const std::vector<Numbered>& run, Series series) {
  std::optional<std::size_t> odd;
  for (std::size_t i = 0; i < run.size(); ++i) {
    if (run[i].number == series(run.front().number, i)) continue;
    if (odd || i < 2) return std::nullopt;
    odd = i;
  }
  return odd;
}

class SeriesSearch {
 public:
  SeriesSearch(const Rule& rule, const model::PlantModel& plant, diag::Diagnostics& diagnostics)
      : rule_(rule), plant_(plant), diagnostics_(diagnostics) {}

  /// Reports the odd one of each run of neighboring addresses in symbols of one text but for the last number.
  void look_at(std::vector<Numbered>& group) {
    if (group.size() < kShortestSeries) return;
    std::stable_sort(group.begin(), group.end(), [](const Numbered& a, const Numbered& b) {
      return a.symbol->address->number < b.symbol->address->number;
    });
    std::vector<Numbered> run;
    for (const Numbered& next : group) {
      if (!run.empty() && next.symbol->address->number != run.back().symbol->address->number + 1) end_run(run);
      run.push_back(next);
    }
    end_run(run);
  }

 private:
  void end_run(std::vector<Numbered>& run) {
    if (run.size() >= kShortestSeries) {
      for (const Series series : {by_one, doubling}) {
        if (const auto odd = odd_one(run, series)) report(run, *odd, series(run.front().number, *odd));
      }
    }
    run.clear();
  }

  void report(const std::vector<Numbered>& run, std::size_t odd, std::uint64_t expected) {
    const Numbered& member = run[odd];
    const model::Symbol& before = *run[odd - 1].symbol;
    diagnostics_.add(
        rule_.info, about(*member.symbol),
        fmt::format("`{}` breaks the series of {} symbols from `{}` on: its number is {}, and {} continues "
                    "the series",
                    member.symbol->name(), run.size(), run.front().symbol->name(), member.number, expected),
        location_of(plant_, *member.symbol->row, member.digits), {{location_of(plant_, before), "the one before"}});
  }

  const Rule& rule_;
  const model::PlantModel& plant_;
  diag::Diagnostics& diagnostics_;
};

/// What the members of a series have in common: list, side, and text but for the number.
struct SeriesKey {
  std::uint32_t list;
  address::Area area;
  std::string_view before;
  std::string_view after;

  bool operator==(const SeriesKey&) const = default;
};

struct HashSeriesKey {
  std::size_t operator()(const SeriesKey& key) const {
    const std::hash<std::string_view> hash;
    const std::size_t where = 31 * std::size_t{key.list} + static_cast<std::size_t>(key.area);
    return 31 * (31 * hash(key.before) + hash(key.after)) + where;
  }
};

void check_series_broken(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::unordered_map<SeriesKey, std::size_t, HashSeriesKey> group_of;
  std::vector<std::vector<Numbered>> groups;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!symbol.address || symbol.type != tables::DataType::boolean || symbol.leader != model::kNone) continue;
    const bool by_comment = symbol.row->is_named_by_address();
    const std::string_view text = by_comment ? symbol.row->comment : symbol.name();
    if (const auto found = numbered(symbol, text)) {
      const auto begin = static_cast<std::size_t>(found->digits.data() - text.data());
      const SeriesKey key{symbol.list, symbol.address->area, text.substr(0, begin),
                          text.substr(begin + found->digits.size())};
      const auto [group, added] = group_of.try_emplace(key, groups.size());
      if (added) groups.emplace_back();
      groups[group->second].push_back(*found);
    }
  }
  SeriesSearch search(rule, plant, diagnostics);
  for (std::vector<Numbered>& group : groups) search.look_at(group);
}

}  // namespace

const Rule kSeriesBroken{{"SP321", "series-broken", diag::Severity::warning,
                          "one number of a series of names does not fit", kSeriesBrokenPage},
                         check_series_broken};

}  // namespace symplant::check
