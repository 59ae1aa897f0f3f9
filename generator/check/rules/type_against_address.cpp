// SP306 type-against-address: a type needs another size of address.
#include <fmt/format.h>

#include "check/rules.hpp"
#include "model/classify.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kTypeAgainstAddressPage =
    R"(A symbol's type and its address have different sizes: a BOOL on `%IW5`, an INT on `X0010`.

**What the model loses.** The symbol is in the model, but on no link: its register or bit is unknown, and might be that of another
symbol.

**How to fix it.** Correct the type or the address: BOOL goes with X, Y, `%IX`, `%QX`; 16-bit types with `%IW`, `%QW`; 32-bit
types with `%ID`, `%QD`.
)";

/// The symbol, which its device lacks.
diag::Subjects about_lost(const model::Symbol& symbol) {
  diag::Subjects subjects = about(symbol).explaining(address_of(symbol.name()));
  explain_missing(subjects, std::string(symbol.name()), symbol.reading.device_path, symbol.direction);
  return subjects;
}

void check_type_against_address(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!symbol.address) continue;
    const int bits = model::data_type_bits(symbol.type);
    if (bits == static_cast<int>(symbol.address->size)) continue;
    diagnostics.add(
        rule.info, about_lost(symbol),
        fmt::format("`{}` is {}, {} bit{}, but its address `{}` has {}: it is on no link; correct type or address",
                    symbol.name(), model::data_type_name(symbol.type), bits, bits == 1 ? "" : "s", symbol.address_cell,
                    static_cast<int>(symbol.address->size)),
        location_of(plant, *symbol.row, symbol.row->type),
        {{location_of(plant, *symbol.row, symbol.address_cell), "the address"}});
  }
}

}  // namespace

const Rule kTypeAgainstAddress{{"SP306", "type-against-address", diag::Severity::warning,
                                "a type needs another size of address", kTypeAgainstAddressPage, diag::Rank::row},
                               check_type_against_address};

}  // namespace symplant::check
