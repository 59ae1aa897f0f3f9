// Rules: symbols and addresses that are there twice.
#include <fmt/format.h>

#include <algorithm>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

void check_duplicate_symbol(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Duplicate& duplicate : subject.evidence.duplicates) {
    if (!duplicate.same) continue;
    diagnostics.add(
        rule.info, about(*duplicate.second),
        fmt::format("`{}` is declared again, with the same address and type: this row is left out; delete it",
                    duplicate.second->name),
        location_of(plant, *duplicate.second, duplicate.second->name),
        {{location_of(plant, *duplicate.first, duplicate.first->name), "first declared here"}});
  }
}

/// The second row, and the device that both rows name.
diag::Subjects about_second(const model::PlantModel& plant, const model::Duplicate& duplicate) {
  diag::Subjects subjects = about(*duplicate.second).explaining(address_of(duplicate.first->name));
  const model::Symbol* first = symbol_of(plant, *duplicate.first);
  if (first != nullptr) subjects.explains.push_back(device(first->reading.device_path()));
  return subjects;
}

void check_symbol_declared_differently(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Duplicate& duplicate : subject.evidence.duplicates) {
    if (duplicate.same) continue;
    const auto controller = [&](const read::ListRow& row) { return plant.lists[plant.list_of(row)].controller; };
    const bool other = controller(*duplicate.first) != controller(*duplicate.second);
    diagnostics.add(
        rule.info, about_second(plant, duplicate),
        fmt::format(
            "`{}` is declared again {}: rename it, or delete the row that is wrong", duplicate.second->name,
            other ? "for another controller, and names are unique across a plant" : "with another address or type"),
        location_of(plant, *duplicate.second, duplicate.second->name),
        {{location_of(plant, *duplicate.first, duplicate.first->name), "first declared here"}});
  }
}

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
                    symbol.name(), symbol.address_cell(), leader.name()),
        location_of(plant, *symbol.row, symbol.address_cell()),
        {{location_of(plant, *leader.row, leader.address_cell()), "the symbol that it follows"}});
  }
}

void check_event_driven_twice(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const auto& [second, first] : subject.evidence.driven_twice) {
    const model::Symbol& a = plant.symbols[first];
    const model::Symbol& b = plant.symbols[second];
    const bool devices = !a.driven_without_unit() && !b.driven_without_unit();
    diagnostics.add(
        rule.info, about(b, a).following(address_of(b.name())).following(address_of(a.name())),
        fmt::format("`{}` has the address `{}`, as `{}` has, and {}: correct one address", b.name(), b.address_cell(),
                    a.name(), devices ? "different devices drive them" : "the plant drives each of them separately"),
        location_of(plant, *b.row, b.address_cell()),
        {{location_of(plant, *a.row, a.address_cell()), "the other one"}});
  }
}

}  // namespace

const Rule kDuplicateSymbol{
    {"SP301", "duplicate-symbol", diag::Severity::warning, "a symbol is declared twice, identically",
     R"(Two rows of the plant's lists declare one name, with the same address and type. The case of ASCII letters does not count in
names, as in PLC tools.

**What the model loses.** Nothing: the first row counts, the second is ignored.

**How to fix it.** Delete one of the rows.
)"},
    check_duplicate_symbol};

const Rule kSymbolDeclaredDifferently{
    {"SP302", "symbol-declared-differently", diag::Severity::error,
     "a symbol is declared twice with different addresses or types",
     R"(Two rows of the plant's lists declare one name, but their addresses or types differ, or they are in lists of different
controllers. Names are unique across a plant, addresses within a controller. The case of ASCII letters does not count in names,
as in PLC tools.

**What the model loses.** The plant cannot be built: whichever row counted, the PLC program might mean the other.

**How to fix it.** Rename one of the symbols, or delete the wrong row.
)",
     diag::Rank::row},
    check_symbol_declared_differently};

const Rule kAddressUsedTwice{
    {"SP303", "address-used-twice", diag::Severity::warning, "several symbols have one address",
     R"(Two symbols have one address. This may be intended (two names for one signal). More often a row was copied and its address not
changed.

**What the model loses.** Symbols of one address are kept equal: writing one writes all. If a device drives one of them, the
others have its value.

**How to fix it.** Give the symbol the address that it has in the wiring, or remove the second name.
)"},
    check_address_used_twice};

const Rule kEventDrivenTwice{
    {"SP304", "event-driven-twice", diag::Severity::error, "two devices drive events on one address",
     R"(Two events have one address, and different devices drive them, or a condition (`follow`) or a sensor of parts drives at least
one. The PLC reads one bit there, and the plant would have two values for it.

**What the model loses.** The plant cannot be built.

**How to fix it.** Correct the address of one of them.
)"},
    check_event_driven_twice};

}  // namespace symplant::check
