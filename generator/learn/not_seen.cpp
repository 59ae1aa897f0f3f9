// What recordings do not show.
#include "learn/not_seen.hpp"

#include <algorithm>

namespace symplant::learn {
namespace {

/// Whether a series has more than the value at the beginning.
bool changes(const recording::Recording& recording, const recording::Series& series) {
  if (recording.of_plant) return !series.changes.empty() && series.changes.back().time > 0;
  return std::any_of(series.changes.begin(), series.changes.end(), [&](const recording::Series::Change& change) {
    return change.value != series.changes.front().value;
  });
}

/// What all recordings together show of each symbol.
struct SeenSymbols {
  std::vector<bool> recorded;
  std::vector<bool> changed;
};

SeenSymbols seen_symbols(const model::PlantModel& plant, const std::vector<Input>& inputs) {
  SeenSymbols seen{std::vector<bool>(plant.symbols.size()), std::vector<bool>(plant.symbols.size())};
  for (const Input& input : inputs) {
    for (std::size_t s = 0; s < plant.symbols.size(); ++s) {
      if (input.matched.recorded[s]) seen.recorded[s] = true;
    }
    for (std::size_t i = 0; i < input.matched.symbols.size(); ++i) {
      const std::uint32_t symbol = input.matched.symbols[i];
      if (symbol != kNone && changes(input.recording, input.recording.series[i])) seen.changed[symbol] = true;
    }
  }
  return seen;
}

/// Whether its moves would show. A lamp has no events.
bool is_visible(const model::Unit& unit, const SeenSymbols& seen) {
  return std::any_of(unit.events.begin(), unit.events.end(),
                     [&](std::uint32_t symbol) { return seen.recorded[symbol]; });
}

}  // namespace

NotSeen not_seen(const model::PlantModel& plant, const std::vector<Input>& inputs, const Moves& moves) {
  NotSeen result;
  const SeenSymbols seen = seen_symbols(plant, inputs);
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    const model::Unit& unit = plant.units[u];
    if (!unit.moves() || !is_visible(unit, seen)) continue;
    if (!moves.moved[u]) {
      result.devices.push_back(u);
      continue;
    }
    for (std::uint32_t t = 0; t < unit.transitions.size(); ++t) {
      if (moves.taken[u].empty() || !moves.taken[u][t]) result.transitions.emplace_back(u, t);
    }
  }
  for (std::uint32_t s = 0; s < plant.symbols.size(); ++s) {
    if (!seen.recorded[s]) {
      result.symbols.push_back(s);
    } else if (!seen.changed[s] && plant.symbols[s].direction == tables::Direction::event) {
      result.events.push_back(s);
    }
  }
  for (std::uint32_t i = 0; i < inputs.size(); ++i) {
    for (const auto& unknown : inputs[i].matched.unknown) result.names.push_back({unknown.name, unknown.nearest, i});
  }
  return result;
}

}  // namespace symplant::learn
