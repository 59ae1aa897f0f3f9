// Reads symbol names by a naming rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "name/naming_rule.hpp"
#include "text/source_file.hpp"

namespace symplant::name {

/// Why a name does not follow the rule.
enum class NameFault : std::uint8_t {
  none,
  illegal_character,  ///< something other than letters, digits and the separator
  wrong_number_of_levels,
  empty_level,       ///< two separators side by side, or one at an end
  direction_not_io,  ///< the direction level is none of the rule's words
};

/// What a name says, or where it goes wrong. Views point into the name.
struct NameReading {
  NameFault fault = NameFault::none;
  text::Span where;          ///< bytes of the name that the fault is about
  std::uint32_t levels = 0;  ///< how many it has; 0 where an illegal character came first
  // Only without a fault:
  std::string_view device_path;  ///< line, process and device with what parts them: the device's identity
  std::string_view line;
  std::string_view process;
  std::string_view device;
  std::string_view task;
  Direction direction = Direction::operation;
};

/// One rule made ready. Not thread-safe: it keeps its working space.
class NameParser {
 public:
  explicit NameParser(const NamingRule& rule);
  ~NameParser();
  NameParser(const NameParser&) = delete;
  NameParser& operator=(const NameParser&) = delete;

  /// `name` must be UTF-8. O(name). Never throws for what a name holds.
  NameReading parse(std::string_view name);
  /// The same by the grammar alone, which parse() leaves to names that are out of the ordinary. For tests.
  NameReading parse_by_grammar(std::string_view name);

 private:
  struct Work;
  const NamingRule& rule_;
  std::unique_ptr<Work> work_;
};

}  // namespace symplant::name
