// Compares what engine and reference show, field by field.
#include "property/differences.hpp"

#include <algorithm>
#include <span>
#include <string_view>

#include "property/malfunction_names.hpp"
#include "property/part_differences.hpp"
#include "property/value_differences.hpp"
#include "support/reference/lines.hpp"

namespace symplant::property {
namespace {

std::string loop_member(std::uint32_t of, const model::PlantModel& plant) {
  const std::size_t follow = of - plant.units.size();
  if (follow < plant.follows.size()) return std::string(plant.symbols[plant.follows[follow].symbol].name());
  return "#" + std::to_string(follow - plant.follows.size()) + " of material and malfunctions";
}

std::string reported_as(const tables::Finding& finding, const model::PlantModel& plant) {
  using Of = tables::FindingKind;
  std::string text(reference::finding_name(finding.kind));
  if (finding.more) text += "+";
  text += " of ";
  const bool unit = finding.kind == Of::conflicting_operations || finding.kind == Of::stopped_under_another_command ||
                    finding.kind == Of::overrun || finding.kind == Of::started_on_enabling ||
                    finding.kind == Of::instantaneous_loop;
  const std::size_t most = unit                                       ? plant.units.size()
                           : finding.kind == Of::requirement_violated ? plant.requirements.size()
                           : finding.kind == Of::part_blocked         ? plant.material.transfers.size()
                           : finding.kind == Of::value_not_finite     ? plant.values.size()
                                                                      : plant.symbols.size();
  if (finding.kind == Of::instantaneous_loop && finding.of >= most) return text + loop_member(finding.of, plant);
  if (finding.of >= most) return text + "nothing (" + std::to_string(finding.of) + ")";
  if (unit) return text.append(plant.units[finding.of].path);
  if (finding.kind == Of::requirement_violated) return text + plant.requirements[finding.of].name;
  if (finding.kind == Of::part_blocked) return text + plant.material.transfers[finding.of].name;
  if (finding.kind == Of::value_not_finite) return text + plant.values[finding.of].name;
  return text.append(plant.symbols[finding.of].name());
}

std::string reported_as(const reference::InstantRecord& record, const model::PlantModel& plant) {
  std::string text = "t=" + std::to_string(record.time);
  for (const auto& [symbol, value] : record.changes) {
    text.append(" ").append(plant.symbols[symbol].name()).append("=").append(std::to_string(value));
  }
  for (const tables::Finding& finding : record.findings) {
    text += " {" + reported_as(finding, plant) + (finding.time == record.time ? "" : " at another time") + "}";
  }
  for (const std::string& part : part_texts(record, plant)) text += " [" + part + "]";
  for (const engine::MalfunctionChange& change : record.malfunctions) {
    text += " <" + malfunction_text(plant, change.malfunction) + (change.active ? " starts by " : " ends by ") +
            std::to_string(static_cast<int>(change.by)) + ">";
  }
  for (const auto& [name, number] : record.values) text += " " + name + " is " + number_text(number);
  return text;
}

std::string reported_as(const reference::UnitView& view, const model::Unit& unit) {
  const auto name = [&](std::uint8_t state) {
    return state < unit.states.size() ? unit.states[state].name : "#" + std::to_string(state);
  };
  std::string text = name(view.state);
  if (view.moving) text += "->" + name(view.target) + " remaining " + std::to_string(view.remaining);
  if (view.stopped_midway) text += " standing";
  if (view.disabled) text += " disabled";
  if (view.frozen) text += " frozen";
  return text;
}

reference::UnitView as_reference(const plant::UnitView& view) {
  return {view.state, view.target, view.moving, view.stopped_midway, view.disabled, view.frozen, view.remaining};
}

std::string both(std::string_view what, const std::string& engine, const std::string& reference) {
  return std::string(what) + "\n  engine:    " + engine + "\n  reference: " + reference;
}

std::string units_difference(const plant::Plant& engine, const reference::Plant& reference,
                             const model::PlantModel& plant) {
  for (std::uint32_t i = 0; i < plant.units.size(); ++i) {
    const plant::UnitView seen = engine.unit(i);
    const reference::UnitView view = as_reference(seen);
    if (view != reference.unit(i)) {
      return both("unit " + std::string(plant.units[i].path), reported_as(view, plant.units[i]),
                  reported_as(reference.unit(i), plant.units[i]));
    }
    const bool in_order = seen.progress >= 0 && seen.progress <= 1 && (seen.moving || seen.progress == 0);
    if (!in_order) return "progress of " + std::string(plant.units[i].path) + " is " + std::to_string(seen.progress);
  }
  return {};
}

std::string symbols_difference(const EnginePlant& engine, const reference::Plant& reference,
                               const model::PlantModel& plant) {
  const std::span<const std::uint64_t> disarmed = engine.plant().disarmed();
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const std::string name(plant.symbols[i].name());
    if (engine.value(i) != reference.value(i)) {
      return both("value of " + name, std::to_string(engine.value(i)), std::to_string(reference.value(i)));
    }
    if (engine.plant().is_forced(i) != reference.is_forced(i)) return "is_forced of " + name;
    const tables::SymbolRow& row = engine.plant().tables().symbols[i];
    if (row.direction() != tables::Direction::operation || row.type() != tables::DataType::boolean) continue;
    const bool off = ((disarmed[row.index / 64] >> (row.index % 64)) & 1) != 0;
    if (off != reference.disarmed(i)) {
      return both("disarmed " + name, off ? "yes" : "no", off ? "no" : "yes");
    }
  }
  return {};
}

std::string active_text(std::uint32_t number, tables::Time since, const model::PlantModel& plant) {
  return malfunction_text(plant, number) + " since " + std::to_string(since) + " ";
}

std::string malfunctions_difference(const plant::Plant& engine, const reference::Plant& reference,
                                    const model::PlantModel& plant) {
  const reference::MalfunctionsWorld& world = reference.save().malfunctions;
  std::string here;
  for (const engine::ActiveMalfunction& active : engine.active_malfunctions()) {
    here += active_text(active.number, active.since, plant);
    if (!engine.malfunction(active.number).active) return "an active malfunction is not";
  }
  std::string there;
  for (const reference::ActiveWorld& active : world.active) there += active_text(active.number, active.since, plant);
  if (here != there) return both("active malfunctions", here, there);
  for (std::uint32_t i = 0; i < world.written.size(); ++i) {
    const plant::MalfunctionView view = engine.malfunction(i);
    if (view.active == world.written[i].active && view.next_due == world.written[i].next_due()) continue;
    return both("next_due of " + plant.malfunctions[i].name, std::to_string(view.next_due),
                std::to_string(world.written[i].next_due()));
  }
  for (std::uint32_t i = 0; i < plant.units.size(); ++i) {
    if (engine.is_stuck(i) != reference.is_stuck(i)) return "is_stuck of " + std::string(plant.units[i].path);
  }
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const std::uint32_t one = engine.malfunction_of_symbol(i);
    const std::uint32_t other = reference.malfunction_of_symbol(i);
    if (one != other) return both("malfunction of a symbol", std::to_string(one), std::to_string(other));
  }
  return {};
}

}  // namespace

