// SP310 initial-not-understood: an initial value cannot be read.
#include <fmt/format.h>

#include "check/rules.hpp"
#include "model/classify.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kInitialNotUnderstoodPage =
    R"(The Initial cell of a symbol is not a value of its type. BOOL takes TRUE or FALSE (or 1, 0). Numbers are written like 5, -3,
16#1F, K5, H1F or 1.5, and must fit their type.

**What the model loses.** The symbol starts off, or at 0. If its value decides in which state a device starts, the device starts
in another one.

**How to fix it.** Correct the cell, or leave it empty.
)";

void check_initial_not_understood(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.initial_known) continue;
    diagnostics.add(rule.info, about(symbol).explaining(symbol_named(symbol.name())),
                    fmt::format("`{}` is not a value of type {}: `{}` starts {}; correct it or leave it empty",
                                symbol.row->initial, model::data_type_name(symbol.type), symbol.name(),
                                symbol.type == tables::DataType::boolean ? "off" : "at 0"),
                    location_of(plant, *symbol.row, symbol.row->initial));
  }
}

}  // namespace

const Rule kInitialNotUnderstood{{"SP310", "initial-not-understood", diag::Severity::warning,
                                  "an initial value cannot be read", kInitialNotUnderstoodPage, diag::Rank::value},
                                 check_initial_not_understood};

}  // namespace symplant::check
