// A plant of the engine, from a list's names and a description, used by names.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/compile.hpp"
#include "symplant/plant/owned_plant.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::test {

inline constexpr tables::Time kMs = tables::kMillisecond;

/// A plant description, device by device.
struct Reported {
  description::Description description = {};

  description::DeviceDescription& device(const std::string& name) {
    for (description::DeviceDescription& device : description.devices) {
      if (device.path == "L_P_" + name) return device;
    }
    description.devices.emplace_back().path = "L_P_" + name;
    return description.devices.back();
  }
  /// An automatic transition; `takes` is 0.
  Reported& by_itself(const std::string& device_name, std::string from, std::string to, description::Duration after,
                      std::string when = "") {
    description::GivenTransition given;
    given.from = std::move(from);
    given.to = std::move(to);
    given.when = std::move(when);
    given.automatic = true;
    given.after = after;
    given.takes = description::Duration::fixed(0);
    device(device_name).transitions.push_back(std::move(given));
    return *this;
  }
  /// A commanded transition, by the operation of its target.
  Reported& on_command(const std::string& device_name, std::string from, std::string to, description::Duration takes) {
    description::GivenTransition given;
    given.from = std::move(from);
    given.to = std::move(to);
    given.takes = takes;
    device(device_name).transitions.push_back(std::move(given));
    return *this;
  }
  Reported& disables(const std::string& device_name, std::string state, const std::string& other) {
    device(device_name).disables.push_back({std::move(state), {"L_P_" + other}});
    return *this;
  }
};

inline description::Duration fixed(tables::Time time) { return description::Duration::fixed(time); }

/// Tables for plants, and the indexes of their names. Names omit `L_P_`, the line and process
/// that all names share.
class BenchTables {
 public:
  explicit BenchTables(const std::vector<std::string>& names, const Reported& reported = {})
      : BenchTables(reported, bits(prefixed(names))) {}
  BenchTables(const Reported& reported, const std::vector<Row>& list)
      : text_(compile_described(list, reported.description)) {
    REQUIRE(text_.compiled);
    rows = text_.tables().tables();
  }
  BenchTables(const BenchTables&) = delete;
  BenchTables& operator=(const BenchTables&) = delete;

  const model::PlantModel& model() const { return text_.plant(); }

  std::uint32_t symbol(const std::string& name) const {
    for (std::uint32_t i = 0; i < model().symbols.size(); ++i) {
      if (model().symbols[i].name() == "L_P_" + name || model().symbols[i].name() == name) return i;
    }
    FAIL("no symbol " << name);
    return 0;
  }
  std::uint32_t unit_index(const std::string& device) const {
    for (std::uint32_t i = 0; i < model().units.size(); ++i) {
      if (model().units[i].path == "L_P_" + device) return i;
    }
    FAIL("no device " << device);
    return 0;
  }
  std::uint8_t state_index(const std::string& device, const std::string& state) const {
    const auto& states = model().units[unit_index(device)].states;
    for (std::uint8_t i = 0; i < states.size(); ++i) {
      if (states[i].name == state) return i;
    }
    FAIL("no state " << state);
    return 0;
  }
  std::string symbol_name(std::uint32_t symbol) const {
    const std::string name(model().symbols[symbol].name());
    return name.starts_with("L_P_") ? name.substr(4) : name;
  }
  /// The number of a malfunction of the description, or of an ordinary one, by its whole name.
  std::uint32_t malfunction(const std::string& name) const {
    const trace::PlantNames names(rows);
    const auto count =
        static_cast<std::uint32_t>(model().malfunctions.size() + 2 * (model().units.size() + model().symbols.size()));
    for (std::uint32_t number = 0; number < count; ++number) {
      if (names.malfunction(number) == name) return number;
    }
    FAIL("no malfunction " << name);
    return 0;
  }
  std::string unit_name(std::uint32_t unit) const { return std::string(model().units[unit].path.substr(4)); }
  /// "lost AGV_O_P2"; a `+` at the end if the next finding belongs to it.
  std::string words(const tables::Finding& finding) const {
    static const std::vector<std::string> kKinds = {"conflicting", "stopped", "disabled", "ineffective", "overrun",
                                                    "lost",        "started", "short",    "loop",        "violated"};
    const std::string& kind = kKinds[static_cast<std::size_t>(finding.kind)];
    const std::size_t units = model().units.size();
    std::string of;
    if (finding.kind == tables::FindingKind::requirement_violated) {
      of = model().requirements[finding.of].name;
    } else if (trace::is_of_symbol(finding.kind)) {
      of = symbol_name(finding.of);
    } else if (finding.of >= tables::first_malfunction_of_loop(rows)) {
      of = model().malfunctions[finding.of - tables::first_malfunction_of_loop(rows)].name;
    } else {
      of = finding.of < units ? unit_name(finding.of) : symbol_name(model().follows[finding.of - units].symbol);
    }
    return kind + " " + of + (finding.more ? "+" : "");
  }

  tables::PlantTables rows{};

 private:
  static std::vector<std::string> prefixed(std::vector<std::string> names) {
    for (std::string& name : names) name.insert(0, "L_P_");
    return names;
  }

  CompiledText text_;
};

/// One plant of such tables, with a record of its reports. Times are in ms.
class BenchPlant final : private engine::Observer {
 public:
  explicit BenchPlant(const BenchTables& tables) : tables_(tables), plant(tables.rows) {}

