// Resolves the signals of the description.
#include "elements/signal/resolve.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace symplant::model {
namespace {

void set_row(const description::GivenSignal& given, tables::Time step, tables::SignalRow& row) {
  row.every = given.every.value_or(step);
  row.noise = given.noise;
  const auto limit = given.limit.value_or(std::array{-tables::kInfinity, tables::kInfinity});
  row.low = limit[0];
  row.high = limit[1];
  row.scaled = given.from && given.to;
  if (!row.scaled) return;
  row.a = (*given.from)[0];
  row.b = (*given.from)[1];
  row.c = (*given.to)[0];
  row.d = (*given.to)[1];
}

}  // namespace

void resolve_signals(PlantModel& plant, ConditionReader& conditions, MadeNames& made) {
  std::vector<Signal> signals;
  signals.reserve(plant.signals.size());
  for (Signal& signal : plant.signals) {
    const description::GivenSignal& given = plant.description->signals[signal.given];
    const bool is_pattern = given.symbol.find_first_of("*?") != std::string::npos;
    Symbol& symbol = plant.symbols[signal.row.symbol];
    const description::Pointer entry = description::Pointer("/signals") / std::string_view(given.symbol);
    const description::Pointer here = is_pattern ? entry.matched_by(given.symbol) : entry;
    std::optional<MatchedNames> matched;
    if (is_pattern) matched = MatchedNames::of(symbol, given.symbol);
    std::string lacking;
    const bool sound = conditions.formula(given.of, matched ? &*matched : nullptr, here, signal.formula, &lacking);
    if (is_pattern) made.takes(here);
    if (!lacking.empty()) made.lacks(here, symbol.name(), std::move(lacking));
    if (!sound) {
      symbol.account = Account::numeric;
      continue;
    }
    set_row(given, plant.description->defaults.step, signal.row);
    signals.push_back(std::move(signal));
  }
  plant.signals = std::move(signals);
}

}  // namespace symplant::model
