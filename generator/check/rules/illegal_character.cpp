// SP204 illegal-character: a name has an illegal character.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kIllegalCharacterPage =
    R"(A symbol's name has a character that is neither a letter, nor a digit, nor the separator: a blank, a `-`, a `.`, a bracket.
Letters and digits of every script are allowed.

**What the model loses.** The name cannot be divided into levels, so the symbol is in no unit: no device drives it, and it drives
none. It is still served, under the name that it has.

**How to fix it.** Remove the character, or write the separator instead: `EXLINE-MB_AGV_I_P1` becomes `EXLINE_MB_AGV_I_P1`.
)";

void check_illegal_character(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!breaks_rule(subject, symbol, name::NameFault::illegal_character)) continue;
    diag::Location location = location_of(plant, symbol);
    narrow(location, symbol);
    diag::Diagnostic& finding =
        diagnostics.add(rule.info, about_name(plant, symbol),
                        fmt::format("`{}` has `{}`, which is neither letter nor digit nor separator: {}; "
                                    "remove it or write `_` instead",
                                    symbol.name(), faulty_part(symbol), consequence(symbol)),
                        location);
    std::string renamed(symbol.name());
    renamed.replace(symbol.reading.where.begin, faulty_part(symbol).size(), "_");
    finding.renames.push_back(rename_of(symbol, std::move(renamed), false));
  }
}

}  // namespace

const Rule kIllegalCharacter{{"SP204", "illegal-character", diag::Severity::warning, "a name has an illegal character",
                              kIllegalCharacterPage, diag::Rank::name},
                             check_illegal_character};

}  // namespace symplant::check
