// Declarations of tags in projects of Logix Designer in text form (.L5K).
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace symplant::read {

/// `Description := "..."`, `COMMENT[3].0 := "..."`, `RADIX := Binary`.
struct L5kAttribute {
  std::string_view key;
  std::vector<std::string_view> strings;  ///< a text in its parts, without quotes; empty if the value is no text
  std::size_t end = 0;                    ///< the offset behind the value
};

/// `NAME : TYPE (attributes) := initial;` or `NAME OF TARGET (attributes);`
struct L5kDeclaration {
  bool valid = false;
  std::string_view name;
  std::string_view type;    ///< empty for an alias
  std::string_view target;  ///< empty if it is no alias
  std::vector<L5kAttribute> attributes;
};

/// The offset of the first character, from `at` on, that is neither a blank, a line end nor in a comment `(* *)`.
std::size_t skip_l5k_blanks(std::string_view text, std::size_t at);

/// Parses the declaration that begins at `at`, which must be in the text, and returns the offset behind it. An invalid
/// declaration ends behind the next `;` outside strings and brackets, or before the next line that begins with
/// `END_TAG`. Depth of brackets costs nothing. O(length).
std::size_t parse_l5k_declaration(std::string_view text, std::size_t at, L5kDeclaration& declaration);

}  // namespace symplant::read
