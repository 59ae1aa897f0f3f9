// The formulas of times.
#include "model/time_formulas.hpp"

#include <utility>

namespace symplant::model {

bool TimeFormulas::resolve(const Unit& unit, std::string_view pattern, const description::Pointer& here,
                           description::Duration& time) {
  if (time.kind != description::Duration::Kind::seconds) return true;
  const std::string text = *time.formula;
  const MatchedNames matched = MatchedNames::of(plant_, unit, pattern);
  condition::Formula formula;
  std::string lacking;
  const bool is_made = text::has_braces(text);
  const bool sound = conditions_.formula(text, &matched, here, formula, is_made ? &lacking : nullptr);
  if (is_made) made_.takes(here);
  if (!lacking.empty()) made_.lacks(here, unit.path, std::move(lacking), text);
  if (!sound) return false;
  const auto index = static_cast<tables::Time>(plant_.time_formulas.size());
  const auto [known, added] = indexes_.try_emplace(formula.text, index);
  time = description::Duration::seconds(formula.text);
  time.a = known->second;
  if (added) plant_.time_formulas.push_back(std::move(formula));
  return true;
}

}  // namespace symplant::model
