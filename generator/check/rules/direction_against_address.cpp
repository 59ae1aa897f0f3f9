// SP305 direction-against-address: a name gives one direction, its address the other.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kDirectionAgainstAddressPage =
    R"(The direction in a symbol's name contradicts its address: `..._I_...` has the address of an output (Y, `%Q`), or `..._O_...`
that of an input (X, `%I`).

**What the model loses.** The address counts, since it is wired: the symbol has the direction of its address. If the address is
wrong, an operation or an event of the device is missing.

**How to fix it.** Correct the name, or the address.
)";

void check_direction_against_address(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::set<const model::Symbol*> reported;  // by SP407
  for (const TaskClaim& claim : task_claims(plant)) reported.insert(&plant.symbols[claim.overruled]);
  for (const model::Symbol& symbol : plant.symbols) {
    const name::NameFault fault = symbol.reading.fault;
    if (!symbol.address || (fault != name::NameFault::none && fault != name::NameFault::not_linked)) continue;
    const bool name_says_operation = symbol.reading.direction == name::Direction::operation;
    if (name_says_operation == (symbol.direction == tables::Direction::operation)) continue;
    if (reported.count(&symbol) != 0) continue;
    diagnostics.add(
        rule.info,
        about(symbol)
            .explaining(device(symbol.reading.device_path))
            .explaining(address_of(symbol.name()))
            .following(address_of(symbol.name())),
        fmt::format("`{}` is an {} by its name and an {} by its address `{}`: the address counts; correct one of "
                    "them",
                    symbol.name(), name_says_operation ? "operation" : "event", direction_text(symbol.direction),
                    symbol.address_cell),
        location_of(plant, symbol), {{location_of(plant, *symbol.row, symbol.address_cell), "the address"}});
  }
}

}  // namespace

const Rule kDirectionAgainstAddress{
    {"SP305", "direction-against-address", diag::Severity::warning, "a name gives one direction, its address the other",
     kDirectionAgainstAddressPage, diag::Rank::direction},
    check_direction_against_address};

}  // namespace symplant::check
