// Rules: devices as a whole, their sequences, what they lack, and plants without any.
#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "check/rule.hpp"
#include "model/sequence.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

void unit_too_large(const Find& find) {
  for (const model::TooLarge& large : find.evidence.too_large) {
    find.at(find.symbols[large.symbols.front()])
        .explains(Kind::device, large.path)
        .say(
            "`{}` has {} operations, {} events and {} states, but a device may have at most {}, {} and {}: its symbols "
            "are in "
            "no device; check whether the device level of their names distinguishes devices",
            large.path, large.operations, large.events, large.states, tables::kMaxOperations, tables::kMaxEvents,
            tables::kMaxStates);
  }
}

void initial_ambiguous(const Find& find, const Unit& unit) {
  std::vector<const Symbol*> on;
  for (const State& state : unit.states) {
    if (state.event == kNone || find.evidence_of(unit).initial_candidates < 2) continue;
    const Symbol& symbol = find.symbols[unit.events[state.event]];
    if (symbol.initial != 0) on.push_back(&symbol);
  }
  if (on.empty()) return;
  Finding finding = find.at(*on[0], on[0]->row->initial);
  for (std::size_t i = 1; i < on.size(); ++i) finding.see(*on[i]->row, on[i]->row->initial, "TRUE here as well");
  finding.say("{} events of `{}` are TRUE at the start, so they are ignored: it starts in `{}`; keep TRUE for one",
              on.size(), unit.path, unit.states[unit.initial].name);
}

struct NumberedState {
  std::uint64_t number;
  std::uint32_t symbol;  ///< the first of its symbols in list order
  const State* state;
};

/// By number, those of one number by first row. Empty if there are fewer than three, or one is too long.
std::vector<NumberedState> numbered_states(const Unit& unit) {
  std::vector<NumberedState> states;
  for (const State& state : unit.states) {
    std::uint32_t first = state.operation != kNone ? unit.operations[state.operation] : kNone;
    if (state.event != kNone) first = std::min(first, unit.events[state.event]);
    if (unit.states.size() < 3 || !state.numbered || first == kNone) continue;
    const std::string_view digits = model::sequence_number(state.name);
    NumberedState& numbered = states.emplace_back(NumberedState{0, first, &state});
    const char* end = digits.data() + digits.size();
    if (std::from_chars(digits.data(), end, numbered.number).ec != std::errc()) return {};
  }
  if (states.size() < 3) return {};
  std::ranges::sort(states, [](const NumberedState& a, const NumberedState& b) {
    return a.number != b.number ? a.number < b.number : a.symbol < b.symbol;
  });
  return states;
}

/// The step from one number to the next, where most steps are alike and few numbers are missing; 0 else.
std::uint64_t step_of(const std::vector<NumberedState>& states) {
  std::vector<std::uint64_t> steps;
  for (std::size_t i = 1; i < states.size(); ++i) {
    if (const auto step = states[i].number - states[i - 1].number; step != 0) steps.push_back(step);
  }
  if (steps.empty()) return 0;
  const std::uint64_t least = *std::ranges::min_element(steps);
  if (std::ranges::any_of(steps, [&](std::uint64_t step) { return step % least != 0; })) return 0;
  const std::uint64_t missing = (states.back().number - states.front().number) / least - steps.size();
  const auto even = static_cast<std::size_t>(std::ranges::count(steps, least));
  return missing < states.size() && 2 * even >= steps.size() ? least : 0;
}

void sequence_gap(const Find& find, const Unit& unit) {
  const std::vector<NumberedState> states = numbered_states(unit);
  const std::uint64_t step = step_of(states);
  for (std::size_t i = 1; step != 0 && i < states.size(); ++i) {
    const NumberedState& before = states[i - 1];
    const NumberedState& after = states[i];
    if (after.number - before.number <= step) continue;
    find.at(find.symbols[after.symbol])
        .explains(Kind::model, unit.path)
        .follows(Kind::device, unit.path)
        .follows(Kind::model, unit.path)
        .see(find.symbols[before.symbol], "the number before")
        .say("`{}` steps from `{}` to `{}`: number {} is missing{}; add the missing rows, or close the gap", unit.path,
             before.state->name, after.state->name, before.number + step,
             after.number - before.number == 2 * step ? "" : fmt::format(", up to {}", after.number - step));
  }
}

void sequence_repeated(const Find& find, const Unit& unit) {
  if (unit.described != nullptr && !unit.described->transitions.empty()) return;  // they give the order
  const std::vector<NumberedState> states = numbered_states(unit);
  const auto equal = [](const NumberedState& a, const NumberedState& b) { return a.number == b.number; };
  const auto first = std::ranges::adjacent_find(states, equal);
  // If several numbers repeat, they count sensors and are no sequence.
  if (first == states.end() || std::adjacent_find(first + 1, states.end(), equal) != states.end()) return;
  find.at(find.symbols[first[1].symbol])
      .explains(Kind::device, unit.path)
      .follows(Kind::device, unit.path)
      .follows(Kind::model, unit.path)
      .see(find.symbols[first->symbol], "the other one")
      .say("`{}` and `{}` of `{}` have the same number: only their rows decide which comes first; correct one",
           first->state->name, first[1].state->name, unit.path);
}

