// SP305 direction-against-address: a name gives one direction, its address the other.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kDirectionAgainstAddressPage =
    R"(The direction in a symbol's name contradicts its address: `..._I_...` has the address of an output (Y, `%Q`), or `..._O_...`
that of an input (X, `%I`).

**What the model loses.** The address counts, since it is wired: the symbol has the direction of its address. If the address is
wrong, an operation or an event of the device is missing. A naming rule may give the name priority (`"direction"` in
naming.json).

**How to fix it.** Correct the name, or the address.
)";

void check_direction_against_address(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  if (!conflicts_are_errors(subject.plant)) report_direction_conflicts(rule, subject, diagnostics);
}

}  // namespace

bool conflicts_are_errors(const model::PlantModel& plant) {
  return plant.reader != nullptr && plant.reader->naming().naming().direction.conflict_is_error;
}

void report_direction_conflicts(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  std::set<const model::Symbol*> reported;  // by SP407
  for (const TaskClaim& claim : task_claims(plant)) reported.insert(&plant.symbols[claim.overruled]);
  for (const model::Symbol& symbol : plant.symbols) {
    const name::NameFault fault = symbol.reading.fault;
    if (!symbol.address || (fault != name::NameFault::none && fault != name::NameFault::not_linked)) continue;
    const bool name_says_operation = symbol.reading.direction == name::Direction::operation;
    const bool address_says_operation = symbol.address->area == address::Area::output;
    if (name_says_operation == address_says_operation || reported.count(&symbol) != 0) continue;
    const bool address_counts = (symbol.direction == tables::Direction::operation) == address_says_operation;
    diag::Diagnostic& finding = diagnostics.add(
        rule.info,
        about(symbol)
            .explaining(device(symbol.reading.device_path))
            .explaining(address_of(symbol.name()))
            .following(address_of(symbol.name())),
        fmt::format("`{}` is an {} by its name and an {} by its address `{}`: the {} counts; correct one of them",
                    symbol.name(), name_says_operation ? "operation" : "event",
                    address_says_operation ? "operation" : "event", symbol.address_cell,
                    address_counts ? "address" : "name"),
        location_of(plant, symbol), {{location_of(plant, *symbol.row, symbol.address_cell), "the address"}});
    if (plant.pairing != nullptr) continue;  // a custom rule reads names and does not write them
    diag::Subject renamed = missing(plant, symbol.reading.device_path, symbol.direction, symbol.reading.task);
    finding.renames.push_back(rename_of(symbol, std::move(renamed.name), false));
  }
}

const Rule kDirectionAgainstAddress{
    {"SP305", "direction-against-address", diag::Severity::warning, "a name gives one direction, its address the other",
     kDirectionAgainstAddressPage, diag::Rank::direction},
    check_direction_against_address};

}  // namespace symplant::check
