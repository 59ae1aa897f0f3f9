// SP206 path-ambiguous: two devices have one path.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kPathAmbiguousPage =
    R"(Under a custom naming rule the path of a device is its line, process and device, joined by `_`. Two devices have the same
path, because the levels are divided differently (`A_B` and `C`, `A` and `B_C`), or because they are in two controllers.

**What the model loses.** Both devices are in the model. A condition, a scenario or plant.json that names the path means the
first one only.

**How to fix it.** Divide the levels alike in both rules of naming.json, or add a level, as with `"fixed": { "line": "PLC2" }`.
)";

void check_path_ambiguous(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.pairing == nullptr) return;
  for (const pairing::Remark& remark : plant.pairing->remarks) {
    if (remark.kind != pairing::Remark::Kind::path_ambiguous) continue;
    const model::Symbol& symbol = plant.symbols[remark.input];
    const model::Symbol& other = plant.symbols[remark.other];
    diagnostics.add(rule.info, about(symbol),
                    fmt::format("`{}` is the path of another device too, with other levels or of another controller: "
                                "names in conditions and plant.json mean the first device",
                                symbol.reading.device_path),
                    location_of(plant, symbol), {{location_of(plant, other), "a symbol of the other device"}});
  }
}

}  // namespace

const Rule kPathAmbiguous{
    {"SP206", "path-ambiguous", diag::Severity::warning, "two devices have one path", kPathAmbiguousPage},
    check_path_ambiguous};

}  // namespace symplant::check