/// The symbols of a device's model, and its numbers.
using Device = std::vector<const Symbol*>;
/// Devices named alike, whatever their line and process: `CLAMP1` and `CLAMP12`.
using Siblings = std::map<std::string, Device>;

/// Null if a device has none.
const Symbol* find_in(const Device& device, Direction direction, std::string_view task) {
  const auto found = std::ranges::find_if(device, [&](const Symbol* symbol) {
    return symbol->direction == direction && text::equal_ignoring_case(symbol->reading.task(), task);
  });
  return found == device.end() ? nullptr : *found;
}

/// A symbol that nearly all siblings have, as the first of them has it.
struct Common {
  const Symbol* symbol;
  std::size_t count;
};

/// Three quarters of the others have it, three at least. If several, and over one in eight, lack it, that is intended.
std::vector<Common> common_symbols(const Siblings& siblings) {
  std::vector<Common> symbols;
  std::array<text::ByName<std::size_t>, 2> by_task;
  for (const auto& [path, device] : siblings) {
    for (const Symbol* symbol : device) {
      auto& tasks = by_task[static_cast<std::size_t>(symbol->direction)];
      const std::size_t index = tasks.try_emplace(symbol->reading.task(), symbols.size()).first->second;
      if (index == symbols.size()) symbols.push_back({symbol, 0});
      ++symbols[index].count;
    }
  }
  std::erase_if(symbols, [all = siblings.size()](const Common& common) {
    const std::size_t without = all - common.count;
    return common.count < 3 || 4 * common.count < 3 * (all - 1) || (without > 1 && without * 8 > all);
  });
  return symbols;
}

/// A task without the number of its sensor: `RET` of `RET2`.
std::string_view end_of(std::string_view task) { return task.substr(0, task.find_last_not_of("0123456789_") + 1); }

/// Whether a device under a custom naming rule lacks the sensor of an end, and has one of the other end. Such rules
/// often name other symbols differently in each device.
bool lacks_end(const Device& device, const Symbol& others) {
  bool has_event = false;
  for (const Symbol* symbol : device) {
    if (symbol->direction != Direction::event) continue;
    if (text::equal_ignoring_case(end_of(symbol->reading.task()), end_of(others.reading.task()))) return false;
    has_event = true;
  }
  return has_event && others.direction == Direction::event;
}

void report(const Find& find, const Device& device, std::string_view path, const std::vector<Common>& lacks,
            std::size_t siblings) {
  const Symbol& others = *lacks.front().symbol;
  // The row next to the one that is missing: of the same task, or the device's first.
  const Symbol* near = find_in(device, other_side(others.direction), others.reading.task());
  if (near == nullptr) near = device.front();
  Finding finding = find.at(location_of(find.plant, *near->row, near->name()));
  finding.also(Kind::device, path).follows(Kind::device, path).follows(Kind::model, path);
  for (const auto& [symbol, count] : lacks) {
    const std::string name = symbol_name(path, symbol->direction, symbol->reading.task());
    finding.also(Kind::missing, name).follows(Kind::missing, name).lacks(name, path).see(*symbol, "one that has it");
  }
  finding.say(
      "`{}` has no {} `{}`{}: {} of {} devices named like it have one; add the row, or spell its task as they do", path,
      others.direction == Direction::operation ? "operation" : "event", others.reading.task(),
      lacks.size() == 1 ? "" : fmt::format(", and lacks {} more symbols", lacks.size() - 1), lacks.front().count,
      siblings);
}

void shape_lacks_symbol(const Find& find) {
  std::map<std::string, Siblings> classes;
  const auto path_of = [&](const Symbol& of) {
    return of.unit == kNone ? of.reading.device_path() : find.units[of.unit].path;
  };
  Device* last = nullptr;
  std::uint32_t unit = kNone;  // of the last device: its symbols are mostly in rows one after the other
  for (const Symbol& symbol : find.symbols) {
    const bool number = symbol.account == model::Account::numeric && symbol.reading.is_named();
    if (symbol.unit == kNone && !number) continue;
    if (std::exchange(unit, symbol.unit) != symbol.unit || symbol.unit == kNone) {
      const std::string name = class_name(number ? symbol.reading.device() : find.units[symbol.unit].device);
      last = &classes[name][text::to_upper(path_of(symbol))];
    }
    last->push_back(&symbol);
  }
  for (const auto& [name, siblings] : classes) {
    const std::vector<Common> common = common_symbols(siblings);
    for (const auto& sibling : siblings) {
      const Device& device = sibling.second;
      std::vector<Common> lacks = common;
      std::erase_if(lacks, [&](const Common& each) {
        return find_in(device, each.symbol->direction, each.symbol->reading.task()) != nullptr;
      });
      if (3 * lacks.size() > 2 * common.size()) continue;  // it is something else
      std::erase_if(
          lacks, [&](const Common& each) { return find.plant.pairing != nullptr && !lacks_end(device, *each.symbol); });
      if (!lacks.empty()) report(find, device, path_of(*device.front()), lacks, siblings.size());
    }
  }
}

