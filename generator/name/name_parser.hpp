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
  empty_level,       ///< two adjacent separators, or one at an end
  direction_not_io,  ///< the direction level is not one of the rule's words
  not_linked,        ///< a custom rule is in force, and the symbol is in no unit
};

/// The parts of a name, or its fault. Views point into the name.
struct NameReading {
  NameFault fault = NameFault::none;
  text::Span where;          ///< bytes of the name that the fault is about
  std::uint32_t levels = 0;  ///< the number of levels; 0 if an illegal character was found first
  // Set only without a fault; with `not_linked` also line, process and device, as the custom rule reads them:
  std::string_view device_path;  ///< line, process and device with separators: identifies the device
  std::string_view line;
  std::string_view process;
  std::string_view device;
  std::string_view task;
  Direction direction = Direction::operation;
};

/// A parser for one naming rule. Not thread-safe: it keeps working memory.
class NameParser {
 public:
  explicit NameParser(const NamingRule& rule);
  ~NameParser();
  NameParser(const NameParser&) = delete;
  NameParser& operator=(const NameParser&) = delete;

  /// `name` must be UTF-8. O(name). Does not throw, whatever the name holds.
  NameReading parse(std::string_view name);
  /// The same, always by the grammar, which parse() uses only for unusual names. For tests.
  NameReading parse_by_grammar(std::string_view name);

 private:
  struct Work;
  const NamingRule& rule_;
  std::unique_ptr<Work> work_;
};

}  // namespace symplant::name
