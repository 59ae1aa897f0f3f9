// What a symbol is accounted for as: one enumeration from the reading of its name to the score.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "symplant/tables/tables.hpp"

namespace symplant::name {

/// Why an I/O symbol is in no unit. It is still in the images, on the links and in traces. A later stage only replaces
/// an account by what it finds. Those from `no_rule` on are not accounted for.
enum class Account : std::uint8_t {
  modelled,  ///< it is in a unit; for the score: an operation drives it, or it drives an event
  numeric,   ///< a number: it belongs to its device and makes no state
  ignored,   ///< a pattern of `ignore` matches it
  // Accounted for without a unit:
  constant,        ///< a contact that keeps its value
  operator_panel,  ///< a lamp, a push button
  data,            ///< a bit of a number, or one of several symbols of one text
  interlock,       ///< a permission between two machines, with one text on both sides
  senses_parts,    ///< a sensor of the material flow
  follows,         ///< it follows a condition
  shows_value,     ///< a number that shows a formula
  plain,           ///< plant.json says that it belongs to no device
  condition,       ///< for the score: an operation that drives no event, but parts or an input that follows
  // Left over:
  no_rule,         ///< its name or comment matches no rule
  no_direction,    ///< neither address nor name says a direction
  no_operation,    ///< an event that no operation drives
  no_event,        ///< an operation that drives no event
  task_taken,      ///< another symbol of its unit has its task and direction
  unit_too_large,  ///< its unit has more symbols or states than a unit may have
  named_internal,  ///< its name says that it is neither operation nor event
  role_none,       ///< its rule has the role `none`
};
inline constexpr std::size_t kAccounts = 20;

/// Whether the score counts a BOOL symbol of this account.
constexpr bool is_counted(Account account) { return account != Account::numeric && account != Account::ignored; }
/// Whether the score has no explanation for a symbol of this account.
constexpr bool is_left_over(Account account) { return account >= Account::no_rule; }
/// Whether it was read, and nothing links it.
constexpr bool is_unpaired(Account account) { return account == Account::no_event || account == Account::no_operation; }
constexpr Account unpaired(tables::Direction direction) {
  return direction == tables::Direction::operation ? Account::no_event : Account::no_operation;
}
/// The key in JSON: `no_rule`.
std::string_view account_key(Account account);

/// Symbols by account.
class Counts {
 public:
  void add(Account account) { ++by_account_[static_cast<std::size_t>(account)]; }

  std::size_t of(Account account) const { return by_account_[static_cast<std::size_t>(account)]; }
  std::size_t paired() const { return of(Account::modelled); }
  std::size_t accounted() const { return paired() + sum(Account::constant, Account::no_rule); }
  std::size_t left_over() const { return sum(Account::no_rule, Account{kAccounts}); }  ///< not accounted for
  std::size_t counted() const { return accounted() + left_over(); }
  double paired_share() const { return share(paired()); }
  double accounted_share() const { return share(accounted()); }

 private:
  /// The number of symbols with accounts from `first` up to, but not including, `end`.
  std::size_t sum(Account first, Account end) const;
  double share(std::size_t part) const {
    return counted() == 0 ? 0 : static_cast<double>(part) / static_cast<double>(counted());
  }

  std::array<std::uint32_t, kAccounts> by_account_{};
};

}  // namespace symplant::name
