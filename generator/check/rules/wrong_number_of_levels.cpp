// SP201 wrong-number-of-levels: a name has more or fewer levels than the rule.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kWrongNumberOfLevelsPage =
    R"(A symbol's name has another number of levels than the naming rule requires. The built-in rule is `LINE_PROC_DEV_I|O_TASK`: five
levels of letters and digits, separated by `_`.

**What the model loses.** The device of the symbol is unknown, so it is in no unit: no device drives it, and it drives none. It
is still served: it is in the images, on the links and in the traces, and can be set by hand.

**How to fix it.** Add the missing level, or join two words into one level: `EXLINE_MB_AGV_FAST_O_P2` becomes
`EXLINE_MB_AGVFAST_O_P2`.
)";

void check_wrong_number_of_levels(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  const std::size_t wanted = plant.rule->levels.size();
  for (const model::Symbol& symbol : plant.symbols) {
    if (!breaks_rule(subject, symbol, name::NameFault::wrong_number_of_levels)) continue;
    diag::Location location = location_of(plant, symbol);
    narrow(location, symbol);
    diagnostics.add(
        rule.info, about_name(plant, symbol),
        fmt::format("`{}` has {} level{}, `{}` requires {}: its device is unknown, {}; {}", symbol.name(),
                    symbol.reading.levels, symbol.reading.levels == 1 ? "" : "s", plant.rule->pattern, wanted,
                    consequence(symbol),
                    symbol.reading.levels > wanted ? "remove a level or join two" : "add the missing levels"),
        location);
  }
}

}  // namespace

const Rule kWrongNumberOfLevels{
    {"SP201", "wrong-number-of-levels", diag::Severity::warning, "a name has more or fewer levels than the rule",
     kWrongNumberOfLevelsPage, diag::Rank::name},
    check_wrong_number_of_levels};

}  // namespace symplant::check
