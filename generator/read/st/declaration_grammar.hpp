// The grammar of one declaration of variables in Structured Text.
#pragma once

#include <string_view>
#include <vector>

#include "read/st/tokens.hpp"

namespace symplant::read::st {

/// `a, b AT %IX0.0 : BOOL := TRUE`. Views point into the text; quotes of names are removed.
struct ParsedDeclaration {
  std::vector<std::string_view> names;
  std::string_view address;  ///< after AT, if it begins with `%`
  std::string_view type;     ///< as written, without blanks around it
  std::string_view initial;
};

/// Reads a declaration without its `;`. It must be all of `range`, and `tokens` must have read its tokens before.
/// Afterwards the offset of `tokens` is unspecified. False if the range is not a declaration. Nesting is counted, so no
/// text needs a deep stack. `parsed` is reused from call to call, to save memory. O(range).
bool parse_declaration(Tokens& tokens, text::Span range, ParsedDeclaration& parsed);

}  // namespace symplant::read::st
