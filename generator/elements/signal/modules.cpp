// Ranges of common analog input modules, as their vendors document them.
#include "elements/signal/modules.hpp"

namespace symplant::description {
namespace {

constexpr std::array kModules{AnalogModule{"s7-unipolar", {0, 27648}, {-4864, 32511}},
                              AnalogModule{"s7-bipolar", {-27648, 27648}, {-32512, 32511}}};

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
