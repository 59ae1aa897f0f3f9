// SP207 role-taken: several symbols fit one role of an archetype.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kRoleTakenPage =
    R"(An archetype of naming.json has one symbol for each role. In a device several symbols match the text of one role.

**What the model loses.** The first symbol in the list has the role. The others are left to later archetypes and to pairing by
words, and drive nothing if nothing else fits them.

**How to fix it.** Make the text of the role more specific, or add `{x}` to all roles, so that each of the symbols belongs to
a model of its kind.
)";

void check_role_taken(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.pairing == nullptr) return;
  for (const pairing::Remark& remark : plant.pairing->remarks) {
    if (remark.kind != pairing::Remark::Kind::role_taken) continue;
    const model::Symbol& symbol = plant.symbols[remark.input];
    const model::Symbol& first = plant.symbols[remark.other];
    diagnostics.add(rule.info, about(symbol),
                    fmt::format("`{}` fits the same role of an archetype as `{}`, which comes first; make the text of "
                                "the role more specific",
                                symbol.name(), first.name()),
                    location_of(plant, symbol), {{location_of(plant, first), "the symbol that has the role"}});
  }
}

}  // namespace

const Rule kRoleTaken{
    {"SP207", "role-taken", diag::Severity::warning, "several symbols fit one role of an archetype", kRoleTakenPage},
    check_role_taken};

}  // namespace symplant::check
