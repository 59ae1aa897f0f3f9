// SP316 symbols-overlap: two symbols stand on one place of a link.
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kSymbolsOverlapPage =
    R"(Two symbols of different addresses, or of different sizes, stand on the same coil, input or register of their PLC's link. Where
nothing else is said a symbol's number is its address's own, counted in registers: `%QD5` takes holding registers 10 and
11, and meets `%QW10` and `%QW11`. Numbers that the description's `links` give may meet others, too.

**What the model loses.** What the PLC writes for one of them would reach the other.

**How to fix it.** Correct the addresses, or give one of the two another `number` in `links`. `symplant map` shows who stands
where.
)";

}  // namespace

/// Fired by what makes the map of a link (app/map_findings.cpp).
const Rule kSymbolsOverlap{{"SP316", "symbols-overlap", diag::Severity::error,
                            "two symbols stand on one place of a link", kSymbolsOverlapPage}};

}  // namespace symplant::check
