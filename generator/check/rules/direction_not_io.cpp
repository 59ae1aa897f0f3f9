// SP203 direction-not-io: the direction level is neither I nor O.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kDirectionNotIoPage =
    R"(The level of a symbol's name that tells its direction holds another word than the naming rule knows. Under the built-in
rule it is `I` (the PLC reads it: an event of the plant) or `O` (the PLC writes it: an operation).

**What the model loses.** The symbol is in no unit: nothing moves it, and it moves nothing. It is served all the same, in
the direction of its address.

**How to fix it.** Write `I` or `O` there, as seen from the PLC: `EXLINE_MB_AGV_X_P1` with address X0001 becomes
`EXLINE_MB_AGV_I_P1`.
)";

void check_direction_not_io(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.reading.fault != name::NameFault::direction_not_io) continue;
    diag::Location location = location_of(plant, symbol);
    narrow(location, symbol);
    diagnostics.add(rule.info, about(symbol),
                    fmt::format("`{}` says `{}` where its direction should stand, `{}` wants `I` or `O`: {}; "
                                "write {}",
                                symbol.name(), faulty_part(symbol), plant.rule->pattern, consequence(symbol),
                                symbol.direction == tables::Direction::event
                                    ? fmt::format("`I`, as its address `{}` says", symbol.address_cell)
                                    : fmt::format("`O`, as its address `{}` says", symbol.address_cell)),
                    location);
  }
}

}  // namespace

const Rule kDirectionNotIo{{"SP203", "direction-not-io", diag::Severity::warning,
                            "the direction level is neither I nor O", kDirectionNotIoPage},
                           check_direction_not_io};

}  // namespace symplant::check
