// SP308 radix-assumed: whether X and Y count in hexadecimal is assumed.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kRadixAssumedPage =
    R"(MELSEC Q, L and iQ-R count X and Y in hexadecimal, FX and iQ-F in octal. This list proves neither: no row has both a MELSEC and
an IEC address, and it has numbers for which it makes a difference.

**What the model loses.** Nothing within the plant. On a link, `X0010` has index 16 in hexadecimal and index 8 in octal.

**How to fix it.** Use `--xy hex` or `--xy octal` (in plant.json `"xy"` next to the list's file), or export the IEC addresses as
well.
)";

void check_radix_assumed(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (std::uint32_t list = 0; list < plant.lists.size(); ++list) {
    const model::RadixChoice& radix = plant.lists[list].radix;
    if (radix.by != model::RadixChoice::By::nothing || radix.matters_in == nullptr) continue;
    const read::ListRow& row = *radix.matters_in;
    if (plant.list_of(row) != list) continue;  // reported once for all lists of a controller
    diagnostics.add(rule.info, about(row),
                    fmt::format("`{}` is read as hexadecimal, and nothing in the list proves it: use `--xy hex` or "
                                "`--xy octal`",
                                row.vendor_address),
                    location_of(plant, row, row.vendor_address));
  }
}

}  // namespace

const Rule kRadixAssumed{{"SP308", "radix-assumed", diag::Severity::note,
                          "whether X and Y count in hexadecimal is assumed", kRadixAssumedPage},
                         check_radix_assumed};

}  // namespace symplant::check
