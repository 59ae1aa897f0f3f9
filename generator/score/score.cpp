// Gives each symbol its account.
#include "score/score.hpp"

#include "base/large_memory.hpp"
#include "elements/material/part_words.hpp"
#include "score/described_operations.hpp"
#include "score/paired_by_task.hpp"

namespace symplant::score {
namespace {

using model::Account;
using model::Symbol;

/// Whether it is a contact with an initial value that nothing changes. On a shared address the leading symbol decides.
bool keeps_its_value(const model::PlantModel& plant, const Symbol& symbol) {
  const Symbol& leading = symbol.leader == model::kNone ? symbol : plant.symbols[symbol.leader];
  return leading.direction == tables::Direction::event && leading.initial != 0 && !model::is_driven(plant, leading);
}

/// `paired`: by paired_by_task(); empty if the pairing of facets says it. `described`: by described_operations().
Account account_of(const model::PlantModel& plant, std::uint32_t index, const std::vector<bool>& paired,
                   const std::vector<bool>& described) {
  const Symbol& symbol = plant.symbols[index];
  if (symbol.type != tables::DataType::boolean) return Account::numeric;
  Account account = symbol.account;
  if (account == Account::modelled && !plant.is_linked(index)) account = name::unpaired(symbol.direction);
  if (account == Account::modelled && !paired.empty() && !paired[index]) {
    account = keeps_its_value(plant, symbol) ? Account::constant : name::unpaired(symbol.direction);
  }
  return name::is_left_over(account) && described[index] ? Account::condition : account;
}

}  // namespace

PlantScore score_of(const model::PlantModel& plant) {
  PlantScore score;
  base::reserve_large(score.accounts, plant.symbols.size());
  const std::vector<bool> paired = plant.pairing == nullptr ? paired_by_task(plant) : std::vector<bool>();
  const std::vector<bool> described = described_operations(plant);
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const Account account = account_of(plant, i, paired, described);
    if (plant.symbols[i].reading.is_named()) ++score.named;
    if (name::is_counted(account)) score.total.add(account);
    score.accounts.push_back(account);
  }
  return score;
}

}  // namespace symplant::score
