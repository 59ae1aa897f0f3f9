// Ranges of common analog input modules, as their vendors document them.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace symplant::description {

/// The numbers that a module gives the PLC at the ends of its measuring range, and beyond it. Sources: docs/values.md.
struct AnalogModule {
  std::string_view name;
  std::array<double, 2> to;
  std::array<double, 2> limit;
};

/// Null if no module has the name. O(modules).
const AnalogModule* analog_module(std::string_view name);
/// All names in back-ticks, separated by commas, for a message.
std::string analog_module_names();

}  // namespace symplant::description
