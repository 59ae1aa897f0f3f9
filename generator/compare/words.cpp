// Words about differences that all forms share.
#include "compare/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>

#include "symplant/trace/words.hpp"

namespace symplant::compare {
namespace {

using Kind = Difference::Kind;

constexpr std::array<std::string_view, 7> kNames{"missing",  "unexpected",    "late",       "early",
                                                 "deviates", "expected ends", "actual ends"};

std::string value_words(const Series& series, double value) {
  switch (series.kind) {
    case Series::Kind::boolean:
      return value != 0 ? "on" : "off";
    case Series::Kind::parts:
      return "arrives";
    case Series::Kind::number:
      break;
  }
  return fmt::format("{}", value);
}

/// A time without the digits far below what times are exact to.
std::string seconds(const Difference& difference, tables::Time time) {
  tables::Time step = 1;
  while (step <= difference.exact_to / 100) step *= 10;
  const tables::Time rounded = (time + step / 2) / step * step;
  return trace::seconds(rounded == 0 ? time : rounded);
}

std::string pulse_words(const Difference& difference) {
  const double value = difference.kind == Kind::missing ? difference.expected : difference.actual;
  return fmt::format("{}: {}{}", kind_name(difference.kind), value_words(*difference.of, value),
                     difference.is_pulse ? " for " + seconds(difference, difference.by) : "");
}

}  // namespace

std::string_view kind_name(Kind kind) { return kNames[static_cast<std::size_t>(kind)]; }

std::string name_of(const Series& series) {
  return series.kind == Series::Kind::parts ? series.part + " at " + series.name : series.name;
}

std::string difference_words(const Difference& difference) {
  switch (difference.kind) {
    case Kind::missing:
    case Kind::unexpected:
      return pulse_words(difference);
    case Kind::late:
    case Kind::early:
      return fmt::format("{} by {}: {}", kind_name(difference.kind), seconds(difference, difference.by),
                         value_words(*difference.of, difference.expected));
    case Kind::deviates:
      return fmt::format("deviates for {}: {}, not {}", seconds(difference, difference.by), difference.actual,
                         difference.expected);
    case Kind::expected_ends:
      return fmt::format("EXPECTED ends here: {} of ACTUAL {} later", counted(difference.changes, "change"),
                         difference.changes == 1 ? "is" : "are");
    case Kind::actual_ends:
      break;
  }
  return fmt::format("ACTUAL ends here: {} of EXPECTED {} later", counted(difference.changes, "change"),
                     difference.changes == 1 ? "is" : "are");
}

std::string sentence(const Difference& difference) {
  const std::string words = difference_words(difference);
  const std::string at = seconds(difference, difference.time);
  if (difference.of == nullptr) return fmt::format("at {}: {}", at, words);
  return fmt::format("at {}: `{}` {}", at, name_of(*difference.of), words);
}

std::string counted(std::size_t count, std::string_view word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

std::vector<std::pair<const Series*, std::vector<const Difference*>>> by_series(const Comparison& comparison) {
  std::vector<std::pair<const Series*, std::vector<const Difference*>>> all;
  std::unordered_map<std::string, std::size_t> index;
  for (const Difference& difference : comparison.differences) {
    const std::string key = difference.of == nullptr ? std::string() : difference.of->key();
    const auto [found, added] = index.emplace(key, all.size());
    if (added) all.push_back({difference.of, {}});
    all[found->second].second.push_back(&difference);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
  return all;
}

std::string summary(const Comparison& comparison) {
  const std::string symbols = counted(comparison.compared.size(), "element");
  if (comparison.differences.empty()) {
    return fmt::format("no difference: {} of {} agree", counted(comparison.changes, "change"), symbols);
  }
  std::array<std::size_t, kNames.size()> counts{};
  std::size_t differing = 0;
  for (const auto& [series, differences] : by_series(comparison)) differing += series != nullptr ? 1 : 0;
  for (const Difference& difference : comparison.differences) ++counts[static_cast<std::size_t>(difference.kind)];
  std::string text =
      fmt::format("{} in {} of {}:", counted(comparison.differences.size(), "difference"), differing, symbols);
  const char* separator = " ";
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    text += i < 5 ? fmt::format("{}{} {}", separator, counts[i], kNames[i]) : fmt::format("{}{}", separator, kNames[i]);
    separator = ", ";
  }
  return text;
}

}  // namespace symplant::compare
