// Losses that several formats have.
#pragma once

#include <string_view>

#include "convert/report.hpp"
#include "convert/symbols.hpp"

namespace symplant::convert {

inline constexpr Loss kNoEquivalentAddress{"address is not written", "addresses are not written",
                                           "the target has no such address"};
inline constexpr Loss kUnknownType{"symbol is left out", "symbols are left out",
                                   "the target has no such type, or there is no type"};
inline constexpr Loss kUnknownInitial{"initial value is not written", "initial values are not written",
                                      "it is not a value of the type"};
inline constexpr Loss kNoScope{"scope is not written", "scopes are not written", "in the target all names are global"};
inline constexpr Loss kCommentChanged{"comment is changed", "comments are changed",
                                      "the target cannot hold some of its characters"};

inline constexpr Loss kBitOfWord{"bit of a word is addressed as a bit of a byte",
                                 "bits of words are addressed as bits of bytes", "`%IW5.12` is `%IX11.4`"};

/// The tag table that every project of TIA Portal has.
inline constexpr std::string_view kDefaultTagTable = "Default tag table";

/// Reports the scope of a symbol that has one other than the default tag table.
void report_scope(const Symbol& symbol, Report& report);

}  // namespace symplant::convert
