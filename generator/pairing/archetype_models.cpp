// The models of archetypes, expressed as descriptions of devices.
#include <algorithm>
#include <string>
#include <utility>

#include "pairing/archetypes.hpp"

namespace symplant::pairing {
namespace {

using description::Duration;
using name::ArchetypeRole;

/// Describes one facet of an archetype.
class ModelWriter {
 public:
  ModelWriter(const name::Archetype& archetype, const RoleInputs& roles, std::span<const Input> inputs)
      : archetype_(archetype), roles_(roles), inputs_(inputs) {}

  Facet write() {
    base_.by_naming = true;
    base_.only = true;
    base_.actuation = tables::Actuation::latched;
    switch (archetype_.model) {
      case name::ArchetypeModel::mirror:
        mirror();
        break;
      case name::ArchetypeModel::handshake:
        handshake();
        break;
      case name::ArchetypeModel::two_position:
        two_position();
        break;
      case name::ArchetypeModel::contactor:
        contactor();
        break;
      case name::ArchetypeModel::constant:
        break;
    }
    base_.initial = facet_.states.front();
    facet_.first_is_rest = true;
    std::sort(facet_.members.begin(), facet_.members.end(),
              [](const Member& a, const Member& b) { return a.input < b.input; });
    facet_.base = std::make_shared<const description::DeviceDescription>(std::move(base_));
    return std::move(facet_);
  }

 private:
  void mirror() {
    states({"OFF", "ON"});
    operation(ArchetypeRole::operation, "ON");
    event(ArchetypeRole::event, archetype_.inverted ? "OFF" : "ON");
    const Duration delay = Duration::fixed(archetype_.delay);
    commanded("OFF", "ON", "ON", delay, Duration::fixed(0));
    automatic("ON", "OFF", "not " + symbol(ArchetypeRole::operation), delay);
    add_states();
  }

  void handshake() {
    states({"IDLE", "RUN", "DONE"});
    const bool start = operation(ArchetypeRole::start, "RUN");
    const bool ack = operation(ArchetypeRole::ack, "ACK");
    const bool reset = operation(ArchetypeRole::reset, "RESET");
    event(ArchetypeRole::busy, "RUN");
    event(ArchetypeRole::done, "DONE");
    // Without a start the work begins when a scenario or the user sets the state: no event comes on by itself.
    if (start) commanded("IDLE", "RUN", "RUN", Duration::fixed(0), Duration::fixed(0));
    automatic("RUN", "DONE", "", Duration::fixed(archetype_.takes));
    if (ack) acknowledge("DONE", ArchetypeRole::ack);
    if (reset) acknowledge("*", ArchetypeRole::reset);
    if (!ack && !reset) {
      automatic("DONE", "IDLE", "not " + symbol(ArchetypeRole::start), Duration::fixed(0));
    }
    add_states();
  }

  /// One position may have no operation: then a spring leads to it.
  void two_position() {
    states({"A", "B"});
    const bool to_a = operation(ArchetypeRole::a, "A");
    const bool to_b = operation(ArchetypeRole::b, "B");
    event(ArchetypeRole::at_a, "A");
    event(ArchetypeRole::at_b, "B");
    base_.actuation = to_a && to_b ? tables::Actuation::bistable : tables::Actuation::spring;
    if (!to_a || !to_b) base_.rest = to_a ? "B" : "A";
    commanded("A", "B", "", std::nullopt, Duration::fixed(archetype_.takes));
    commanded("B", "A", "", std::nullopt, Duration::fixed(archetype_.takes));
    add_states();
    if (!to_b) std::reverse(facet_.states.begin(), facet_.states.end());
  }

  void contactor() {
    states({"OFF", "ON"});
    operation(ArchetypeRole::on, "ON");
    event(ArchetypeRole::is_on, "ON");
    base_.actuation = tables::Actuation::spring;
    base_.rest = "OFF";
    commanded("OFF", "ON", "ON", Duration::fixed(0), Duration::fixed(archetype_.delay));
    commanded("ON", "OFF", "", std::nullopt, Duration::fixed(0));
    add_states();
  }

  std::uint32_t input(ArchetypeRole role) const { return roles_[static_cast<std::size_t>(role)]; }

  void states(std::vector<std::string> names) { facet_.states = std::move(names); }

  /// The task of a symbol; a symbol of two roles keeps that of the first.
  const std::string* task_of(std::uint32_t input) const {
    for (const Member& member : facet_.members) {
      if (member.input == input) return &member.task;
    }
    return nullptr;
  }

  bool operation(ArchetypeRole role, const std::string& task) {
    if (input(role) == kNone) return false;
    if (task_of(input(role)) == nullptr) facet_.members.push_back({input(role), task});
    return true;
  }

  void event(ArchetypeRole role, const std::string& state) {
    if (input(role) == kNone) return;
    const std::string* task = task_of(input(role));
    if (task == nullptr) {
      facet_.members.push_back({input(role), state});
    } else {
      base_.outputs.push_back({state, {{*task, true}}, {{*task, false}}});
    }
  }

  void commanded(std::string from, std::string to, std::string on, std::optional<Duration> after, Duration takes) {
    base_.transitions.push_back({std::move(from), std::move(to), std::move(on), {}, false, false, after, takes});
  }

  void automatic(std::string from, std::string to, std::string when, Duration after) {
    base_.transitions.push_back(
        {std::move(from), std::move(to), {}, std::move(when), true, false, after, Duration::fixed(0)});
  }

  /// Back to IDLE, once for each time that the operation comes on: it is often still on when the next run starts.
  void acknowledge(std::string from, ArchetypeRole role) {
    base_.transitions.push_back(
        {std::move(from), "IDLE", *task_of(input(role)), {}, false, true, Duration::fixed(0), Duration::fixed(0)});
  }

  std::string symbol(ArchetypeRole role) const {
    std::string quoted = "'";
    for (const char c : inputs_[input(role)].name) quoted.append(c == '\'' ? 2 : 1, c);
    return quoted + "'";
  }

  /// Gives the states that no symbol names.
  void add_states() {
    for (const std::string& state : facet_.states) {
      const bool named = std::any_of(facet_.members.begin(), facet_.members.end(),
                                     [&](const Member& member) { return member.task == state; });
      if (!named) base_.states.push_back(state);
    }
  }

  const name::Archetype& archetype_;
  const RoleInputs& roles_;
  std::span<const Input> inputs_;
  Facet facet_;
  description::DeviceDescription base_;
};

}  // namespace

bool is_operation_role(ArchetypeRole role) {
  switch (role) {
    case ArchetypeRole::operation:
    case ArchetypeRole::start:
    case ArchetypeRole::ack:
    case ArchetypeRole::reset:
    case ArchetypeRole::a:
    case ArchetypeRole::b:
    case ArchetypeRole::on:
      return true;
    case ArchetypeRole::event:
    case ArchetypeRole::busy:
    case ArchetypeRole::done:
    case ArchetypeRole::at_a:
    case ArchetypeRole::at_b:
    case ArchetypeRole::is_on:
      return false;
  }
  return false;
}

Facet archetype_facet(const name::Archetype& archetype, const RoleInputs& roles, std::span<const Input> inputs) {
  return ModelWriter(archetype, roles, inputs).write();
}

}  // namespace symplant::pairing
