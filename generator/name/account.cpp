// Accounts of symbols and their sums.
#include "name/account.hpp"

#include <numeric>

namespace symplant::name {

std::string_view account_key(Account account) {
  constexpr std::array<std::string_view, kAccounts> kKeys = {
      "paired",       "numeric",  "ignored",    "constant",       "operator",       "data",     "interlock",
      "parts",        "follow",   "signal",     "plain",          "condition",      "no_rule",  "no_direction",
      "no_operation", "no_event", "task_taken", "unit_too_large", "named_internal", "role_none"};
  return kKeys[static_cast<std::size_t>(account)];
}

std::size_t Counts::sum(Account first, Account end) const {
  const auto begin = by_account_.begin();
  return std::accumulate(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end),
                         std::size_t{0});
}

}  // namespace symplant::name
