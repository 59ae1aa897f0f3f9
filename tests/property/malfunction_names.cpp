// How actions name malfunctions.
#include "property/malfunction_names.hpp"

namespace symplant::property {

std::optional<std::uint32_t> malfunction_number(const model::PlantModel& model, const std::string& text) {
  const auto written = static_cast<std::uint32_t>(model.malfunctions.size());
  for (std::uint32_t i = 0; i < written; ++i) {
    if (model.malfunctions[i].name == text) return i;
  }
  const std::size_t colon = text.find(':');
  if (colon == text.npos) return std::nullopt;
  const std::string kind = text.substr(0, colon);
  const std::string of = text.substr(colon + 1);
  for (std::uint32_t u = 0; u < model.units.size(); ++u) {
    if (model.units[u].path != of) continue;
    if (kind == "stuck") return written + 2 * u;
    if (kind == "slow") return written + 2 * u + 1;
  }
  const std::uint32_t first = written + 2 * static_cast<std::uint32_t>(model.units.size());
  for (std::uint32_t s = 0; s < model.symbols.size(); ++s) {
    if (model.symbols[s].name() != of) continue;
    if (kind == "off") return first + 2 * s;
    if (kind == "on") return first + 2 * s + 1;
  }
  return std::nullopt;
}

std::string malfunction_text(const model::PlantModel& model, std::uint32_t number) {
  if (number < model.malfunctions.size()) return model.malfunctions[number].name;
  std::size_t rest = number - model.malfunctions.size();
  const bool odd = rest % 2 != 0;
  rest /= 2;
  if (rest < model.units.size()) return (odd ? "slow:" : "stuck:") + std::string(model.units[rest].path);
  rest -= model.units.size();
  if (rest >= model.symbols.size()) return "#" + std::to_string(number);
  return (odd ? "on:" : "off:") + std::string(model.symbols[rest].name());
}

}  // namespace symplant::property
