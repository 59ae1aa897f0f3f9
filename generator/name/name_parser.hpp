// Reads symbol names by a naming rule.
#pragma once

#include <memory>
#include <string_view>

#include "name/name_reading.hpp"
#include "name/naming_rule.hpp"

namespace symplant::name {

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
