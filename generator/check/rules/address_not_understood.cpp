// SP307 address-not-understood: an address cell holds no address.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kAddressNotUnderstoodPage =
    R"(A cell of an address column holds something that is neither an IEC 61131-3 address (`%IX1`, `%QX0.5`, `%IW5`) nor a MELSEC
device (X1F, Y0001, M500, D10).

**What the model loses.** The symbol has no address from this cell. Without one in the other column its direction is that
of its name, and it is on no link.

**How to mend it.** Correct the cell. Digits 8, 9 and A to F in X and Y need `--xy hex`.
)";

void check_address_not_understood(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::BadAddress& bad : plant.bad_addresses) {
    diagnostics.add(
        rule.info, about(*bad.row),
        fmt::format("`{}` is no address: `{}` gets none from it; write it like `%IX1`, `%QW5`, `X1F` or `Y0001`",
                    bad.cell, bad.row->name),
        place_of(plant, *bad.row, bad.cell));
  }
}

}  // namespace

const Rule kAddressNotUnderstood{{"SP307", "address-not-understood", diag::Severity::warning,
                                  "an address cell holds no address", kAddressNotUnderstoodPage},
                                 check_address_not_understood};

}  // namespace symplant::check
