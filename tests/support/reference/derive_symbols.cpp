// What the description defines for single symbols: inverted ones, and ones that follow a condition.
#include <algorithm>

#include "support/reference/material.hpp"
#include "support/reference/patterns.hpp"
#include "support/reference/rules.hpp"

namespace symplant::reference {
namespace {

/// The entry of `follow` for a symbol: its name, else the pattern with the most literal characters; kNone without one.
std::uint32_t entry_of(const std::vector<description::GivenFollow>& entries, std::string_view symbol) {
  std::uint32_t best = kNone;
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    const std::string& name = entries[i].symbol;
    if (!is_pattern(name) && same_name(name, symbol)) return i;
    if (!is_pattern(name) || !fits(std::string(symbol), name)) continue;
    if (best == kNone || literals(name) > literals(entries[best].symbol)) best = i;
  }
  return best;
}

}  // namespace

void derive_symbols(Rules& rules) {
  const model::PlantModel& model = *rules.model;
  const description::Description& description = *model.description;
  for (std::uint32_t i = 0; i < model.symbols.size(); ++i) {
    const std::string_view name = model.symbols[i].name();
    const auto named = [&](const std::string& given) { return fits(std::string(name), given); };
    const auto& inverted = description.inverted;
    // A sensor can be inverted where it is described; the model has resolved its name.
    const bool inverted_sensor = senses_parts(model, i) && model.symbols[i].inverted;
    rules.inverted.push_back(rules.is_bool(i) &&
                             (inverted_sensor || std::any_of(inverted.begin(), inverted.end(), named)));
    if (rules.is_operation(i) || !rules.is_bool(i)) continue;
    const std::uint32_t given = entry_of(description.follow, name);
    if (given == kNone) continue;
    FollowRules follow{i, given, nullptr, nullptr};
    for (const model::Follow& resolved : model.follows) {
      if (resolved.symbol != i) continue;
      follow.condition = &resolved.condition;
      if (resolved.off) follow.off = &*resolved.off;
    }
    if ((follow.off != nullptr) == description.follow[given].off.empty()) {
      rules.fault = std::string(name) + " is a switch with hysteresis only in the model or only in the description";
    }
    if (follow.condition == nullptr) rules.fault = std::string(name) + " follows nothing in the model";
    rules.follows.push_back(follow);
  }
}

}  // namespace symplant::reference
