// What a naming rule says about one symbol.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

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
  std::uint32_t pair = kNoPair;     ///< the pair of the vocabulary that its motion word is of
  bool rest = false;                ///< its motion word is the pair's rest position
};

enum class Outcome : std::uint8_t {
  read,
  no_rule,       ///< no rule matches
  ignored,       ///< a pattern of `ignore` matches
  no_direction,  ///< neither address nor name says a side
  internal,      ///< the name says that it is neither operation nor event
};

/// Views point into the SymbolReader, and live as long as it.
struct RuleReading {
  Outcome outcome = Outcome::no_rule;
  Role role = Role::io;
  Role rest = Role::io;      ///< the role if nothing links the symbol; `io`: no rule of Naming::rest matches
  bool rest_value = false;   ///< of the role `constant` in `rest`
  std::uint16_t rule = 0;    ///< index in Naming::rules; valid if a rule matched
  std::optional<Side> side;  ///< as the evidence decides; set if `read`
  Evidence side_by = Evidence::address;  ///< what decided it
  std::optional<Side> side_of_name;      ///< as field, class or prefix say, if one does
  std::string_view line;
  std::string_view process;
  std::string_view device;       ///< words separated by `_`; empty under rules without a device
  std::string_view path;         ///< the levels that are not empty, separated by `_`
  std::uint32_t device_id = 0;   ///< equal for equal levels after case folding
  std::uint32_t process_id = 0;  ///< equal for equal line and process after case folding
  std::string_view klass;        ///< the field `class`
  TaskReading task;
};

/// The texts of a symbol, as UTF-8.
struct SymbolText {
  std::string_view name;
  std::string_view comment;
  std::string_view parent_comment;
  std::optional<Side> address;  ///< the side of its address; empty without an address
};

}  // namespace symplant::name
