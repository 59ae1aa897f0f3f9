// Rules: names and comments in a row.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "check/rules.hpp"
#include "text/ascii.hpp"
#include "text/shape.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

constexpr std::size_t kShortestSeries = 6;

/// A symbol with an address, and the last number of its name or comment.
struct Numbered {
  const model::Symbol* symbol;
  std::uint64_t number;
  std::string_view before;
  std::string_view digits;
  std::string_view after;
};

std::optional<Numbered> numbered(const model::Symbol& symbol) {
  const std::string_view text = symbol.row->is_named_by_address() ? symbol.row->comment : symbol.name();
  std::size_t end = text.size();
  while (end > 0 && !text::is_digit(text[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && text::is_digit(text[begin - 1])) --begin;
  const std::string_view digits = text.substr(begin, end - begin);
  std::uint64_t value = 0;
  if (digits.empty() || digits.size() > 9) return std::nullopt;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return Numbered{&symbol, value, text.substr(0, begin), digits, text.substr(end)};
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

  /// Reports the odd one of each run of neighboring addresses whose symbols have one text but for the last number.
  /// `side` is sorted by address.
  void look_at(const std::vector<const model::Symbol*>& side) {
    std::vector<Numbered> run;
    for (const model::Symbol* symbol : side) {
      const auto next = numbered(*symbol);
      if (!run.empty() && !(next && continues(run.back(), *next))) end_run(run);
      if (next) run.push_back(*next);
    }
    end_run(run);
  }

 private:
  static bool continues(const Numbered& last, const Numbered& next) {
    return next.symbol->address->number == last.symbol->address->number + 1 && next.after == last.after &&
           next.before == last.before;
  }

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

/// The BOOL symbols with an address, by list and side and in the order of addresses.
using AddressSides = std::map<std::pair<std::uint32_t, address::Area>, std::vector<const model::Symbol*>>;

AddressSides address_sides_of(const model::PlantModel& plant) {
  const auto key = [](const model::Symbol* symbol) {
    return std::tuple(symbol->address->size, symbol->address->plain, symbol->address->number);
  };
  const auto is_before = [&](const model::Symbol* a, const model::Symbol* b) { return key(a) < key(b); };
  AddressSides sides;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!symbol.address || symbol.type != tables::DataType::boolean || symbol.leader != model::kNone) continue;
    sides[{symbol.list, symbol.address->area}].push_back(&symbol);
  }
  for (auto& [where, side] : sides) {
    if (!std::is_sorted(side.begin(), side.end(), is_before)) std::stable_sort(side.begin(), side.end(), is_before);
  }
  return sides;
}

void check_series_broken(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  SeriesSearch search(rule, subject.plant, diagnostics);
  for (const auto& [where, side] : address_sides_of(subject.plant)) search.look_at(side);
}

constexpr std::size_t kLeastUnique = 20;
constexpr std::size_t kMostShare = 20;  ///< of 20 comments at most one may be used twice
constexpr std::size_t kShortestComment = 8;

using Points = std::vector<const model::Symbol*>;
using ByComment = std::map<std::pair<std::string_view, tables::Direction>, Points>;

void report(const Rule& rule, const model::PlantModel& plant, const ByComment& comments,
            diag::Diagnostics& diagnostics) {
  std::vector<const Points*> pairs;
  for (const auto& [comment, points] : comments) {
    if (points.size() == 2) pairs.push_back(&points);  // more are spares, or mean one thing
  }
  if (pairs.empty()) return;
  std::sort(pairs.begin(), pairs.end(),
            [](const Points* a, const Points* b) { return a->front()->row < b->front()->row; });
  const model::Symbol& first = *pairs.front()->front();
  const model::Symbol& second = *pairs.front()->back();
  std::vector<diag::Related> related;
  for (const Points* points : pairs) {
    for (const model::Symbol* symbol : *points) {
      if (symbol == &second) continue;
      related.push_back({location_of(plant, *symbol->row, symbol->row->comment),
                         fmt::format("`{}`: `{}`", symbol->name(), symbol->row->comment)});
    }
  }
  const std::string more = pairs.size() == 1 ? "" : fmt::format("; so do {} more pairs of points", pairs.size() - 1);
  diagnostics.add(rule.info, about(second, first),
                  fmt::format("`{}` and `{}` have the same comment `{}`{}; number or correct them", second.name(),
                              first.name(), second.row->comment, more),
                  location_of(plant, *second.row, second.row->comment), std::move(related));
}

void check_comment_twice(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::vector<ByComment> lists(plant.lists.size());
  for (const model::Symbol& symbol : plant.symbols) {
    const std::string_view comment = symbol.row->comment;
    if (!symbol.row->is_named_by_address() || comment.size() < kShortestComment || symbol.leader != model::kNone)
      continue;
    lists[symbol.list][{comment, symbol.direction}].push_back(&symbol);
  }
  for (const auto& comments : lists) {
    std::size_t unique = 0;
    for (const auto& [comment, points] : comments) unique += points.size() == 1 ? 1U : 0U;
    if (unique < kLeastUnique || (comments.size() - unique) * kMostShare > comments.size()) continue;
    report(rule, plant, comments, diagnostics);
  }
}

}  // namespace

const Rule kSeriesBroken{
    {"SP321", "series-broken", diag::Severity::warning, "one number of a series of names does not fit",
     R"(Symbols on addresses one after the other have names or comments that differ only in their last number. The numbers rise by one, or
double as the weights of bits do (1, 2, 4 ... 64, 128), except for one: `CODE_64` and then `CODE_12`. Most often a digit is missing.

**What the model loses.** The symbol with the wrong number is paired with another one, or with none.

**How to fix it.** Write the number that continues the series.
)"},
    check_series_broken};

const Rule kCommentTwice{
    {"SP322", "comment-twice", diag::Severity::warning, "two points have one comment",
     R"(Two inputs, or two outputs, of a list that names its points by comments have the same comment, and nearly all other comments of the
list are unique. Most often a row was copied and its comment not changed. There is one finding for each list.

**What the model loses.** A naming rule that reads comments cannot distinguish the two: both are the same symbol of a device.

**How to fix it.** Correct the comment that is wrong. If two points mean one thing, number them: `LIMIT 1`, `LIMIT 2`.
)"},
    check_comment_twice};

}  // namespace symplant::check
