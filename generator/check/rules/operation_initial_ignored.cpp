// SP311 operation-initial-ignored: an operation has an initial value.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kOperationInitialIgnoredPage =
    R"(An operation (a PLC output) of type BOOL has Initial TRUE. The PLC writes operations: in the plant they start off until a PLC, a
scenario or a person sets them.

**What the model loses.** Nothing, if the PLC writes its outputs as usual.

**How to fix it.** Nothing to do.
)";

void check_operation_initial_ignored(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.direction != tables::Direction::operation || symbol.type != tables::DataType::boolean) continue;
    if (symbol.initial == 0) continue;
    diagnostics.add(rule.info, about(symbol).following(address_of(symbol.name())),
                    fmt::format("`{}` has Initial TRUE and still starts off: the PLC writes operations", symbol.name()),
                    location_of(plant, *symbol.row, symbol.row->initial));
  }
}

}  // namespace

const Rule kOperationInitialIgnored{{"SP311", "operation-initial-ignored", diag::Severity::note,
                                     "an operation has an initial value", kOperationInitialIgnoredPage},
                                    check_operation_initial_ignored};

}  // namespace symplant::check
