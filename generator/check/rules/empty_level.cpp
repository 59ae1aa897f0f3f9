// SP202 empty-level: a level of a name is empty.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kEmptyLevelPage =
    R"(A symbol's name has two adjacent separators, or a separator at its beginning or end, so that one of its levels is empty.

**What the model loses.** The symbol is in no unit: no device drives it, and it drives none. It is still served.

**How to fix it.** Write the missing word, or remove the surplus `_`: `EXLINE__AGV_I_P1` becomes `EXLINE_MB_AGV_I_P1`.
)";

void check_empty_level(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!breaks_rule(subject, symbol, name::NameFault::empty_level)) continue;
    diag::Location location = location_of(plant, symbol);
    narrow(location, symbol);
    diagnostics.add(rule.info, about_name(plant, symbol),
                    fmt::format("`{}` has an empty level: its device is unknown, {}; write the missing word or "
                                "remove the surplus separator",
                                symbol.name(), consequence(symbol)),
                    location);
  }
}

}  // namespace

const Rule kEmptyLevel{
    {"SP202", "empty-level", diag::Severity::warning, "a level of a name is empty", kEmptyLevelPage, diag::Rank::name},
    check_empty_level};

}  // namespace symplant::check
