// Symbols that a link in a description names.
#include "elements/link/symbol.hpp"

#include <algorithm>
#include <vector>

#include "model/plant_model.hpp"
#include "symplant/link/clock_symbol.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

using description::ticked;

/// A row of this name in any list; null if there is none.
const read::ListRow* row_of_list(const PlantModel& plant, std::string_view name) {
  for (const PlantList& list : plant.lists) {
    for (const read::ListRow& row : list.table->rows) {
      if (text::equal_ignoring_case(row.name, name)) return &row;
    }
  }
  return nullptr;
}

}  // namespace

void report_no_symbol(const PlantModel& plant, std::uint32_t controller, const std::string& name,
                      std::string_view advice, const description::Pointer& at, description::Faults& faults) {
  if (const read::ListRow* row = row_of_list(plant, name); row != nullptr) {
    const std::string_view address = row->vendor_address.empty() ? row->iec_address : row->vendor_address;
    faults.add(at,
               ticked(name) + " is in the list, but is not an input or output of this controller" +
                   (address.empty() ? "" : ", its address is " + ticked(address)) + "; " + std::string(advice),
               description::FaultKind::unknown_name);
    return;
  }
  std::vector<std::string_view> names;
  for (const Symbol& symbol : plant.symbols) {
    if (plant.controller_of(symbol) == controller) names.push_back(symbol.name());
  }
  const auto nearest = faults.nearest(name, names.size(), [&](std::size_t i) { return names[i]; });
  faults.add(at, description::missing("symbol " + ticked(name), nearest), description::FaultKind::unknown_name);
}

std::uint32_t resolve_clock(const PlantModel& plant, std::uint32_t controller, const description::LinkDescription& link,
                            description::Faults& faults) {
  constexpr std::uint32_t kNoClock = link::ClockSettings::kNone;
  if (link.clock_of.empty()) return kNoClock;
  const auto index = static_cast<std::size_t>(&link - plant.description->links.data());
  const description::Pointer at = description::Pointer("/links") / index / "clock";
  const bool second = std::any_of(plant.links.begin(), plant.links.end(),
                                  [](const ControllerLink& other) { return other.link.clock.symbol != kNoClock; });
  if (second) {
    faults.add(at, "another link also has a `clock`, and plant time can follow only one; remove one");
    return kNoClock;
  }
  const auto symbol = std::find_if(plant.symbols.begin(), plant.symbols.end(), [&](const Symbol& candidate) {
    return plant.controller_of(candidate) == controller && text::equal_ignoring_case(candidate.name(), link.clock_of);
  });
  if (symbol == plant.symbols.end()) {
    report_no_symbol(plant, controller, link.clock_of, "give the counter an output address", at / "of", faults);
    return kNoClock;
  }
  const std::string fault = link::clock_fault(symbol->type, symbol->direction);
  if (fault.empty()) return static_cast<std::uint32_t>(symbol - plant.symbols.begin());
  faults.add(at / "of", ticked(symbol->name()) + " " + fault);
  return kNoClock;
}

}  // namespace symplant::model
