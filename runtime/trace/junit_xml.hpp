// JUnit XML, for build servers.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "symplant/tables/time.hpp"

namespace symplant::trace {

struct TestCase {
  std::string name;
  tables::Time time = 0;   ///< plant time
  std::string failure;     ///< why it failed; empty: it did not
  std::string error = {};  ///< why it has no result; empty: it has one
};

/// One suite of these test cases, which ended at plant time `end`.
std::string junit_xml(std::string_view suite, std::span<const TestCase> cases, tables::Time end);

/// A text escaped for XML attributes and content. Characters that XML does not allow (control characters, bytes that
/// are not UTF-8) become U+FFFD.
std::string xml_text(std::string_view text);

}  // namespace symplant::trace
