// SP204 illegal-character: a name holds a character that no level may hold.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kIllegalCharacterPage =
    R"(A symbol's name holds a character that is neither a letter, nor a digit, nor the separator: a blank, a `-`, a `.`, a
bracket. Letters and digits of every script are welcome.

**What the model loses.** The name cannot be cut into levels, so the symbol is in no unit: nothing moves it, and it moves
nothing. It is served all the same, under the name that it has.

**How to fix it.** Take the character away, or write the separator in its place: `EXLINE-MB_AGV_I_P1` becomes
`EXLINE_MB_AGV_I_P1`.
)";

void check_illegal_character(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.reading.fault != name::NameFault::illegal_character) continue;
    diag::Location location = location_of(plant, symbol);
    narrow(location, symbol);
    diagnostics.add(rule.info, about_name(plant, symbol),
                    fmt::format("`{}` holds `{}`, which is neither letter nor digit nor separator: {}; "
                                "take it away or write `_` for it",
                                symbol.name(), faulty_part(symbol), consequence(symbol)),
                    location);
  }
}

}  // namespace

const Rule kIllegalCharacter{{"SP204", "illegal-character", diag::Severity::warning,
                              "a name holds a character that no level may hold", kIllegalCharacterPage, diag::Rank::name},
                             check_illegal_character};

}  // namespace symplant::check
