// SP312 byte-on-no-register: a numeric symbol has 8 bits and is on no register.
#include <fmt/format.h>

#include <vector>

#include "check/rules.hpp"
#include "model/classify.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kByteOnNoRegisterPage =
    R"(A numeric symbol has 8 bits. Registers have 16, and two such symbols would share one. PLCs differ in which half is used first,
so the symbol is in the images and on no register.

**What the model loses.** The PLC can neither write nor read the symbol over Modbus.

**How to fix it.** Give the symbol a separate register in the description's `links`, by `symbol` and `number`; it uses the lower
half. Or use a type of 16 bits (INT, UINT, WORD).
)";

void check_byte_on_no_register(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::vector<bool> placed(plant.symbols.size());
  for (const model::ControllerLink& link : plant.links) {
    for (const link::MapRow& row : link.rows) {
      if (row.number != link::MapRow::kDefault) placed[row.symbol] = true;
    }
  }
  for (std::size_t i = 0; i < plant.symbols.size(); ++i) {
    const model::Symbol& symbol = plant.symbols[i];
    if (placed[i]) continue;
    const int bits = model::data_type_bits(symbol.type);
    if (bits != 8 || !symbol.address || bits != static_cast<int>(symbol.address->size)) continue;
    diagnostics.add(rule.info, about(symbol),
                    fmt::format("`{}` is {}, {} bits: it is in the images and on no register", symbol.name(),
                                model::data_type_name(symbol.type), bits),
                    location_of(plant, *symbol.row, symbol.row->type));
  }
}

}  // namespace

const Rule kByteOnNoRegister{{"SP312", "byte-on-no-register", diag::Severity::note,
                              "a numeric symbol has 8 bits and is on no register", kByteOnNoRegisterPage},
                             check_byte_on_no_register};

}  // namespace symplant::check
