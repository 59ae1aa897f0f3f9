// Resolves the signals of the description.
#include "elements/signal/resolve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "symplant/condition/type_info.hpp"
#include "text/pattern.hpp"

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

/// An integer must have a whole number within its limits.
void check_limit(const tables::SignalRow& row, tables::DataType type, const description::Pointer& here,
                 description::Faults& faults) {
  const condition::TypeInfo& info = condition::info_of(type);
  if (info.kind == tables::NumberKind::real) return;
  const bool is_signed = info.kind == tables::NumberKind::signed_integer;
  const double least = is_signed ? -std::ldexp(1, info.bits - 1) : 0;
  const double greatest = std::ldexp(1, info.bits - (is_signed ? 1 : 0)) - 1;
  if (std::ceil(std::max(row.low, least)) <= std::floor(std::min(row.high, greatest))) return;
  faults.add(here, fmt::format("no number of {} is within `limit`; write limits from {:.0f} to {:.0f}", info.name,
                               least, greatest));
}

}  // namespace

void resolve_signals(PlantModel& plant, ConditionReader& conditions, MadeNames& made, description::Faults& faults) {
  std::vector<Signal> signals;
  signals.reserve(plant.signals.size());
  for (Signal& signal : plant.signals) {
    const description::GivenSignal& given = plant.description->signals[signal.given];
    const bool is_pattern = text::is_pattern(given.symbol);
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
    check_limit(signal.row, symbol.type, here / "limit", faults);
    signals.push_back(std::move(signal));
  }
  plant.signals = std::move(signals);
}

}  // namespace symplant::model
