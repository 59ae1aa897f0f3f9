// Small text helpers that Catch2's versions spell differently.
#pragma once

#include <string_view>

namespace symplant::test {

inline bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

}  // namespace symplant::test
