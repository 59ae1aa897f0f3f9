// The texts of run-time findings.
#include "symplant/trace/finding_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/trace/requirement_units.hpp"

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

/// Added to the name of an inverted symbol: "on" means that it commands.
std::string_view inverted_words(std::uint32_t symbol, const PlantNames& names) {
  return names.tables().symbols[symbol].inverted() ? ", inverted" : "";
}

/// The units and malfunctions that disable a unit now: `EXLINE_MB_DOOR in OPEN1`.
std::string disablers(std::uint32_t unit, const PlantNames& names, const History& history) {
  std::string text;
  for (const tables::DisableRow& row : names.tables().disables) {
    const plant::UnitView by = history.unit(row.by);
    if (row.unit != unit || by.moving || by.state != row.state) continue;
    text += fmt::format("{}{} in {}", text.empty() ? "" : ", ", names.unit(row.by), names.state(row.by, row.state));
  }
  const tables::MalfunctionNumbers numbers(names.tables());
  for (const History::Malfunction& one : history.malfunctions()) {
    const bool sticks = numbers.kind(one.number) == tables::MalfunctionKind::stuck;
    if (!sticks || !numbers.names_unit(one.number, unit)) continue;
    text += fmt::format("{}malfunction `{}`", text.empty() ? "" : ", ", names.malfunction(one.number));
  }
  return text;
}

/// The last operations of a unit with their times: `; operations: Y0001 (P2 of L_P_AGV) on since 0.5 s`.
std::string led(std::uint32_t unit, const PlantNames& names, const History& history) {
  std::string text;
  for (const std::uint32_t symbol : history.last_operations(unit, kOperationsShown)) {
    text += fmt::format("{}{} ({} of {}{}) ", text.empty() ? "" : ", ", address_or_name(symbol, names),
                        names.task(symbol), names.unit(unit), inverted_words(symbol, names));
    text += history.commands(symbol)
                ? "on since " + seconds(history.rose(symbol))
                : fmt::format("on at {}, off since {}", seconds(history.rose(symbol)), seconds(history.since(symbol)));
  }
  return text.empty() ? ", none of its operations has been on" : "; operations: " + text;
}

std::string of_unit(const FoundThing& found, const PlantNames& names, const History& history) {
  const std::uint32_t unit = found.of.front();
  const std::string name(names.unit(unit));
  const std::string state = state_words(unit, names, history.unit(unit));
  const std::string operations = led(unit, names, history);
  switch (found.kind) {
    case FindingKind::conflicting_operations:
      return fmt::format(
          "conflicting operations: {} ({}) has commands to several states at once and obeys none of them{}; check "
          "for a missing interlock between these outputs",
          name, state, operations);
    case FindingKind::stopped_under_another_command:
      return fmt::format(
          "stopped under another command: {} ({}) has stopped, since its own command is off while another one is on{}; "
          "check why the output went off before it arrived",
          name, state, operations);
    case FindingKind::overrun:
      return fmt::format(
          "overrun: {} ({}) is still commanded to the state that it has reached, so its motor runs against the "
          "end{}; check whether the end position switches the output off",
          name, state, operations);
    default:
      return fmt::format(
          "started on enabling: {} ({}) started to move as soon as it was no longer disabled{}; check whether the "
          "command should have been switched off before",
          name, state, operations);
  }
}

std::string of_operation(const FoundThing& found, const PlantNames& names, const History& history) {
  const std::uint32_t symbol = found.of.front();
  const std::uint32_t unit = names.tables().symbols[symbol].unit;
  const std::string who = symbol_words(symbol, names);
  const std::string name(names.unit(unit));
  const std::string state = state_words(unit, names, history.unit(unit));
  if (found.kind == FindingKind::command_to_a_disabled_unit) {
    const std::string by = disablers(unit, names, history);
    return fmt::format(
        "command to a disabled unit: {}, came on while {} ({}) cannot move{}; check for a missing interlock in its "
        "rung",
        who, name, state, by.empty() ? "" : ", disabled by " + by);
  }
  if (found.kind == FindingKind::command_without_effect) {
    return fmt::format(
        "command without effect: {}, came on while {} is in {}, from where it has no transition; check whether the "
        "step before it was skipped, or the wrong output was used",
        who, name, state);
  }
  return fmt::format(
      "lost command: {}, on since {}, went off before {} ({}) moved; check whether the output should be held until the "
      "device has answered",
      who, seconds(history.rose(symbol)), name, state);
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
  return text + "; check for a state that takes no time";
}

