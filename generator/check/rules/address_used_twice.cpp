// SP303 address-used-twice: several symbols stand on one address.
#include <fmt/format.h>

#include <algorithm>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kAddressUsedTwicePage =
    R"(Two symbols have one address. That may be meant (two names for one signal), but more often a row was copied and its address
not changed.

**What the model loses.** Symbols of one address are kept equal: whatever writes one writes all. Where a unit moves one of
them, the others follow it and say nothing of their own.

**How to fix it.** Give the symbol the address that it has in the wiring, or take the second name away.
)";

void check_address_used_twice(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.leader == model::kNone) continue;
    const model::Symbol& leader = plant.symbols[symbol.leader];
    const auto index = static_cast<std::uint32_t>(&symbol - plant.symbols.data());
    const auto found = std::lower_bound(subject.evidence.driven_twice.begin(), subject.evidence.driven_twice.end(), index,
                                        [](const auto& pair, std::uint32_t i) { return pair[0] < i; });
    if (found != subject.evidence.driven_twice.end() && (*found)[0] == index) continue;  // SP304 tells
    diagnostics.add(
        rule.info,
        about(symbol, leader).following(address_of(symbol.name())).following(address_of(leader.name())),
        fmt::format("`{}` stands on `{}` as `{}` does: they are kept equal; correct the address if they are two "
                    "signals",
                    symbol.name(), symbol.address_cell, leader.name()),
        location_of(plant, *symbol.row, symbol.address_cell),
        {{location_of(plant, *leader.row, leader.address_cell), "the symbol that it follows"}});
  }
}

}  // namespace

const Rule kAddressUsedTwice{{"SP303", "address-used-twice", diag::Severity::warning,
                              "several symbols stand on one address", kAddressUsedTwicePage},
                             check_address_used_twice};

}  // namespace symplant::check
