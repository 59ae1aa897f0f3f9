// SP302 symbol-declared-differently: a symbol is declared twice with different addresses or types.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kSymbolDeclaredDifferentlyPage =
    R"(Two rows of the plant's lists declare one name, but their addresses or types differ, or they are in lists of different
controllers. Names are unique across a plant, addresses within a controller. The case of ASCII letters does not count in names,
as in PLC tools.

**What the model loses.** The plant cannot be built: whichever row counted, the PLC program might mean the other.

**How to fix it.** Rename one of the symbols, or delete the wrong row.
)";

/// The second row, and the device that both rows name.
diag::Subjects about_second(const model::PlantModel& plant, const model::Duplicate& duplicate) {
  diag::Subjects subjects = about(*duplicate.second).explaining(address_of(duplicate.first->name));
  const model::Symbol* first = symbol_of(plant, *duplicate.first);
  if (first != nullptr) subjects.explains.push_back(device(first->reading.device_path));
  return subjects;
}

void check_symbol_declared_differently(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Duplicate& duplicate : subject.evidence.duplicates) {
    if (duplicate.same) continue;
    const auto controller = [&](const read::ListRow& row) { return plant.lists[plant.list_of(row)].controller; };
    const bool other = controller(*duplicate.first) != controller(*duplicate.second);
    diagnostics.add(
        rule.info, about_second(plant, duplicate),
        fmt::format(
            "`{}` is declared again {}: rename it, or delete the row that is wrong", duplicate.second->name,
            other ? "for another controller, and names are unique across a plant" : "with another address or type"),
        location_of(plant, *duplicate.second, duplicate.second->name),
        {{location_of(plant, *duplicate.first, duplicate.first->name), "first declared here"}});
  }
}

}  // namespace

const Rule kSymbolDeclaredDifferently{
    {"SP302", "symbol-declared-differently", diag::Severity::error,
     "a symbol is declared twice with different addresses or types", kSymbolDeclaredDifferentlyPage, diag::Rank::row},
    check_symbol_declared_differently};

}  // namespace symplant::check
