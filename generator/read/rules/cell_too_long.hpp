// SP111: a cell is too long to be a name, address, type or value.
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
        R"page(A class, name, address, type or initial value is never longer than 65,536 bytes. The line ends of the file
were lost, or a quote before it is closed far below. The length of comments is not limited.

**What the model loses.** It cannot be built: it is not known which rows are meant. Nothing is written.

**How to fix it.** Export the list again, or restore the missing line end or quote.
)page"};

}  // namespace symplant::read
