// What a trainee may operate.
#include "symplant/panel/operate/allowed.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "symplant/panel/picture/drivers.hpp"
#include "symplant/panel/picture/json_text.hpp"
#include "symplant/tables/pattern.hpp"

namespace symplant::panel {
namespace {

void put_marked(std::string& json, std::string_view key, const std::vector<bool>& marked) {
  std::vector<std::uint32_t> indexes;
  for (std::uint32_t i = 0; i < marked.size(); ++i) {
    if (marked[i]) indexes.push_back(i);
  }
  put_indexes(json, key, indexes);
}

}  // namespace

Allowed::Allowed(const trace::PlantNames& names, const View& view)
    : names_(names),
      view_(view),
      symbols_(names.tables().symbols.size()),
      switched_on_(symbols_.size()),
      units_(names.tables().units.size()),
      outputs_(names.tables().values.outputs),
      locations_(names.tables().material.locations()) {
  by_default();
}

bool Allowed::has_operations(std::uint32_t unit) const {
  const auto symbols = names_.symbols_of(unit);
  return std::any_of(symbols.begin(), symbols.end(), [&](std::uint32_t symbol) { return names_.is_operation(symbol); });
}

void Allowed::by_patterns(std::span<const std::string> patterns) {
  const auto mark = [&](std::vector<bool>& marked, auto name_of) {
    for (std::uint32_t i = 0; i < marked.size(); ++i) {
      marked[i] = std::any_of(patterns.begin(), patterns.end(),
                              [&](const std::string& pattern) { return tables::matches_pattern(name_of(i), pattern); });
    }
  };
  mark(symbols_, [&](std::uint32_t symbol) { return names_.symbol(symbol); });
  mark(units_, [&](std::uint32_t unit) { return names_.unit(unit); });
  for (std::uint32_t unit = 0; unit < units_.size(); ++unit) {
    if (!units_[unit] || !has_operations(unit)) continue;
    units_[unit] = false;
    for (const std::uint32_t symbol : names_.symbols_of(unit)) {
      if (names_.is_operation(symbol)) symbols_[symbol] = true;
    }
  }
  mark(outputs_, [&](std::uint32_t output) { return names_.output(output); });
  mark(locations_, [&](std::uint32_t location) { return names_.location(location); });
  is_by_patterns_ = true;
  ++version_;
}

void Allowed::by_default() {
  const std::vector<std::string_view> drivers = drivers_of(names_.tables());
  for (std::uint32_t symbol = 0; symbol < symbols_.size(); ++symbol) {
    const bool is_event = !names_.is_operation(symbol);
    const bool by_operator = !view_.symbols.empty() && view_.symbols[symbol].by_operator;
    symbols_[symbol] = is_event && (drivers[symbol] == "none" || by_operator);
  }
  for (std::uint32_t unit = 0; unit < units_.size(); ++unit) {
    const auto symbols = names_.symbols_of(unit);
    units_[unit] =
        std::none_of(symbols.begin(), symbols.end(), [&](std::uint32_t symbol) { return names_.is_operation(symbol); });
  }
  outputs_.assign(outputs_.size(), false);
  locations_.assign(locations_.size(), false);
  is_by_patterns_ = false;
  ++version_;
}

std::string Allowed::not_allowed(std::string_view name) const {
  return fmt::format("a trainee may not operate `{}`; {}", name,
                     is_by_patterns_
                         ? "the exercise allows what `allow` names"
                         : "without `allow` of an exercise, a trainee operates buttons, doors and selectors");
}

bool Allowed::switches_off(const scenario::SymbolValue& set) const {
  const tables::SymbolRow& row = names_.tables().symbols[set.symbol];
  return row.type() == tables::DataType::boolean && (set.value != 0) == row.inverted();
}

void Allowed::note(const scenario::Step& step) {
  for (const scenario::SymbolValue& set : step.set) switched_on_[set.symbol] = !switches_off(set);
}

std::string Allowed::step_refusal(const scenario::Step& step) const {
  if (!step.restart.empty() || !step.force.empty() || !step.release.empty() || !step.stop.empty() ||
      !step.start.empty()) {
    return kOnlyTrainer;
  }
  for (const scenario::SymbolValue& set : step.set) {
    const bool is_end_of_press = switched_on_[set.symbol] && switches_off(set);
    if (!symbols_[set.symbol] && !is_end_of_press) return not_allowed(names_.symbol(set.symbol));
  }
  for (const scenario::ValueSetting& set : step.set_values) {
    if (!outputs_[names_.tables().values.rows[set.value].output]) {
      return not_allowed(names_.value(set.value));
    }
  }
  for (const scenario::UnitState& set : step.states) {
    if (!units_[set.unit]) return not_allowed(names_.unit(set.unit));
  }
  for (const scenario::NewPart& part : step.put) {
    if (!locations_[part.at.location]) return not_allowed(names_.location(part.at.location));
  }
  for (const tables::PartLocation& at : step.take) {
    if (!locations_[at.location]) return not_allowed(names_.location(at.location));
  }
  return {};
}

std::string Allowed::refusal(const Act& act) const {
  switch (act.kind) {
    case Act::Kind::step:
      return act.releases_all ? kOnlyTrainer : step_refusal(act.step);
    case Act::Kind::join:
    case Act::Kind::acknowledge:
    case Act::Kind::shelve:
    case Act::Kind::unshelve:
    case Act::Kind::silence:
      return {};
    default:
      return kOnlyTrainer;
  }
}

void Allowed::put(std::string& json) const {
  json += '{';
  put_marked(json, "symbols", symbols_);
  put_marked(json, "devices", units_);
  put_marked(json, "values", outputs_);
  put_marked(json, "locations", locations_);
  json += '}';
}

}  // namespace symplant::panel
