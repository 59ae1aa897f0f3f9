// Ranges of common analog input modules, as their vendors document them.
#include "elements/signal/modules.hpp"

namespace symplant::description {
namespace {

constexpr auto kModules = std::to_array<AnalogModule>({
    {"s7-unipolar", {0, 27648}, {-4864, 32511}},
    {"s7-bipolar", {-27648, 27648}, {-32512, 32511}},
    {"melsec-4000", {0, 4000}, {-4096, 4095}},
    {"melsec-4000-bipolar", {-4000, 4000}, {-4096, 4095}},
    {"melsec-32000", {0, 32000}, {-768, 32767}},
    {"melsec-32000-bipolar", {-32000, 32000}, {-32768, 32767}},
    {"1769-if4-0-20ma", {0, 31206}, {0, 32767}},
    {"1769-if4-1-5v", {6243, 31206}, {3121, 32767}},
    {"1762-4-20ma", {6240, 31200}, {0, 32760}},
    {"omron-6000", {0, 6000}, {-300, 6300}},
    {"omron-6000-bipolar", {-3000, 3000}, {-3300, 3300}},
    {"beckhoff-unipolar", {0, 32767}, {0, 32767}},
    {"beckhoff-bipolar", {-32768, 32767}, {-32768, 32767}},
});

}  // namespace

const AnalogModule* analog_module(std::string_view name) {
  for (const AnalogModule& module : kModules) {
    if (module.name == name) return &module;
  }
  return nullptr;
}

std::string analog_module_names() {
  std::string names;
  for (const AnalogModule& module : kModules) {
    names.append(names.empty() ? "`" : ", `").append(module.name).append("`");
  }
  return names;
}

}  // namespace symplant::description
