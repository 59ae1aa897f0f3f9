// The syntax of patterns of names, as a tree.
#pragma once

#include <boost/spirit/home/x3/support/ast/variant.hpp>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "name/pattern_fault.hpp"

namespace symplant::name::syntax {

namespace x3 = boost::spirit::x3;

using Text = std::string;  ///< characters, without the backslashes that quote
struct Braces {
  std::string_view inside;  ///< of the pattern's text
};
struct Any {};
struct Group;
struct Node : x3::variant<Text, Braces, Any, x3::forward_ast<Group>> {
  using base_type::base_type;
  using base_type::operator=;
};
using Sequence = std::vector<Node>;
struct Group {
  std::vector<Sequence> alternatives;
};

/// `open`: `|` separates alternatives of the whole pattern. At most 1,000 bytes and 16 nested groups.
base::Result<Group, PatternFault> parse(std::string_view pattern, bool open);

}  // namespace symplant::name::syntax