std::string instants_difference(const EnginePlant& engine, const reference::Plant& reference,
                                const model::PlantModel& plant) {
  if (!engine.fault().empty()) return engine.fault();
  const auto& reported = engine.instants();
  const auto& wanted = reference.instants();
  for (std::size_t i = 0; i < std::max(reported.size(), wanted.size()); ++i) {
    const std::string engine_text = i < reported.size() ? reported_as(reported[i], plant) : "nothing";
    const std::string reference_text = i < wanted.size() ? reported_as(wanted[i], plant) : "nothing";
    if (engine_text != reference_text) return both("instant", engine_text, reference_text);
  }
  return {};
}

std::string next_due_difference(plant::Plant& engine, const reference::Plant& reference) {
  const tables::Time due = engine.next_due();
  if (due == reference.next_due()) return {};
  // Parts may cause more instants than needed.
  if (!engine.tables().material.empty() && due >= reference.now() && due < reference.next_due()) return {};
  // A step that would change nothing may be skipped, but no other instant.
  const bool values = !engine.tables().values.rows.empty() || !engine.tables().values.signals.empty();
  if (values && due >= reference.now() && due <= reference.next_due(false)) return {};
  return both("next_due at " + std::to_string(reference.now()), std::to_string(due),
              std::to_string(reference.next_due()));
}

