// SP316 symbols-overlap: two symbols have one coil, input or register of a link.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kSymbolsOverlapPage =
    R"(Two symbols of different addresses, or of different sizes, have the same coil, input or register of their PLC's link. By default
a symbol's number is that of its address, counted in registers: `%QD5` has holding registers 10 and 11, and meets `%QW10` and
`%QW11`. Numbers from the description's `links` can meet others, too.

**What the model loses.** What the PLC writes for one of them would reach the other.

**How to fix it.** Correct the addresses, or give one of the two another `number` in `links`. `symplant map` shows the index of
each symbol.
)";

}  // namespace

/// Fired by what makes the map of a link (app/map_findings.cpp).
const Rule kSymbolsOverlap{{"SP316", "symbols-overlap", diag::Severity::error,
                            "two symbols have one coil, input or register of a link", kSymbolsOverlapPage}};

}  // namespace symplant::check
