// The naming rule, as a value: which levels a name has, what parts them, and the words for a direction.
#pragma once

#include <string>
#include <vector>

namespace symplant::name {

enum class Level { line, process, device, direction, task };

/// Seen from the PLC: it writes operations (its outputs), it reads events (its inputs).
enum class Direction { operation, event };

struct DirectionWord {
  std::string word;  ///< compared without regard to the case of ASCII letters
  Direction direction;
};

struct NamingRule {
  std::string name;
  std::string pattern;        ///< as people write it, for messages
  char32_t separator;         ///< parts two levels
  std::vector<Level> levels;  ///< in their order; levels are of letters and digits, Unicode's too
  std::vector<DirectionWord> directions;
};

/// `LINE_PROC_DEV_I|O_TASK` (Park, Wang and Park, "Symbol naming rules for plant model generation in the PLC
/// simulation").
const NamingRule& built_in_rule();

}  // namespace symplant::name
