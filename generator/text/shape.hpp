// The shape of a text: what names that differ only in digits have in common.
#pragma once

#include <string>
#include <string_view>

namespace symplant::text {

/// `#` for each run of digits, one blank for each run of blanks: `S201_I_RB1_HOME` and `S35_I_RB12_HOME` have the shape
/// `S#_I_RB#_HOME`. `1ST`, `2ND`, `3RD` and `4TH` are `#TH`. O(length).
std::string shape_of(std::string_view text);

}  // namespace symplant::text
