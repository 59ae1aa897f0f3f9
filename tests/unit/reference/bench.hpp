// A plant of the reference, from rows and a description, by names.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/compile.hpp"
#include "support/reference/reference.hpp"

namespace symplant::test {

inline constexpr tables::Time kMs = tables::kMillisecond;

/// The description of one device, without everything else.
struct Said {
  description::Description description = {};

  description::DeviceDescription& device(const std::string& path) {
    for (description::DeviceDescription& device : description.devices) {
      if (device.path == path) return device;
    }
    description.devices.emplace_back().path = path;
    return description.devices.back();
  }
};

inline description::GivenTransition transition(std::string from, std::string to, std::string on = "") {
  description::GivenTransition given;
  given.from = std::move(from);
  given.to = std::move(to);
  given.on = std::move(on);
  return given;
}

inline description::GivenTransition automatic(std::string from, std::string to, tables::Time after = 0,
                                              std::string when = "") {
  description::GivenTransition given = transition(std::move(from), std::move(to));
  given.automatic = true;
  given.after = description::Duration::fixed(after);
  given.when = std::move(when);
  return given;
}

/// Names as for bits(), without the line and process that all of them share.
class Bench {
 public:
  explicit Bench(const std::vector<std::string>& names, const Said& said = {},
                 std::map<std::string, reference::Behaviour> behaviours = {})
      : Bench(said, bits(prefixed(names)), std::move(behaviours)) {}
  Bench(const Said& said, const std::vector<Row>& rows, std::map<std::string, reference::Behaviour> behaviours = {})
      : analysed(analyse_described(rows, said.description)), plant(analysed.model(), std::move(behaviours)) {
    for (const description::DescriptionFault& fault : analysed.evidence().faults) FAIL(fault.message);
    REQUIRE(plant.difference_from_model() == "");
  }

  std::uint32_t symbol(const std::string& name) const {
    for (std::uint32_t i = 0; i < analysed.model().symbols.size(); ++i) {
      if (analysed.model().symbols[i].name() == "L_P_" + name) return i;
    }
    FAIL("no symbol " << name);
    return 0;
  }
  std::uint32_t index(const std::string& device) const {
    for (std::uint32_t i = 0; i < analysed.model().units.size(); ++i) {
      if (analysed.model().units[i].path == "L_P_" + device) return i;
    }
    FAIL("no device " << device);
    return 0;
  }
  std::uint8_t state_index(const std::string& device, const std::string& state) const {
    const auto& states = analysed.model().units[index(device)].states;
    for (std::uint8_t i = 0; i < states.size(); ++i) {
      if (states[i].name == state) return i;
    }
    FAIL("no state " << state);
    return 0;
  }

  Bench& set(const std::string& name, bool on) {
    plant.set_operation(symbol(name), on ? 1 : 0);
    return *this;
  }
  Bench& put(const std::string& device, const std::string& state) {
    plant.set_state(index(device), state_index(device, state));
    return *this;
  }
  Bench& at(tables::Time milliseconds) {
    plant.advance_to(milliseconds * kMs);
    return *this;
  }

  bool on(const std::string& name) const { return plant.value(symbol(name)) != 0; }
  /// "A", "A->B", "A->B!" if it stopped; in brackets while it is disabled.
  std::string state(const std::string& device) const {
    const auto& unit = analysed.model().units[index(device)];
    const reference::UnitView view = plant.unit(index(device));
    std::string text = unit.states[view.state].name;
    if (view.moving) text += "->" + unit.states[view.target].name;
    if (view.stopped_midway) text += "!";
    return view.disabled ? "[" + text + "]" : text;
  }
  tables::Time remaining(const std::string& device) const { return plant.unit(index(device)).remaining / kMs; }

  /// All changes since the last call, "500:AGV_O_P2=1 ...".
  std::string changes() {
    std::string text;
    for (const reference::InstantRecord& instant : plant.instants()) {
      for (const auto& [symbol, value] : instant.changes) {
        const std::string name(analysed.model().symbols[symbol].name().substr(4));
        add(text, std::to_string(instant.time / kMs) + ":" + name + "=" + std::to_string(value));
      }
    }
    plant.clear_instants();
    return text;
  }
  /// All findings since the last call, "500:lost AGV_O_P2 ...".
  std::string findings() {
    std::string text;
    for (const reference::InstantRecord& instant : plant.instants()) {
      for (const tables::Finding& finding : instant.findings) {
        add(text, std::to_string(instant.time / kMs) + ":" + words(finding));
      }
    }
    plant.clear_instants();
    return text;
  }

  Analysed analysed;
  reference::Plant plant;

 private:
  static std::vector<std::string> prefixed(std::vector<std::string> names) {
    for (std::string& name : names) name.insert(0, "L_P_");
    return names;
  }
  static void add(std::string& text, const std::string& more) { text += (text.empty() ? "" : " ") + more; }

  std::string words(const tables::Finding& finding) const {
    using Kind = tables::FindingKind;
    static const std::vector<std::string> kKinds = {"conflicting", "stopped",  "disabled", "ineffective",
                                                    "overrun",     "lost",     "started",  "short",
                                                    "loop",        "violated", "blocked"};
    const model::PlantModel& model = analysed.model();
    const auto symbol = [&](std::uint32_t index) { return std::string(model.symbols[index].name().substr(4)); };
    std::string of;
    switch (finding.kind) {
      case Kind::requirement_violated:
      case Kind::part_blocked:
        of = std::to_string(finding.of);
        break;
      case Kind::command_to_a_disabled_unit:
      case Kind::command_without_effect:
      case Kind::lost_command:
      case Kind::event_too_short:
        of = symbol(finding.of);
        break;
      default:
        of = finding.of < model.units.size() ? std::string(model.units[finding.of].path.substr(4))
                                             : symbol(model.follows[finding.of - model.units.size()].symbol);
    }
    return kKinds[static_cast<std::size_t>(finding.kind)] + " " + of + (finding.more ? "+" : "");
  }
};

}  // namespace symplant::test
