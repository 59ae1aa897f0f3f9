// SP312 wide-value-on-no-register: a numeric symbol is not of 16 bits and on no register.
#include <fmt/format.h>

#include "check/rules.hpp"
#include "model/classify.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kPage =
    R"(A numeric symbol is of 8, 32 or 64 bits. Registers have 16; how wider values lie in several of them is not settled yet in
this version, so the symbol is in the images and on no register.

**What the model loses.** The PLC can neither write nor read the symbol over Modbus.

**How to mend it.** Use a type of 16 bits (INT, UINT, WORD) where the value allows it.
)";

void check_wide_value_on_no_register(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    const int bits = model::data_type_bits(symbol.type);
    if (!symbol.address || bits == 1 || bits == 16 || bits != static_cast<int>(symbol.address->size)) continue;
    diagnostics.add(rule.info, about(symbol),
                    fmt::format("`{}` is {}, {} bits: it is in the images and on no register", symbol.name(),
                                model::data_type_name(symbol.type), bits),
                    place_of(plant, *symbol.row, symbol.row->type));
  }
}

}  // namespace

const Rule kWideValueOnNoRegister{{"SP312", "wide-value-on-no-register", diag::Severity::note,
                                   "a numeric symbol is not of 16 bits and on no register", kPage},
                                  check_wide_value_on_no_register};

}  // namespace symplant::check
