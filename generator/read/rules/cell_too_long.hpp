// SP111: a cell so long that it can be no name, address, type or value.
#pragma once

#include <cstddef>

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr std::size_t kLongestCell = 65'536;  ///< bytes of UTF-8

inline constexpr diag::RuleInfo kCellTooLong{
    .id = "SP111",
    .slug = "cell-too-long",
    .severity = diag::Severity::error,
    .summary = "a cell is longer than 65,536 bytes",
    .page =
        R"page(A class, name, address, type or initial value of more than 65,536 bytes is none. It stands in a file whose line ends were
lost, or behind a quote that is closed far below. Comments may be as long as they like.

**What the model loses.** It cannot be built: it is not known which rows are meant. Nothing is written.

**How to mend it.** Export the list again, or put back the line end or quote that is missing.
)page"};

}  // namespace symplant::read
