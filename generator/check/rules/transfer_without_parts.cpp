// SP632 transfer-without-parts: no part can reach the location that a transfer takes from.
#include <fmt/format.h>

#include "check/part_routes.hpp"
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kTransferWithoutPartsPage =
    R"(The material flow has sources, but from none of them a part can come to the location that this transfer takes parts from: no end of
a track and no other transfer leads there.

**What the model loses.** The transfer never moves a part, unless a scenario or a person puts one there.

**How to fix it.** Name the right location in `from`, or add the `end`, transfer or source that brings parts there.
)";

void check_transfer_without_parts(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  const model::Material& material = plant.material;
  if (material.sources.empty() || !subject.evidence.faults.empty()) return;
  const std::vector<bool> reached = locations_with_parts(material);
  for (const model::Transfer& transfer : material.transfers) {
    if (reached[transfer.from.location]) continue;
    diagnostics.add(
        rule.info, {},
        fmt::format("transfer `{}`: no part can come to `{}`; add what brings parts there", transfer.name,
                    material.location_name(transfer.from.location)),
        location_of({}, description::Pointer("/material/transfers") / std::size_t{transfer.given} / "from"));
  }
}

}  // namespace

const Rule kTransferWithoutParts{
    {"SP632", "transfer-without-parts", diag::Severity::warning,
     "no part can reach the location that a transfer takes from", kTransferWithoutPartsPage},
    check_transfer_without_parts};

}  // namespace symplant::check
