// SP309 no-address: I/O symbols have no address.
#include <fmt/format.h>

#include <vector>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kNoAddressPage =
    R"(Some symbols have neither a vendor's nor an IEC address; their direction comes from their names.

**What the model loses.** Nothing within the plant: they are in the model and in traces. But they are on no link, so no PLC
writes or reads them.

**How to fix it.** Give them addresses if a PLC should see them.
)";

void check_no_address(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::vector<const model::Symbol*> found;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!symbol.address && symbol.written_address().empty()) found.push_back(&symbol);  // otherwise SP307
  }
  if (found.empty()) return;
  std::vector<diag::Related> others;
  for (std::size_t i = 1; i < found.size() && i <= 5; ++i)
    others.push_back({location_of(plant, *found[i]), "no address either"});
  diagnostics.add(rule.info, about(*found[0]),
                  found.size() == 1 ? fmt::format("`{}` has no address: it is on no link", found[0]->name())
                                    : fmt::format("`{}` and {} more have no address: they are on no link",
                                                  found[0]->name(), found.size() - 1),
                  location_of(plant, *found[0]), std::move(others));
}

}  // namespace

const Rule kNoAddress{{"SP309", "no-address", diag::Severity::note, "I/O symbols have no address", kNoAddressPage},
                      check_no_address};

}  // namespace symplant::check
