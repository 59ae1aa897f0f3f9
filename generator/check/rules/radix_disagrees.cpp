// SP314 radix-disagrees: two lists of one controller count X and Y in different ways.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kRadixDisagreesPage =
    R"(A controller counts its X and Y in one way: in hexadecimal or in octal. Here one of its lists says the one, and another
list the other, by rows with both a MELSEC and an IEC address or by its `"xy"`. What most rows of all its lists prove counts
for all of them.

**What the model loses.** MELSEC addresses of this list, where no IEC address stands beside them, are read in the other way:
`X0010` is place 16 in hexadecimal and place 8 in octal.

**How to fix it.** Lists of two controllers: give each its own `"controller"`. Lists of one: correct the wrong addresses, or
the `"xy"`.
)";

std::string_view radix_name(address::Radix radix) {
  return radix == address::Radix::hexadecimal ? "hexadecimal" : "octal";
}

void check_radix_disagrees(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::PlantList& list : plant.lists) {
    if (list.own.by == model::RadixChoice::By::nothing || list.own.radix == list.radix.radix) continue;
    diag::Location location{list.table->source, {}};
    if (list.own.proof != nullptr) location = location_of(plant, *list.own.proof, list.own.proof->vendor_address);
    std::vector<diag::Related> related;
    if (list.radix.proof != nullptr) {
      const read::ListRow& proof = *list.radix.proof;
      related.push_back({location_of(plant, proof, proof.vendor_address), "this row proves the other way"});
    }
    diagnostics.add(rule.info,
                    fmt::format("this list counts X and Y in {}, but all lists of its controller are read in {}: "
                                "correct one of them, or give the lists different controllers",
                                radix_name(list.own.radix), radix_name(list.radix.radix)),
                    std::move(location), std::move(related));
  }
}

}  // namespace

const Rule kRadixDisagrees{{"SP314", "radix-disagrees", diag::Severity::warning,
                            "two lists of one controller count X and Y in different ways", kRadixDisagreesPage},
                           check_radix_disagrees};

}  // namespace symplant::check