std::string state_difference(EnginePlant& engine, const reference::Plant& reference, const model::PlantModel& plant) {
  plant::Plant& it = engine.plant();
  if (it.now() != reference.now()) return both("now", std::to_string(it.now()), std::to_string(reference.now()));
  std::string text = units_difference(it, reference, plant);
  if (text.empty()) text = symbols_difference(engine, reference, plant);
  if (text.empty()) text = parts_difference(it, reference, plant);
  if (text.empty()) text = malfunctions_difference(it, reference, plant);
  if (text.empty()) text = values_difference(it, reference, plant);
  if (text.empty()) text = next_due_difference(it, reference);
  if (text.empty() && it.state_hash() != reference.state_hash()) text = "state_hash";
  return text;
}

std::string twin_difference(EnginePlant& engine, EnginePlant& twin) {
  plant::Plant& one = engine.plant();
  plant::Plant& other = twin.plant();
  const auto sorted = [](std::span<const std::uint32_t> indexes) {
    std::vector<std::uint32_t> result(indexes.begin(), indexes.end());
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto findings_of = [](plant::Plant& plant) {
    std::vector<tables::Finding> findings;
    for (tables::Finding finding{}; plant.take_finding(finding);) findings.push_back(finding);
    return findings;
  };
  const auto same = [](auto a, auto b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); };
  if (one.now() != other.now()) return "now without an observer";
  if (!same(one.operations(), other.operations())) return "operations() without an observer";
  if (!same(one.events(), other.events())) return "events() without an observer";
  if (!same(one.disarmed(), other.disarmed())) return "disarmed() without an observer";
  if (sorted(one.changed_events()) != sorted(other.changed_events())) return "changed_events() without an observer";
  if (sorted(one.changed_event_values()) != sorted(other.changed_event_values())) {
    return "changed_event_values() without an observer";
  }
  if (findings_of(one) != findings_of(other)) return "findings without an observer";
  if (one.lost_findings() != other.lost_findings()) return "lost_findings() without an observer";
  if (one.next_due() != other.next_due()) return "next_due without an observer";
  if (one.state_hash() != other.state_hash()) return "state_hash without an observer";
  return {};
}

Shadow::Shadow(const EnginePlant& engine, const model::PlantModel& plant) : plant_(plant) {
  for (std::uint32_t i = 0; i < plant.units.size(); ++i) units_.push_back(engine.plant().unit(i));
  const auto events = engine.plant().events();
  events_.assign(events.begin(), events.end());
  for (std::uint32_t i = 0; i < engine.plant().tables().event_slots; ++i) {
    values_.push_back(engine.plant().event_value(i));
  }
}

std::string Shadow::difference(const EnginePlant& engine) const {
  const plant::Plant& now = engine.plant();
  for (std::uint32_t i = 0; i < units_.size(); ++i) {
    reference::UnitView old = as_reference(units_[i]);
    reference::UnitView view = as_reference(now.unit(i));
    old.remaining = view.remaining = 0;  // changes with time alone
    if (old != view && !engine.units_reported()[i]) {
      return both("unit not reported: " + std::string(plant_.units[i].path), reported_as(view, plant_.units[i]),
                  reported_as(old, plant_.units[i]) + " before");
    }
  }
  const auto reported = [](std::span<const std::uint32_t> indexes, std::uint32_t position) {
    return std::count(indexes.begin(), indexes.end(), position) == 1;
  };
  for (std::uint32_t i = 0; i < events_.size(); ++i) {
    if (now.events()[i] != events_[i] && !reported(now.changed_events(), i)) return "changed_events()";
  }
  for (std::uint32_t i = 0; i < values_.size(); ++i) {
    if (now.event_value(i) != values_[i] && !reported(now.changed_event_values(), i)) return "changed_event_values()";
  }
  return {};
}

}  // namespace symplant::property
