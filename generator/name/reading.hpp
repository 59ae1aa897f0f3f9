// What a naming rule says about one symbol.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "name/account.hpp"
#include "name/naming.hpp"

namespace symplant::name {

inline constexpr std::uint32_t kNoPair = UINT32_MAX;

/// A task in canonical words: without affixes and sensor index, with synonyms replaced.
struct TaskReading {
  std::string_view text;       ///< as the symbol has it, words separated by one blank
  std::string_view canonical;  ///< the state that it names: words separated by one blank
  std::string_view index;      ///< digits that number the sensor; empty: none
  /// Equal for tasks that exclude each other: the canonical words, in which the word of a pair is the pair's first one.
  std::string_view group;
  std::string_view numbered_group;  ///< `group` with the index of the sensor; equal to `group` without one
  std::uint32_t pair = kNoPair;     ///< the pair of the vocabulary that has its motion word
  bool rest = false;                ///< its motion word is the pair's rest position
};

/// The levels that name a device.
struct DeviceLevels {
  std::string_view path;  ///< the levels that are not empty, separated by `_`; empty under rules without levels
  std::string_view line;
  std::string_view process;
  std::string_view device;       ///< words separated by `_`; empty under rules without a device
  std::uint32_t device_id = 0;   ///< equal for equal levels after case folding; below SymbolReader::devices()
  std::uint32_t process_id = 0;  ///< equal for equal line and process after case folding
};

/// There is one for each row, so it points to what rows share. Pointers and views refer to the SymbolReader, or to the
/// symbol's name, and live as long as both.
struct Reading {
  const DeviceLevels* levels = nullptr;  ///< null: no rule matches
  const TaskReading* task = nullptr;     ///< set with `levels`
  std::string_view klass;                ///< the field `class`
  Account account = Account::no_rule;    ///< `modelled` (read), `no_rule`, `ignored`, `no_direction`, `named_internal`
  Role role = Role::io;
  Role rest = Role::io;         ///< the role if nothing links the symbol; `io`: no rule of Naming::rest matches
  bool given_io = false;        ///< IoRows says that the row is I/O: its internal address does not count
  Direction given_direction{};  ///< set with `given_io`
  bool rest_value = false;      ///< of the role `constant` in `rest`
  std::uint16_t rule = 0;       ///< index in Naming::rules; valid if a rule matched
  Evidence direction_by = Evidence::address;   ///< what decided the direction
  std::optional<Direction> direction;          ///< as the evidence decides; set if read
  std::optional<Direction> direction_of_name;  ///< as field, class or prefix say, if one does

  bool is_read() const { return account == Account::modelled; }
};

/// The account of a symbol that is not read. A number that no rule matches is `numeric`.
constexpr Account account_of(const Reading& reading, bool boolean) {
  return reading.account == Account::no_rule && !boolean ? Account::numeric : reading.account;
}

/// The texts of a symbol, as UTF-8.
struct SymbolText {
  std::string_view name;
  std::string_view comment;
  std::string_view parent_comment;
  std::optional<Direction> address;  ///< the direction of its address; empty without an address
  std::string_view prefix = {};      ///< put before the line of its device
};

}  // namespace symplant::name
