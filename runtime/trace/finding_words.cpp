// The texts of run-time findings.
#include "symplant/trace/finding_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "symplant/link/client_refusal.hpp"
#include "symplant/tables/level.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/tables/refusal.hpp"
#include "symplant/trace/influences.hpp"
#include "symplant/trace/requirement_units.hpp"
#include "symplant/trace/server_words.hpp"

namespace symplant::trace {
namespace {

using tables::FindingKind;

constexpr std::array<std::string_view, tables::kAllFindingKinds> kNames = {"conflicting operations",
                                                                           "stopped under another command",
                                                                           "command to a disabled unit",
                                                                           "command without effect",
                                                                           "overrun",
                                                                           "lost command",
                                                                           "started on enabling",
                                                                           "event too short",
                                                                           "instantaneous loop",
                                                                           "requirement violated",
                                                                           "part blocked",
                                                                           "value not finite",
                                                                           "link lost",
                                                                           "link back",
                                                                           "event overwritten",
                                                                           "clock restarted",
                                                                           "standstill",
                                                                           "no PLC",
                                                                           "request refused",
                                                                           "not read",
                                                                           "not sampled",
                                                                           "several writers",
                                                                           "symbol left out"};

constexpr std::size_t kOperationsShown = 4;

/// "on" means that an operation commands.
std::string_view level_words(std::uint32_t symbol, bool on, const PlantNames& names) {
  return tables::level_text(on, names.tables().symbols[symbol].inverted());
}

/// The last operations of a unit with their times: `; operations: Y0001 (P2 of L_P_AGV) on since 0.5 s`.
std::string led(std::uint32_t unit, const PlantNames& names, const History& history) {
  std::string text;
  for (const std::uint32_t symbol : history.last_operations(unit, kOperationsShown)) {
    text += fmt::format("{}{} ({}{} of {}) {} ", text.empty() ? "" : ", ", address_or_name(symbol, names),
                        names.tables().symbols[symbol].inverted() ? "inverted, " : "", names.task(symbol),
                        names.unit(unit), level_words(symbol, true, names));
    text += history.commands(symbol)
                ? "since " + seconds(history.rose(symbol)) + written_words(symbol, history.rose(symbol), names)
                : fmt::format("at {}, {} since {}", seconds(history.rose(symbol)), level_words(symbol, false, names),
                              seconds(history.since(symbol)));
  }
  return text.empty() ? ", none of its operations has been on" : "; operations: " + text;
}

std::string of_unit(const FoundThing& found, const PlantNames& names, const History& history) {
  const std::uint32_t unit = found.of.front();
  const std::string name(names.unit(unit));
  const std::string state = state_words(unit, names, history.unit(unit));
  const std::string operations = led(unit, names, history);
  const Influences influences = Influences(names, history).slowing(unit).forcing_symbols_of(unit);
  switch (found.kind) {
    case FindingKind::conflicting_operations:
      return fmt::format(
          "conflicting operations: {} ({}) has commands to several states at once and obeys none of them{}; {}", name,
          state, operations, influences.advice("for a missing interlock between these outputs"));
    case FindingKind::stopped_under_another_command:
      return fmt::format(
          "stopped under another command: {} ({}) has stopped, since its own command is off while another one is on{}; "
          "{}",
          name, state, operations, influences.advice("why the output went off before it arrived"));
    case FindingKind::overrun:
      return fmt::format(
          "overrun: {} ({}) is still commanded to the state that it has reached, so its motor runs against the end{}; "
          "{}",
          name, state, operations, influences.advice("whether the end position switches the output off"));
    default:
      return fmt::format("started on enabling: {} ({}) started to move as soon as it was no longer disabled{}; {}",
                         name, state, operations,
                         influences.advice("whether the command should have been switched off before"));
  }
}

/// "command to a disabled unit: ...". No interlock is missing if only malfunctions disable the unit.
std::string of_disabled(std::uint32_t symbol, const PlantNames& names, const History& history) {
  const std::uint32_t unit = names.tables().symbols[symbol].unit;
  Influences influences(names, history);
  std::string by;
  for (const tables::DisableRow& row : names.tables().disables) {
    const plant::UnitView other = history.unit(row.by);
    if (row.unit != unit || other.moving || other.state != row.state) continue;
    by += fmt::format("{}{} in {}", by.empty() ? "" : ", ", names.unit(row.by), names.state(row.by, row.state));
    influences.forcing_symbols_of(row.by);
  }
  const std::string usual = by.empty() ? "how the program reacts to it" : "for a missing interlock in its rung";
  const std::string held = disabling_malfunctions(unit, names, history.malfunctions());
  by += (by.empty() || held.empty() ? "" : ", ") + held;
  influences.forcing_symbols_of(unit);
  return fmt::format("command to a disabled unit: {}, came {} while {} ({}) cannot move{}{}; {}",
                     symbol_words(symbol, names), level_words(symbol, true, names), names.unit(unit),
                     state_words(unit, names, history.unit(unit)), by.empty() ? "" : ", disabled by ", by,
                     influences.advice(usual));
}

std::string of_operation(const FoundThing& found, const PlantNames& names, const History& history) {
  const std::uint32_t symbol = found.of.front();
  if (found.kind == FindingKind::command_to_a_disabled_unit) return of_disabled(symbol, names, history);
  const std::uint32_t unit = names.tables().symbols[symbol].unit;
  const std::string who = symbol_words(symbol, names);
  const std::string name(names.unit(unit));
  const std::string state = state_words(unit, names, history.unit(unit));
  const std::string_view on = level_words(symbol, true, names);
  const Influences influences = Influences(names, history).holding(unit).slowing(unit).forcing_symbols_of(unit);
  if (found.kind == FindingKind::command_without_effect) {
    return fmt::format("command without effect: {}, came {} while {} is in {}, from where it has no transition; {}",
                       who, on, name, state,
                       influences.advice("whether the step before it was skipped, or the wrong output was used"));
  }
  return fmt::format("lost command: {}, {} since {}, went {} before {} ({}) moved; {}", who, on,
                     seconds(history.rose(symbol)), level_words(symbol, false, names), name, state,
                     influences.advice("whether the output should be held until the device has answered"));
}

std::string of_event(const FoundThing& found, const PlantNames& names, const History& history) {
  const std::uint32_t symbol = found.of.front();
  const std::uint32_t unit = names.tables().symbols[symbol].unit;
  std::string text = fmt::format("event too short: {}, changed and changed back too quickly for a PLC to see it",
                                 symbol_words(symbol, names));
  if (unit != tables::kNone) {
    text += fmt::format(", {} is in {}", names.unit(unit), state_words(unit, names, history.unit(unit)));
    text += led(unit, names, history);
  }
  const Influences influences = Influences(names, history).forcing(symbol);
  if (influences.empty()) return text + "; check for a state that takes no time";
  return fmt::format("{}; {}: give it a longer time than a cycle of the PLC", text, influences.words());
}

std::string of_overwritten(const FoundThing& found, const PlantNames& names) {
  return fmt::format(
      "event overwritten: {}, the PLC holds another value than the one that was written to it; check whether its I/O "
      "refresh or its program writes this address, and choose a strategy for events whose addresses the PLC does not "
      "write",
      symbol_words(found.of.front(), names));
}

std::string of_clock(const FoundThing& found, const PlantNames& names) {
  return fmt::format(
      "clock restarted: {}, its value jumped or its link was lost, so plant time goes on from where it is; check "
      "whether the PLC was restarted, or whether something else writes this value",
      symbol_words(found.of.front(), names));
}

std::string of_standstill(const FoundThing& found) {
  return fmt::format(
      "standstill: the process was stopped or delayed, so the plant did not run for {}, and its PLC waited; check what "
      "else runs on this computer, and whether it was suspended",
      seconds(found.of.front() * tables::kMillisecond));
}

bool is_of_served_symbol(FindingKind kind) {
  return kind == FindingKind::not_read || kind == FindingKind::not_sampled || kind == FindingKind::several_writers;
}

std::string of_served_symbol(const FoundThing& found, const PlantNames& names) {
  const std::uint32_t symbol = found.of.front();
  const ServedSymbol served{symbol_words(symbol, names), names.tables().symbols[symbol].inverted()};
  if (found.kind == FindingKind::several_writers) return several_writers_words(served, found.value);
  const tables::MissedPulse pulse = tables::unpack_missed_pulse(found.value);
  return found.kind == FindingKind::not_read ? not_read_words(served, pulse) : not_sampled_words(served, pulse);
}

std::string of_link(const FoundThing& found, const PlantNames& names, const History& history) {
  const PlantNames::Link link = names.link(found.of.front());
  if (found.kind == FindingKind::request_refused) {
    return refused_by_server_words(tables::unpack_refusal(found.value), link.name);
  }
  if (found.kind == FindingKind::link_back) {
    return fmt::format("link back: {}, what the PLC writes takes effect again", link.name);
  }
  if (found.kind == FindingKind::no_plc) return fmt::format("no PLC: {}, {}", link.name, link.absence);
  const Influences influences = Influences(names, history).cutting(link.controller);
  return fmt::format("link lost: {}, {}", link.name, influences.empty() ? link.silence : influences.advice(""));
}

/// Whether it is of a request that a link to a PLC sent.
bool is_of_client(std::uint64_t refusal) {
  return tables::unpack_refusal(refusal).side != tables::Refusal::Side::modbus_server;
}

std::string of_client_refusal(const FoundThing& found, const PlantNames& names) {
  return fmt::format("request refused: {}, the PLC refused {}", names.link(found.of.front()).name,
                     link::client_refusal_text(tables::unpack_refusal(found.value)));
}

std::string of_left_out(const FoundThing& found, const PlantNames& names) {
  return fmt::format(
      "symbol left out: {}, the PLC refuses it again and again, so that its link goes on without it and "
      "tries again at most every 30 s; it refused {}",
      symbol_words(found.of.front(), names), link::client_refusal_text(tables::unpack_refusal(found.value)));
}

/// A loop has either malfunctions or none.
bool has_malfunctions(const FoundThing& loop, const PlantNames& names) {
  const std::uint32_t member = loop.of.front();
  return member >= tables::first_malfunction_of_loop(names.tables()) &&
         member < tables::first_value_of_loop(names.tables());
}

/// A loop of values may have devices, too.
bool has_values(const FoundThing& loop, const PlantNames& names) {
  return std::any_of(loop.of.begin(), loop.of.end(),
                     [&](std::uint32_t member) { return member >= tables::first_value_of_loop(names.tables()); });
}

std::string of_loop(const FoundThing& found, const PlantNames& names) {
  const bool one = found.of.size() == 1;
  if (has_malfunctions(found, names)) {
    return fmt::format(
        "instantaneous loop: malfunction{} {} {} and {} again and again within a millisecond, and {} inactive until "
        "the "
        "run ends; check for times of almost 0, and for a `when` that names what the malfunction changes",
        one ? "" : "s", name_of(found, names), one ? "starts" : "start", one ? "ends" : "end", one ? "stays" : "stay");
  }
  if (has_values(found, names)) {
    return fmt::format(
        "instantaneous loop: {} {} again and again without time passing and {} frozen until the run ends; check for "
        "`changes` with conditions that depend on what they set",
        name_of(found, names), one ? "changes" : "change", one ? "is" : "are");
  }
  return fmt::format(
      "instantaneous loop: {} {} through states without time passing and {} frozen until the run ends; check for "
      "transitions whose `after` and `takes` are 0, and for conditions that depend on themselves",
      name_of(found, names), one ? "loops" : "loop", one ? "is" : "are");
}

/// The part that cannot move, and the one that leaves it no room.
std::string of_transfer(const FoundThing& found, const PlantNames& names, const History& history) {
  const tables::TransferRow& row = names.tables().material.transfers[found.of.front()];
  const std::uint64_t moving = found.value >> 32;
  const std::uint64_t there = found.value & 0xFFFF'FFFF;
  const History::Part* part = history.part(moving);
  const History::Part* obstacle = history.part(there);
  Influences influences(names, history);
  for (const tables::SensorRow& sensor : names.tables().material.sensors) {
    if (sensor.location == row.from.location || sensor.location == row.to.location) influences.forcing(sensor.symbol);
  }
  return fmt::format("part blocked: {} cannot move part {}{} from {} to {}{}; {}", names.transfer(found.of.front()),
                     moving, part == nullptr ? "" : fmt::format(" ({})", names.part_kind(part->kind)),
                     names.location(row.from.location), names.location(row.to.location),
                     obstacle == nullptr ? ", which has no room"
                                         : fmt::format(": part {} is there {}", there, since_words(obstacle->since)),
                     influences.advice("whether the program looks for a part there before it moves another one"));
}

std::string of_value(const FoundThing& found, const PlantNames& names) {
  return fmt::format(
      "value not finite: {} keeps its number, since a result of its formula is infinite or not a number; check for "
      "divisions by 0, and for roots and logarithms of numbers below 0",
      names.value(found.of.front()));
}

}  // namespace

std::string_view finding_name(FindingKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

bool is_of_unit(FindingKind kind) {
  return kind == FindingKind::conflicting_operations || kind == FindingKind::stopped_under_another_command ||
         kind == FindingKind::overrun || kind == FindingKind::started_on_enabling ||
         kind == FindingKind::instantaneous_loop;
}

bool is_of_link(FindingKind kind) {
  return kind == FindingKind::link_lost || kind == FindingKind::link_back || kind == FindingKind::no_plc ||
         kind == FindingKind::request_refused;
}

bool is_of_host(FindingKind kind) { return is_of_link(kind) || kind == FindingKind::standstill; }

bool is_of_malfunctions(const FoundThing& found, const PlantNames& names) {
  return found.kind == FindingKind::instantaneous_loop && has_malfunctions(found, names);
}

bool is_of_symbol(FindingKind kind) {
  return !is_of_unit(kind) && !is_of_host(kind) && kind != FindingKind::requirement_violated &&
         kind != FindingKind::part_blocked && kind != FindingKind::value_not_finite;
}

std::string name_of(const FoundThing& found, const PlantNames& names) {
  if (found.kind == FindingKind::requirement_violated) return std::string(names.requirement(found.of.front()));
  if (found.kind == FindingKind::part_blocked) return std::string(names.transfer(found.of.front()));
  if (found.kind == FindingKind::value_not_finite) return std::string(names.value(found.of.front()));
  if (is_of_symbol(found.kind)) return std::string(names.symbol(found.of.front()));
  if (is_of_link(found.kind)) return names.link(found.of.front()).name;
  if (found.kind == FindingKind::standstill) return std::string(names.tables().name);
  std::vector<std::string_view> members;
  members.reserve(found.of.size());
  for (const std::uint32_t member : found.of) members.push_back(names.loop_member(member));
  std::sort(members.begin(), members.end());
  // Names of malfunctions may contain blanks.
  const std::string_view between = is_of_malfunctions(found, names) ? ", " : " ";
  std::string text;
  for (const std::string_view member : members) text.append(text.empty() ? "" : between).append(member);
  return text;
}

std::vector<std::uint32_t> units_of(const FoundThing& found, const tables::PlantTables& tables) {
  if (is_of_unit(found.kind)) {
    std::vector<std::uint32_t> units;
    std::copy_if(found.of.begin(), found.of.end(), std::back_inserter(units),
                 [&](std::uint32_t member) { return member < tables.units.size(); });
    return units;
  }
  if (is_of_host(found.kind) || found.kind == FindingKind::part_blocked ||
      found.kind == FindingKind::value_not_finite) {
    return {};
  }
  if (found.kind == FindingKind::requirement_violated) return requirement_units(tables, found.of.front());
  const std::uint32_t unit = tables.symbols[found.of.front()].unit;
  return unit == tables::kNone ? std::vector<std::uint32_t>() : std::vector<std::uint32_t>{unit};
}

std::string symbol_words(std::uint32_t symbol, const PlantNames& names) {
  const bool operation = names.is_operation(symbol);
  const std::uint32_t unit = names.tables().symbols[symbol].unit;
  std::string text = fmt::format("PLC {} {}{}, ", operation ? "output" : "input", address_or_name(symbol, names),
                                 names.tables().symbols[symbol].inverted() ? " (inverted)" : "");
  if (unit == tables::kNone) {
    text += fmt::format("symbol {}", names.symbol(symbol));
  } else {
    text += fmt::format("{} {} of {}", operation ? "operation" : "event", names.task(symbol), names.unit(unit));
  }
  return text + " (" + names.cite(symbol) + ")";
}

std::string state_words(std::uint32_t unit, const PlantNames& names, const plant::UnitView& view) {
  std::string text(names.state(unit, view.state));
  if (view.moving) text += fmt::format("->{}", names.state(unit, view.target));
  if (view.stopped_midway) text += ", stopped midway";
  if (view.disabled) text += ", disabled";
  if (view.frozen) text += ", frozen";
  return text;
}

std::string finding_words(const FoundThing& found, const PlantNames& names, const History& history) {
  if (found.kind == FindingKind::part_blocked) return of_transfer(found, names, history);
  if (found.kind == FindingKind::value_not_finite) return of_value(found, names);
  if (found.kind == FindingKind::request_refused && is_of_client(found.value)) return of_client_refusal(found, names);
  if (found.kind == FindingKind::symbol_left_out) return of_left_out(found, names);
  if (is_of_link(found.kind)) return of_link(found, names, history);
  if (found.kind == FindingKind::standstill) return of_standstill(found);
  if (found.kind == FindingKind::event_too_short) return of_event(found, names, history);
  if (found.kind == FindingKind::event_overwritten) return of_overwritten(found, names);
  if (found.kind == FindingKind::clock_restarted) return of_clock(found, names);
  if (is_of_served_symbol(found.kind)) return of_served_symbol(found, names);
  if (found.kind == FindingKind::instantaneous_loop) return of_loop(found, names);
  return is_of_unit(found.kind) ? of_unit(found, names, history) : of_operation(found, names, history);
}

std::string requirement_words(std::uint32_t requirement, bool early, const PlantNames& names) {
  const tables::RequirementRow& row = names.tables().requirements[requirement];
  const std::string what =
      row.kind == tables::RequirementRow::Kind::never ? "its condition must never hold and now holds"
      : early ? "the expected condition became true before " + seconds(row.earliest) + " had passed"
              : "the expected condition did not become true within " + seconds(row.within);
  return fmt::format("requirement violated: `{}`, {}", names.requirement(requirement), what);
}

}  // namespace symplant::trace
