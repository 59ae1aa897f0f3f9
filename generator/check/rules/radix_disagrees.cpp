// SP314 radix-disagrees: two lists of one controller count X and Y differently.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kRadixDisagreesPage =
    R"(A controller counts its X and Y either in hexadecimal or in octal. Here the lists of one controller disagree, by rows with both
a MELSEC and an IEC address or by their `"xy"`. What most rows of all its lists prove counts for all of them.

**What the model loses.** MELSEC addresses of this list in rows without an IEC address are read in the other radix: `X0010` has
index 16 in hexadecimal and index 8 in octal.

**How to fix it.** If the lists belong to two controllers, give each its `"controller"`. If they belong to one, correct the
wrong addresses, or the `"xy"`.
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
      related.push_back({location_of(plant, proof, proof.vendor_address), "this row proves the other radix"});
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
                            "two lists of one controller count X and Y differently", kRadixDisagreesPage},
                           check_radix_disagrees};

}  // namespace symplant::check
