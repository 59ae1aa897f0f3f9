// Groups symbols by the facets that a custom naming rule makes of them.
#pragma once

#include <cstddef>
#include <vector>

#include "model/derived.hpp"
#include "name/rule_reading.hpp"

namespace symplant::model {

/// Makes the units of a plant and says why the other symbols are in none. `readings` are those of the symbols.
/// Constants get their value as initial value. O(symbols).
void pair_units(Derived& derived, const std::vector<const name::RuleReading*>& readings);

/// How many BOOL I/O symbols a custom naming rule accounts for. Ignored ones do not count.
struct NamingScore {
  std::size_t symbols = 0;
  std::size_t paired = 0;
  std::size_t constant = 0;
  std::size_t operator_panel = 0;
  std::size_t data = 0;

  std::size_t accounted() const { return paired + constant + operator_panel + data; }
};
/// O(symbols). The plant must have a custom naming rule.
NamingScore naming_score(const PlantModel& plant);

}  // namespace symplant::model