std::string of_overwritten(const FoundThing& found, const PlantNames& names) {
  return fmt::format(
      "event overwritten: {}, the PLC holds another value than the one that was written to it; check whether its I/O "
      "refresh or its program writes this address, and choose a strategy for events that it leaves alone",
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

std::string of_link(const FoundThing& found, const PlantNames& names) {
  const PlantNames::Link link = names.link(found.of.front());
  if (found.kind == FindingKind::link_back) {
    return fmt::format("link back: {}, what the PLC writes takes effect again", link.name);
  }
  return fmt::format("link lost: {}, {}", link.name, link.silence);
}

/// A loop has either malfunctions or none.
bool has_malfunctions(const FoundThing& loop, const PlantNames& names) {
  return loop.of.front() >= tables::first_malfunction_of_loop(names.tables());
}

std::string of_loop(const FoundThing& found, const PlantNames& names) {
  const bool one = found.of.size() == 1;
  if (has_malfunctions(found, names)) {
    return fmt::format(
        "instantaneous loop: malfunction{} {} {} and {} without end within a millisecond, and {} inactive until the "
        "run ends; check for times of almost 0, and for a `when` that names what the malfunction changes",
        one ? "" : "s", name_of(found, names), one ? "starts" : "start", one ? "ends" : "end", one ? "stays" : "stay");
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
  return fmt::format(
      "part blocked: {} cannot move part {}{} from {} to {}{}; check whether the program looks for a part there before "
      "it moves another one",
      names.transfer(found.of.front()), moving,
      part == nullptr ? "" : fmt::format(" ({})", names.part_kind(part->kind)), names.location(row.from.location),
      names.location(row.to.location),
      obstacle == nullptr ? ", which has no room"
                          : fmt::format(": part {} is there {}", there, since_words(obstacle->since)));
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

bool is_of_symbol(FindingKind kind) {
  return !is_of_unit(kind) && !is_of_host(kind) && kind != FindingKind::requirement_violated &&
         kind != FindingKind::part_blocked;
}

std::string name_of(const FoundThing& found, const PlantNames& names) {
  if (found.kind == FindingKind::requirement_violated) return std::string(names.requirement(found.of.front()));
  if (found.kind == FindingKind::part_blocked) return std::string(names.transfer(found.of.front()));
  if (is_of_symbol(found.kind)) return std::string(names.symbol(found.of.front()));
  if (is_of_link(found.kind)) return names.link(found.of.front()).name;
  if (found.kind == FindingKind::standstill) return std::string(names.tables().name);
  std::vector<std::string_view> members;
  members.reserve(found.of.size());
  for (const std::uint32_t member : found.of) members.push_back(names.loop_member(member));
  std::sort(members.begin(), members.end());
  // Names of malfunctions may contain blanks.
  const std::string_view between =
      found.kind == FindingKind::instantaneous_loop && has_malfunctions(found, names) ? ", " : " ";
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
  if (is_of_host(found.kind) || found.kind == FindingKind::part_blocked) return {};
  if (found.kind == FindingKind::requirement_violated) return requirement_units(tables, found.of.front());
  const std::uint32_t unit = tables.symbols[found.of.front()].unit;
  return unit == tables::kNone ? std::vector<std::uint32_t>() : std::vector<std::uint32_t>{unit};
}

std::string symbol_words(std::uint32_t symbol, const PlantNames& names) {
  const bool operation = names.is_operation(symbol);
  const std::uint32_t unit = names.tables().symbols[symbol].unit;
  std::string text = fmt::format("PLC {} {}, ", operation ? "output" : "input", address_or_name(symbol, names));
  if (unit == tables::kNone) {
    text += fmt::format("symbol {}", names.symbol(symbol));
  } else {
    text += fmt::format("{} {} of {}", operation ? "operation" : "event", names.task(symbol), names.unit(unit));
  }
  text += inverted_words(symbol, names);
  return text + " (" + names.cite(symbol) + ")";
}

std::string address_or_name(std::uint32_t symbol, const PlantNames& names) {
  const std::string_view address = names.address(symbol);
  return std::string(address.empty() ? names.symbol(symbol) : address);
}

std::string state_words(std::uint32_t unit, const PlantNames& names, const plant::UnitView& view) {
  std::string text(names.state(unit, view.state));
  if (view.moving) text += fmt::format("->{}", names.state(unit, view.target));
  if (view.stopped_midway) text += ", stopped midway";
  if (view.disabled) text += ", disabled";
  if (view.frozen) text += ", frozen";
  return text;
}

std::string since_words(tables::Time changed) { return changed == 0 ? "since the start" : "since " + seconds(changed); }

std::string finding_words(const FoundThing& found, const PlantNames& names, const History& history) {
  if (found.kind == FindingKind::requirement_violated) return requirement_words(found.of.front(), names);
  if (found.kind == FindingKind::part_blocked) return of_transfer(found, names, history);
  if (is_of_link(found.kind)) return of_link(found, names);
  if (found.kind == FindingKind::standstill) return of_standstill(found);
  if (found.kind == FindingKind::event_too_short) return of_event(found, names, history);
  if (found.kind == FindingKind::event_overwritten) return of_overwritten(found, names);
  if (found.kind == FindingKind::clock_restarted) return of_clock(found, names);
  if (found.kind == FindingKind::instantaneous_loop) return of_loop(found, names);
  return is_of_unit(found.kind) ? of_unit(found, names, history) : of_operation(found, names, history);
}

std::string requirement_words(std::uint32_t requirement, const PlantNames& names) {
  const tables::RequirementRow& row = names.tables().requirements[requirement];
  return fmt::format("requirement violated: `{}`, {}", names.requirement(requirement),
                     row.kind == tables::RequirementRow::Kind::never
                         ? "its condition must never hold and now holds"
                         : "the expected condition did not become true within " + seconds(row.within));
}

std::string seconds(tables::Time time) {
  std::string text = std::to_string(time / tables::kSecond);
  const tables::Time rest = time % tables::kSecond;
  if (rest != 0) {
    std::string digits = std::to_string(tables::kSecond + rest);
    digits.front() = '.';
    text += digits.substr(0, digits.find_last_not_of('0') + 1);
  }
  return text + " s";
}

}  // namespace symplant::trace
