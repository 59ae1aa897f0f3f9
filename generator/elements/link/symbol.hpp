// Symbols that a link in a description names: its clock, and a name that is not found.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "description/faults.hpp"
#include "symplant/link/link_settings.hpp"

namespace symplant::model {

struct PlantModel;

/// Reports that a controller has no input or output of this name; The message ends with `advice` if the name is in the
/// controller's lists. O(symbols + rows).
void report_no_symbol(const PlantModel& plant, std::uint32_t controller, const std::string& name,
                      std::string_view advice, const description::Pointer& at, description::Faults& faults);

/// The symbol of the link's clock; ClockSettings::kNone if it has none. Also kNone, with a fault, if the symbol is not
/// found, is not a whole number of 16, 32 or 64 bits that the PLC writes, or is a second clock of the plant. O(symbols
/// + rows).
std::uint32_t resolve_clock(const PlantModel& plant, std::uint32_t controller, const description::LinkDescription& link,
                            description::Faults& faults);

}  // namespace symplant::model