/// Why a symbol is in no device.
std::string_view outside_text(const PlantModel& plant, name::Account by) {
  if (by == name::Account::numeric) return "numeric";
  if (by == name::Account::unit_too_large) return "in devices that are too large";
  if (by != name::Account::no_rule) return "not paired";
  return plant.levels() != nullptr ? "named otherwise" : "matched by no pattern";
}

void no_device(const Find& find) {
  const PlantModel& plant = find.plant;
  if (!nothing_is_driven(plant)) return;
  std::map<std::string_view, std::size_t> reasons;
  for (const Symbol& symbol : plant.symbols) ++reasons[outside_text(plant, symbol.account)];
  std::string text;
  for (const auto& [why, count] : reasons) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, why);
  const Symbol& first = plant.symbols.front();
  find.at(location_of(plant, *first.row, first.name()))
      .say("none of {} I/O symbol{} is in a device of the naming rule `{}`: {}; {}; until then nothing moves",
           plant.symbols.size(), plant.symbols.size() == 1 ? "" : "s", plant.rule_text(), text,
           plant.pairing != nullptr ? "correct the rule"
                                    : fmt::format("let `symplant infer {} -o naming.json` propose the rule",
                                                  plant.lists[first.list].name()));
}

constexpr Rule kDeviceRules[] = {
    {"SP406", "unit-too-large", kWarning, unit_too_large, "a device has more symbols or states than a device may have",
     "A device has at most 64 operations, 64 events and 250 states. Most often all devices have one name.",
     "Its symbols are served, but in no device.", "Check the device level of the names.", Rank::row, For::named},
    {"SP408", "initial-ambiguous", kWarning, initial_ambiguous, "several events of a device are on at the start",
     "Several events of one device have Initial TRUE, but a device starts in one state.",
     "All of them are ignored: it starts in its rest state, else in its first state.",
     "Keep TRUE for the event that is on at the start, or give `initial` in plant.json.", Rank::last, For::named},
    {"SP411", "sequence-gap", kWarning, sequence_gap, "a sequence number is missing",
     "`P1`, `P2`, `P4`. Numbers in even steps (`10`, `20`, `30`) are no gap.",
     "A state, if its rows are missing: the device steps from `P2` to `P4`.",
     "Add the rows of the missing number, or number the tasks without a gap.", Rank::gap, For::named},
    {"SP412", "sequence-repeated", kWarning, sequence_repeated, "two tasks of a sequence have the same number",
     "`HOME1`, `JOB2`, `DONE2`. If several numbers repeat (`ADV1`, `RET1`, `ADV2`, `RET2`), they are numbers of "
     "sensors.",
     "The order: the rows decide which of the two comes first.",
     "Give each task a separate number, or give `transitions` in plant.json.", Rank::repeated, For::named},
    {"SP414", "shape-lacks-symbol", kWarning, shape_lacks_symbol, "a device lacks a symbol that its siblings have",
     "Names are alike if they differ in digits only (`CLAMP1`, `CLAMP2`). At least three others and three quarters of "
     "all must have the symbol. If several, and more than one in eight, lack it, there is no finding. Under a custom "
     "naming rule only the sensor of an end position must exist.",
     "A state is never commanded or reported, or the device becomes a single solenoid.",
     "Add the row, or spell its task as the others do. If it is intended, ignore it.", Rank::siblings, For::named},
    {"SP415", "no-device", kError, no_device, "the plant has I/O symbols, and nothing drives them",
     "Devices are made from BOOL symbols named by the rule: `EXLINE_MB_AGV_O_P1` and `EXLINE_MB_AGV_I_P1` are an "
     "operation and an event of `EXLINE_MB_AGV`. A custom rule pairs operations and events. A plant with `material` or "
     "`follow` needs no device.",
     "All behavior: the symbols are served, but nothing drives an input.",
     "`symplant infer LIST -o naming.json` proposes the rule for `--naming naming.json`. For a plant of plain signals "
     "set `\"check\": { \"severity\": { \"no-device\": \"note\" } }`.",
     Rank::last, For::all, diag::Effect::served},
};

}  // namespace

bool nothing_is_driven(const PlantModel& plant) {
  // Events that nothing links, and numbers, make a device in which nothing moves.
  const auto may_move = [](const Unit& unit) {
    return !unit.operations.empty() || unit.events.size() > unit.reports.size() || unit.described != nullptr;
  };
  return !plant.symbols.empty() && std::ranges::none_of(plant.units, may_move) && plant.material.empty() &&
         plant.follows.empty();
}

std::span<const Rule> device_rules() { return kDeviceRules; }

}  // namespace symplant::check
