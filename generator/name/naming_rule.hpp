// The naming rule as a value: the levels of a name, their separator, and the words for a direction.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace symplant::name {

enum class Level : std::uint8_t { line, process, device, direction, task };

/// As the PLC sees it: it writes operations (its outputs) and reads events (its inputs).
enum class Direction : std::uint8_t { operation, event };

struct DirectionWord {
  std::string word;  ///< compared without regard to the case of ASCII letters
  Direction direction;
};

struct NamingRule {
  std::string name;
  std::string pattern;        ///< as shown in messages
  char32_t separator;         ///< between two levels
  std::vector<Level> levels;  ///< in their order; a level holds Unicode letters and digits
  std::vector<DirectionWord> directions;
};

/// `LINE_PROC_DEV_I|O_TASK` (Park, Wang and Park, "Symbol naming rules for plant model generation in the PLC
/// simulation").
const NamingRule& built_in_rule();

}  // namespace symplant::name
