// SP303 address-used-twice: several symbols have one address.
#include <fmt/format.h>

#include <algorithm>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kAddressUsedTwicePage =
    R"(Two symbols have one address. This may be intended (two names for one signal). More often a row was copied and its address not
changed.

**What the model loses.** Symbols of one address are kept equal: writing one writes all. If a device drives one of them, the
others have its value.

**How to fix it.** Give the symbol the address that it has in the wiring, or remove the second name.
)";

void check_address_used_twice(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.leader == model::kNone) continue;
    const model::Symbol& leader = plant.symbols[symbol.leader];
    const auto index = static_cast<std::uint32_t>(&symbol - plant.symbols.data());
    const auto found = std::lower_bound(subject.evidence.driven_twice.begin(), subject.evidence.driven_twice.end(),
                                        index, [](const auto& pair, std::uint32_t i) { return pair[0] < i; });
    if (found != subject.evidence.driven_twice.end() && (*found)[0] == index) continue;  // SP304 reports it
    diagnostics.add(
        rule.info, about(symbol, leader).following(address_of(symbol.name())).following(address_of(leader.name())),
        fmt::format("`{}` has the address `{}`, as `{}` has: they are kept equal; correct the address if they are "
                    "two signals",
                    symbol.name(), symbol.address_cell, leader.name()),
        location_of(plant, *symbol.row, symbol.address_cell),
        {{location_of(plant, *leader.row, leader.address_cell), "the symbol that it follows"}});
  }
}

}  // namespace

const Rule kAddressUsedTwice{
    {"SP303", "address-used-twice", diag::Severity::warning, "several symbols have one address", kAddressUsedTwicePage},
    check_address_used_twice};

}  // namespace symplant::check
