// What the names in formulas mean.
#include <algorithm>
#include <stdexcept>

#include "support/reference/material.hpp"
#include "support/reference/values.hpp"

namespace symplant::reference {
namespace {

std::string joined_by_dots(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ".") + name;
  return text;
}

std::optional<Input> value_input(const Rules& rules, const DottedName& name) {
  const std::uint32_t value = find_value(rules, joined_by_dots(name.names));
  if (value == kNone) return {};
  const std::size_t outputs = rules.values[value].outputs;
  if (outputs == 1 && name.index == 0) return Input{Input::Kind::output, value, 0};
  if (outputs == 1 || name.index == 0 || name.index > outputs) return {};
  return Input{Input::Kind::output, value, name.index - 1};
}

std::optional<Input> symbol_input(const Rules& rules, const std::string& name) {
  for (std::uint32_t i = 0; i < rules.model->symbols.size(); ++i) {
    if (!same_name(rules.model->symbols[i].name(), name)) continue;
    return Input{rules.is_bool(i) ? Input::Kind::bit : Input::Kind::number, i, 0};
  }
  return {};
}

std::optional<Input> location_input(const Rules& rules, const std::string& name, const std::string& what) {
  const model::Material& material = rules.model->material;
  for (std::uint32_t i = 0; i < material.locations(); ++i) {
    if (!same_name(material.location_name(i), name)) continue;
    if (same_name(what, "part") || same_name(what, "parts")) return Input{Input::Kind::parts, i, kNone};
    if (same_name(what, "weight")) return Input{Input::Kind::weight, i, 0};
    for (std::uint32_t kind = 0; kind < material.kinds.size(); ++kind) {
      if (same_name(material.kinds[kind].name, what)) return Input{Input::Kind::parts, i, kind};
    }
  }
  return {};
}

/// The unit with this name, then the facets of the device with this name.
std::vector<std::uint32_t> units_named(const Rules& rules, const std::string& name) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < rules.units.size(); ++i) {
    if (same_name(rules.units[i].path, name)) found.push_back(i);
  }
  for (std::uint32_t i = 0; i < rules.units.size(); ++i) {
    const pairing::Facet* facet = rules.model->units[i].facet;
    if (facet != nullptr && !facet->name.empty() && same_name(facet->path, name)) found.push_back(i);
  }
  return found;
}

std::optional<Input> unit_input(const Rules& rules, const std::string& name, const std::string& what) {
  const std::vector<std::uint32_t> units = units_named(rules, name);
  for (const std::uint32_t unit : units) {
    const std::uint32_t state = find_state(rules.units[unit], what);
    if (state != kNone) return Input{Input::Kind::settled, unit, state};
  }
  if (units.empty() || !same_name(what, "moving")) return {};
  return Input{Input::Kind::moving, units.front(), 0};
}

}  // namespace

std::uint32_t find_value(const Rules& rules, const std::string& name) {
  for (std::uint32_t i = 0; i < rules.values.size(); ++i) {
    if (same_name(rules.values[i].name, name)) return i;
  }
  return kNone;
}

Input output_at(const Rules& rules, std::uint32_t number) {
  std::uint32_t value = 0;
  while (number >= rules.values[value].outputs) {
    number -= static_cast<std::uint32_t>(rules.values[value].outputs);
    ++value;
  }
  return {Input::Kind::output, value, number};
}

Input resolve_name(const Rules& rules, const DottedName& name) {
  std::optional<Input> found = value_input(rules, name);
  const std::size_t names = name.names.size();
  const std::string& last = name.names.back();
  if (!found && name.index == 0 && names == 1) found = symbol_input(rules, last);
  if (!found && name.index == 0 && names > 1) {
    const std::string rest = joined_by_dots({name.names.begin(), name.names.end() - 1});
    found = names == 2 ? location_input(rules, rest, last) : std::nullopt;
    if (!found) found = unit_input(rules, rest, last);
  }
  if (!found) throw std::runtime_error("`" + joined_by_dots(name.names) + "` not found");
  return *found;
}

void resolve(const Rules& rules, Formula& formula) {
  if (formula.kind == Formula::Kind::input) formula.input = resolve_name(rules, formula.name);
  for (Formula& child : formula.children) resolve(rules, child);
}

void resolve(const Rules& rules, CompareTree& tree) {
  for (CompareOperand* operand : {&tree.left, &tree.right}) {
    if (operand->name) operand->input = resolve_name(rules, *operand->name);
  }
  for (CompareTree& child : tree.children) resolve(rules, child);
}

std::string replace_braces(const std::string& text, const std::vector<std::string>& levels,
                           const std::vector<std::string>& shares) {
  static const std::vector<std::string> kLevels = {"line", "process", "device", "self"};
  std::string replaced = text;
  const auto replace = [&](const std::string& word, const std::string& by) {
    const std::string braces = "{" + word + "}";
    for (std::size_t at = replaced.find(braces); at != std::string::npos; at = replaced.find(braces, at + by.size())) {
      replaced.replace(at, braces.size(), by);
    }
  };
  for (std::size_t i = 0; i < kLevels.size(); ++i) replace(kLevels[i], levels[i]);
  for (std::size_t i = 0; i < shares.size(); ++i) replace(std::to_string(i + 1), shares[i]);
  return replaced;
}

}  // namespace symplant::reference
