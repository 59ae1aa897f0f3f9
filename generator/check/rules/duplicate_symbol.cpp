// SP301 duplicate-symbol: a symbol is declared twice, identically.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kDuplicateSymbolPage =
    R"(Two rows of the plant's lists declare one name, with the same address and type. The case of ASCII letters does not count in
names, as in PLC tools.

**What the model loses.** Nothing: the first row counts, the second is ignored.

**How to fix it.** Delete one of the rows.
)";

void check_duplicate_symbol(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Duplicate& duplicate : subject.evidence.duplicates) {
    if (!duplicate.same) continue;
    diagnostics.add(
        rule.info, about(*duplicate.second),
        fmt::format("`{}` is declared again, with the same address and type: this row is left out; delete it",
                    duplicate.second->name),
        location_of(plant, *duplicate.second, duplicate.second->name),
        {{location_of(plant, *duplicate.first, duplicate.first->name), "first declared here"}});
  }
}

}  // namespace

const Rule kDuplicateSymbol{{"SP301", "duplicate-symbol", diag::Severity::warning,
                             "a symbol is declared twice, identically", kDuplicateSymbolPage},
                            check_duplicate_symbol};

}  // namespace symplant::check
