// Names that consist of levels, as in LINE_PROC_DEV_I|O_TASK: the fast rules, whose pattern is `exact`.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/tables/tables.hpp"
#include "text/source_file.hpp"

namespace symplant::name {

using tables::Direction;

enum class Level : std::uint8_t { line, process, device, direction, task };
inline constexpr std::size_t kLevels = 5;

/// The direction that a word gives a symbol; nothing: it is internal, neither operation nor event.
using Said = std::optional<Direction>;

/// A word of a direction field or of a class.
struct DirectionWord {
  std::string word;
  Said says;

  bool operator==(const DirectionWord&) const = default;
};

/// The levels of a name in their order. A level holds Unicode letters and digits, at least one.
struct LevelRule {
  std::string pattern;    ///< as shown in messages: `LINE_PROC_DEV_I|O_TASK`
  char separator = '_';   ///< between two levels; ASCII
  bool has_path = false;  ///< it begins with line, process and device, joined by `_`: they are the path of the device
  std::vector<Level> levels;
  std::vector<DirectionWord> directions;  ///< compared without regard to the case of ASCII letters
};

/// Why a name does not have the levels of a rule.
enum class NameFault : std::uint8_t {
  none,
  illegal_character,  ///< something other than letters, digits and the separator
  wrong_number_of_levels,
  empty_level,        ///< two adjacent separators, or one at an end
  direction_unknown,  ///< the direction level is not one of the rule's words
};

/// A name cut into its levels. Views point into the name.
struct LevelReading {
  NameFault fault = NameFault::none;
  std::uint32_t levels = 0;                    ///< their number; 0 if an illegal character was found first
  std::string_view where;                      ///< the part of the name that has the fault
  std::array<std::string_view, kLevels> text;  ///< by Level; empty: the rule has no such level, or there is a fault
  const DirectionWord* direction = nullptr;    ///< null: the rule has no direction level

  std::string_view of(Level level) const { return text[static_cast<std::size_t>(level)]; }
};

/// Cuts a name, which must be UTF-8. O(name), for ASCII names without a fault without allocating. Does not throw.
LevelReading read_levels(const LevelRule& rule, std::string_view name);

}  // namespace symplant::name
