// Gives each symbol its verdict.
#include "score/score.hpp"

#include <numeric>
#include <optional>

#include "base/large_memory.hpp"
#include "model/part_words.hpp"
#include "score/described_operations.hpp"
#include "score/paired_by_task.hpp"

namespace symplant::score {
namespace {

using model::Symbol;
using model::Unmodelled;

Verdict verdict_of_unpaired(const Symbol& symbol) {
  return symbol.direction == tables::Direction::operation ? Verdict::no_event : Verdict::no_operation;
}

/// Of a symbol that a custom naming rule accounts for as `account`.
Verdict verdict_of(pairing::Account account, const Symbol& symbol) {
  switch (account) {
    case pairing::Account::paired:
      return symbol.unmodelled == Unmodelled::modelled ? Verdict::paired : Verdict::unit_too_large;
    case pairing::Account::constant:
      return Verdict::constant;
    case pairing::Account::operator_panel:
      return Verdict::operator_panel;
    case pairing::Account::data:
      return Verdict::data;
    case pairing::Account::none:
      return Verdict::role_none;
    case pairing::Account::unpaired:
      return verdict_of_unpaired(symbol);
    case pairing::Account::ignored:
      return Verdict::not_counted;
    case pairing::Account::no_rule:
      return Verdict::no_rule;
    case pairing::Account::no_direction:
      return Verdict::no_direction;
    case pairing::Account::internal:
      return Verdict::named_internal;
  }
  return Verdict::no_rule;
}

/// Of a symbol that the description drives; nothing for all others.
std::optional<Verdict> verdict_by_description(const Symbol& symbol) {
  if (symbol.unmodelled == Unmodelled::senses_parts) return Verdict::parts;
  if (symbol.unmodelled == Unmodelled::follows) return Verdict::follow;
  return std::nullopt;
}

/// Whether it is a contact with an initial value that nothing changes. On a shared address the leading symbol decides.
bool keeps_its_value(const model::PlantModel& plant, const Symbol& symbol) {
  const Symbol& leading = symbol.leader == model::kNone ? symbol : plant.symbols[symbol.leader];
  return leading.direction == tables::Direction::event && leading.initial != 0 && !model::is_driven(plant, leading);
}

/// Under the built-in rule.
Verdict verdict_by_task(const model::PlantModel& plant, std::uint32_t index, bool paired) {
  const Symbol& symbol = plant.symbols[index];
  switch (symbol.unmodelled) {
    case Unmodelled::modelled:
      return paired                           ? Verdict::paired
             : keeps_its_value(plant, symbol) ? Verdict::constant
                                              : verdict_of_unpaired(symbol);
    case Unmodelled::task_taken:
      return Verdict::task_taken;
    case Unmodelled::unit_too_large:
      return Verdict::unit_too_large;
    default:
      return Verdict::no_rule;
  }
}

/// `paired`: by paired_by_task(), empty under a custom naming rule. `described`: by described_operations().
Verdict verdict_of_symbol(const model::PlantModel& plant, std::uint32_t index, const std::vector<bool>& paired,
                          const std::vector<bool>& described) {
  const Symbol& symbol = plant.symbols[index];
  if (symbol.type != tables::DataType::boolean) return Verdict::not_counted;
  if (const auto driven = verdict_by_description(symbol)) return *driven;
  const Verdict verdict = plant.pairing != nullptr ? verdict_of(plant.pairing->accounts[index], symbol)
                                                   : verdict_by_task(plant, index, paired[index]);
  return is_left_over(verdict) && described[index] ? Verdict::condition : verdict;
}

}  // namespace

std::string_view verdict_key(Verdict verdict) {
  constexpr std::array<std::string_view, kVerdicts> kKeys = {
      "not_counted", "paired",         "constant",       "operator",     "data",         "parts",
      "follow",      "condition",      "no_rule",        "no_direction", "no_operation", "no_event",
      "task_taken",  "unit_too_large", "named_internal", "role_none"};
  return kKeys[static_cast<std::size_t>(verdict)];
}

std::size_t Counts::sum(Verdict first, std::size_t end) const {
  const auto begin = by_verdict_.begin();
  return std::accumulate(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end),
                         std::size_t{0});
}

Score score_of(const model::PlantModel& plant) {
  Score score;
  base::reserve_large(score.verdicts, plant.symbols.size());
  const std::vector<bool> paired = plant.pairing == nullptr ? paired_by_task(plant) : std::vector<bool>();
  const std::vector<bool> described = described_operations(plant);
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const Symbol& symbol = plant.symbols[i];
    const Verdict verdict = verdict_of_symbol(plant, i, paired, described);
    if (symbol.reading.fault == name::NameFault::none) ++score.named;
    score.total.add(verdict);
    score.verdicts.push_back(verdict);
  }
  return score;
}

}  // namespace symplant::score