  BenchPlant& set(const std::string& name, std::uint64_t value) {
    const tables::SymbolRow& row = tables_.rows.symbols[tables_.symbol(name)];
    if (row.type() == tables::DataType::boolean) {
      plant.set_operation(row.index, value != 0);
    } else {
      plant.set_operation_value(row.index, value);
    }
    return *this;
  }
  bool input(const std::string& name, std::uint64_t value) { return plant.set_input(tables_.symbol(name), value); }
  BenchPlant& force(const std::string& name, std::uint64_t value) {
    plant.force(tables_.symbol(name), value);
    return *this;
  }
  BenchPlant& release(const std::string& name) {
    plant.release(tables_.symbol(name));
    return *this;
  }
  bool forced(const std::string& name) const { return plant.is_forced(tables_.symbol(name)); }
  BenchPlant& put(const std::string& device, const std::string& state) {
    plant.set_state(tables_.unit_index(device), tables_.state_index(device, state));
    return *this;
  }
  BenchPlant& start(const std::string& malfunction) {
    CHECK(plant.start_malfunction(tables_.malfunction(malfunction)));
    return *this;
  }
  BenchPlant& stop(const std::string& malfunction) {
    CHECK(plant.stop_malfunction(tables_.malfunction(malfunction)));
    return *this;
  }
  BenchPlant& to(tables::Time milliseconds) {
    plant.advance_to(milliseconds * kMs, this);
    return *this;
  }
  BenchPlant& before(tables::Time milliseconds) {
    plant.advance_before(milliseconds * kMs, this);
    return *this;
  }

  std::uint64_t value(const std::string& name) const {
    const tables::SymbolRow& row = tables_.rows.symbols[tables_.symbol(name)];
    const bool operation = row.direction() == tables::Direction::operation;
    if (row.type() == tables::DataType::boolean) {
      return (operation ? plant.operation(row.index) : plant.event(row.index)) ? 1 : 0;
    }
    return operation ? plant.operation_value(row.index) : plant.event_value(row.index);
  }
  bool on(const std::string& name) const { return value(name) != 0; }
  bool disarmed(const std::string& name) const {
    const std::uint32_t bit = tables_.rows.symbols[tables_.symbol(name)].index;
    return (plant.disarmed()[bit / 64] >> (bit % 64) & 1) != 0;
  }
  plant::UnitView unit(const std::string& device) const { return plant.unit(tables_.unit_index(device)); }
  /// "A", "A->B", "A->B!" if it stopped; in brackets while it is disabled; with a `#` if it is frozen.
  std::string state(const std::string& device) const {
    const auto& states = tables_.model().units[tables_.unit_index(device)].states;
    const plant::UnitView view = unit(device);
    std::string text = states[view.state].name;
    if (view.moving) text += "->" + states[view.target].name;
    if (view.stopped_midway) text += "!";
    if (view.frozen) text += "#";
    return view.disabled ? "[" + text + "]" : text;
  }

  /// Changes of BOOL symbols that the observer received since the last call, "500:AGV_O_P2=1 ...", by instant, then
  /// in list order.
  std::string changes() { return std::exchange(changes_, {}); }
  /// Malfunctions that started and ended, "500:+blind hand ...".
  std::string malfunctions() { return std::exchange(malfunctions_, {}); }
  /// Findings in the same format, "500:lost AGV_O_P2 ...".
  std::string reported() { return std::exchange(reported_, {}); }
  /// Findings from the ring, in the same format.
  std::string findings() {
    std::string text;
    tables::Finding finding{};
    while (plant.take_finding(finding)) add(text, finding.time, tables_.words(finding));
    return text;
  }

 private:
  static void add(std::string& text, tables::Time time, const std::string& more) {
    text += (text.empty() ? "" : " ") + std::to_string(time / kMs) + ":" + more;
  }
  static bool holds(std::span<const engine::WordChange> changes, std::uint32_t bit) {
    for (const engine::WordChange& change : changes) {
      if (change.word == bit / 64 && (change.bits >> (bit % 64) & 1) != 0) return true;
    }
    return false;
  }
  void instant(const engine::Instant& instant) noexcept override {
    for (std::uint32_t i = 0; i < tables_.rows.symbols.size(); ++i) {
      const tables::SymbolRow& row = tables_.rows.symbols[i];
      if (row.type() != tables::DataType::boolean) continue;
      const bool operation = row.direction() == tables::Direction::operation;
      if (!holds(operation ? instant.operations : instant.events, row.index)) continue;
      const bool on = operation ? plant.operation(row.index) : plant.event(row.index);
      add(changes_, instant.time, tables_.symbol_name(i) + (on ? "=1" : "=0"));
    }
    static const std::vector<std::string> kBy = {"scenario", "hand", "condition", "chance", "becomes", "end"};
    const trace::PlantNames names(tables_.rows);
    for (const engine::MalfunctionChange& change : instant.malfunctions) {
      add(malfunctions_, instant.time,
          (change.active ? "+" : "-") + names.malfunction(change.malfunction) + " " +
              kBy[static_cast<std::size_t>(change.by)]);
    }
  }
  void finding(const tables::Finding& finding) noexcept override {
    add(reported_, finding.time, tables_.words(finding));
  }

  const BenchTables& tables_;
  std::string changes_;
  std::string reported_;
  std::string malfunctions_;

 public:
  plant::OwnedPlant plant;
};

}  // namespace symplant::test
