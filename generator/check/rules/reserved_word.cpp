// SP214 reserved-word: a name is a word of IEC 61131-3.
#include <fmt/format.h>

#include "check/rules.hpp"
#include "convert/identifiers.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kReservedWordPage =
    R"(A symbol is named like a keyword, an elementary type or a standard function of IEC 61131-3: `STEP`, `TIME`, `LIMIT`.

**What the model loses.** Nothing here. But a program in structured text cannot use the name, and tools refuse to import it.

**How to fix it.** Rename the symbol. `symplant convert` writes `_STEP`.
)";

void check_reserved_word(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!convert::is_iec_reserved(symbol.name())) continue;
    diag::Diagnostic& finding = diagnostics.add(
        rule.info, about(symbol),
        fmt::format("`{}` is a reserved word of IEC 61131-3: programs cannot use it as a name; rename it",
                    symbol.name()),
        location_of(plant, symbol));
    finding.renames.push_back(rename_of(symbol, convert::iec_identifier(symbol.name()), false));
  }
}

}  // namespace

const Rule kReservedWord{
    {"SP214", "reserved-word", diag::Severity::warning, "a name is a word of IEC 61131-3", kReservedWordPage},
    check_reserved_word};

}  // namespace symplant::check
