// SP119: an array of inputs or outputs has more elements than are read.
#pragma once

#include <cstdint>

#include "diag/diagnostic.hpp"

namespace symplant::read {

inline constexpr std::uint64_t kMostElements = 4'096;         ///< of an array
inline constexpr std::uint64_t kMostElementsOfList = 65'536;  ///< of all arrays of a list

inline constexpr diag::RuleInfo kArrayTooLarge{
    .id = "SP119",
    .slug = "array-too-large",
    .severity = diag::Severity::warning,
    .summary = "an array of inputs or outputs has more elements than are read",
    .page =
        R"page(Each element of an array with the address of an input or output becomes a symbol: `GATES`, `ARRAY [0..7] OF BOOL` on
`%QX0.0`, is `GATES[0]` to `GATES[7]`. An array may have 4,096 elements, and all arrays of a list together 65,536.

**What the model loses.** The elements after these: they are in no image and on no link.

**How to fix it.** Declare the part of the array that is wired as symbols of elementary types, or as a smaller array.
)page"};

}  // namespace symplant::read
