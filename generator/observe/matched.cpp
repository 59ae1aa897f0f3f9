// Which symbols of a plant a recording has.
#include "observe/matched.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "observe/addresses.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::observe {

using model::kNone;
using recording::Recording;
using recording::Series;

namespace {

constexpr std::size_t kMostSuggested = 20;

void suggest(const model::PlantModel& plant, Matched& matched) {
  for (std::size_t i = 0; i < std::min(kMostSuggested, matched.unknown.size()); ++i) {
    tables::NearestName nearest(matched.unknown[i].name);
    for (std::uint32_t s = 0; s < plant.symbols.size(); ++s) {
      if (!matched.recorded[s]) nearest.offer(plant.symbols[s].name());
    }
    matched.unknown[i].nearest = nearest.name();
  }
}

}  // namespace

bool Matched::has_symbols() const {
  return std::any_of(symbols.begin(), symbols.end(), [](std::uint32_t symbol) { return symbol != kNone; });
}

std::string words_of(const Matched::Unknown& unknown) {
  std::string words = "`" + unknown.name + "`";
  if (!unknown.nearest.empty()) words += " (did you mean `" + unknown.nearest + "`?)";
  return words;
}

Matched match(const model::PlantModel& plant, const Recording& recording) {
  Matched matched;
  matched.recorded.resize(plant.symbols.size(), recording.of_plant);
  std::unordered_map<std::string_view, std::uint32_t> names;
  for (std::uint32_t s = 0; s < plant.symbols.size(); ++s) names.emplace(plant.symbols[s].name(), s);
  std::vector<bool> taken(plant.symbols.size());
  for (const Series& series : recording.series) {
    const auto found = series.kind == Series::Kind::parts ? names.end() : names.find(series.name);
    matched.symbols.push_back(found == names.end() ? kNone : found->second);
    if (found != names.end()) taken[found->second] = matched.recorded[found->second] = true;
  }
  std::optional<Addresses> addresses;
  for (std::size_t s = 0; s < recording.series.size(); ++s) {
    const Series& series = recording.series[s];
    if (matched.symbols[s] != kNone || series.kind == Series::Kind::parts) continue;
    if (!addresses) addresses.emplace(plant);
    const std::uint32_t symbol = addresses->symbol_at(series.name);
    if (symbol == kNone || taken[symbol]) {
      matched.unknown.push_back({series.name, {}});
      continue;
    }
    matched.symbols[s] = symbol;
    taken[symbol] = matched.recorded[symbol] = true;
  }
  suggest(plant, matched);
  return matched;
}

Matched adopt(const model::PlantModel& plant, Recording& recording) {
  Matched matched = match(plant, recording);
  for (std::size_t s = 0; s < recording.series.size(); ++s) {
    if (matched.symbols[s] == kNone) continue;
    Series& series = recording.series[s];
    const model::Symbol& symbol = plant.symbols[matched.symbols[s]];
    if (series.name != symbol.name()) {
      recording.index.erase(series.key());
      series.name = symbol.name();
      recording.index.emplace(series.key(), s);
    }
    series.is_operation = symbol.direction == tables::Direction::operation;
    const bool is_bit = symbol.type == tables::DataType::boolean;
    series.kind = is_bit ? Series::Kind::boolean : Series::Kind::number;
    series.may_be_number = false;
    if (!is_bit) continue;
    for (Series::Change& change : series.changes) change.value = change.value != 0 ? 1 : 0;
  }
  recording::order_operations(recording);
  return matched;
}

}  // namespace symplant::observe
