// Why a symbol has its value: what drives an event, what reads an operation.
#include <fmt/format.h>

#include <algorithm>

#include "symplant/tables/level.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/value_text.hpp"
#include "symplant/why/formula_words.hpp"
#include "symplant/why/walk.hpp"

namespace symplant::why {
namespace {

/// How states of a type switch an event.
struct Switching {
  States enter_on;
  States enter_off;
  States leave_on;
  States leave_off;

  /// It is on in some states, and off in all others.
  bool is_plain() const { return enter_on == leave_off && enter_off.none() && leave_on.none(); }
};

Switching switching_of(const tables::TypeRow& type, std::uint32_t event) {
  Switching switching;
  const auto has = [event](std::uint64_t mask) { return (mask >> event & 1) != 0; };
  for (std::uint8_t state = 0; state < type.states; ++state) {
    switching.enter_on.set(state, has(type.enter[state].on));
    switching.enter_off.set(state, has(type.enter[state].off));
    switching.leave_on.set(state, has(type.leave[state].on));
    switching.leave_off.set(state, has(type.leave[state].off));
  }
  return switching;
}

/// The symbol on the same address that a unit drives; itself if it has no address in common.
std::uint32_t driven_symbol(const PlantIndex& index, std::uint32_t symbol) {
  const auto& symbols = index.tables.symbols;
  const std::uint32_t leader = index.use.leader(symbol);
  if (symbols[symbol].moved() || symbols[leader].moved()) return symbols[symbol].moved() ? symbol : leader;
  for (const tables::SharedAddress& shared : index.tables.shared_addresses) {
    if (index.use.leader(shared.symbol) == leader && symbols[shared.symbol].moved()) return shared.symbol;
  }
  return symbol;
}

}  // namespace

Explanation Walk::symbol(std::uint32_t symbol) {
  const Reference self{Reference::Kind::symbol, symbol};
  Explanation result{symbol_head(symbol), {self}, {}};
  if (is_mentioned(self, result)) return result;
  const Level level(*this, self);
  if (names_.is_operation(symbol)) {
    add_operation(symbol, result);
    return result;
  }
  const SymbolDriver driver = index_.use.driver(symbol);
  switch (driver.kind) {
    case SymbolDriver::Kind::unit:
      add_event_of_unit(driven_symbol(index_, symbol), driver.unit, result);
      break;
    case SymbolDriver::Kind::condition:
      add_follow(driven_symbol(index_, symbol), result);
      break;
    case SymbolDriver::Kind::part:
      add_sensor(driven_symbol(index_, symbol), result);
      break;
    case SymbolDriver::Kind::behavior:
      result.sentence += fmt::format(": the custom behavior of {} sets it", names_.unit(driver.unit));
      append(result.because, causes(std::vector{driver.unit}, [this](std::uint32_t unit) { return this->unit(unit); }));
      break;
    case SymbolDriver::Kind::none:
      result.sentence += ": no device drives it";
      break;
  }
  return result;
}

void Walk::add_operation(std::uint32_t symbol, Explanation& result) {
  const bool bit = tables_.symbols[symbol].type() == tables::DataType::boolean;
  const bool on = commands(symbol);
  if (const std::string why = view_.unwritten(symbol); !why.empty()) result.sentence += ": " + why;
  if (bit && on && !view_.is_armed(symbol).value_or(true)) {
    result.sentence += ", without effect until it goes off and on again";
  }
  if (!is_asked_ || path_.size() != 1) return;
  const SymbolDriver driver = index_.use.driver(symbol);
  if (driver.kind == SymbolDriver::Kind::unit) {
    append(result.because,
           causes(std::vector{driver.unit}, [&](std::uint32_t unit) { return moved_unit(symbol, unit); }));
  }
  const auto all = index_.use.readers(symbol);
  std::vector<SymbolReader> readers(all.begin(), all.end());
  if (!view_.shows_malfunctions()) {
    std::erase_if(readers, [](const SymbolReader& each) { return each.kind == SymbolReader::Kind::malfunction; });
  }
  append(result.because, causes(readers, [this](const SymbolReader& each) { return reader(each); }));
  if (result.because.empty()) result.sentence += "; no device and no condition uses it";
}

/// The unit that an operation moves, and what keeps it from that.
Explanation Walk::moved_unit(std::uint32_t operation, std::uint32_t unit) {
  States goals;
  const tables::SymbolRow& row = tables_.symbols[operation];
  const bool bit = row.type() == tables::DataType::boolean && row.unit == unit;
  for (std::uint8_t state = 0; bit && state < type_of(unit).states; ++state) {
    const auto number = static_cast<std::uint8_t>(row.index - tables_.units[unit].operation_bit);
    goals.set(state, leads_to(unit, number, state));
  }
  const plant::UnitView now = view_.unit(unit);
  const bool there = !now.moving && goals[now.state];
  if (!there && commands(operation)) return this->unit(unit, goals);
  Explanation result{unit_head(unit), {{Reference::Kind::unit, unit}}, {}};
  if (there) {
    result.sentence += ", to which it leads";
  } else if (goals.any()) {
    result.sentence += fmt::format(", and goes to {} on it", state_list(unit, goals));
  }
  return result;
}

/// What reads an operation.
Explanation Walk::reader(const SymbolReader& reader) const {
  const auto of = [&](std::string_view what, std::string_view name, Reference::Kind kind) {
    return Explanation{fmt::format("{} {} reads it", what, name), {{kind, reader.index}}, {}};
  };
  switch (reader.kind) {
    case SymbolReader::Kind::unit:
      return of("a condition of", names_.unit(reader.index), Reference::Kind::unit);
    case SymbolReader::Kind::behavior:
      return of("the custom behavior of", names_.unit(reader.index), Reference::Kind::unit);
    case SymbolReader::Kind::requirement:
      return of("requirement", fmt::format("`{}`", names_.requirement(reader.index)), Reference::Kind::requirement);
    case SymbolReader::Kind::event:
      return of(
          tables_.symbols[reader.index].type() == tables::DataType::boolean ? "the condition of" : "the formula of",
          names_.symbol(reader.index), Reference::Kind::symbol);
    case SymbolReader::Kind::track:
      return of("track", names_.location(reader.index), Reference::Kind::location);
    case SymbolReader::Kind::transfer:
      return of("transfer", fmt::format("`{}`", names_.transfer(reader.index)), Reference::Kind::transfer);
    case SymbolReader::Kind::work:
      return of("work", fmt::format("`{}`", names_.work(reader.index)), Reference::Kind::work);
    case SymbolReader::Kind::malfunction:
      return {fmt::format("malfunction `{}` reads it", names_.malfunction(reader.index)), {}, {}};
    case SymbolReader::Kind::value:
      return {fmt::format("value {} reads it", names_.value(reader.index)),
              {{Reference::Kind::value, tables_.values.rows[reader.index].output}},
              {}};
    case SymbolReader::Kind::source:
      break;
  }
  return of("source", fmt::format("`{}`", names_.source(reader.index)), Reference::Kind::source);
}

/// An event that a unit switches: it changes if the unit enters or leaves a state.
void Walk::add_event_of_unit(std::uint32_t symbol, std::uint32_t unit, Explanation& result) {
  const tables::SymbolRow& row = tables_.symbols[symbol];
  const Switching switching = switching_of(type_of(unit), row.index - tables_.units[unit].event_bit);
  const bool level = (view_.value(symbol) != 0) != row.inverted();
  const std::string_view on = tables::level_text(true, row.inverted());
  const std::string_view off = tables::level_text(false, row.inverted());
  const auto list = [&](const States& states) { return state_list(unit, states); };
  if (switching.is_plain()) {
    const std::string states = list(switching.enter_on);
    if (states != names_.task(symbol)) {
      result.sentence += fmt::format(": it is {} while {} is in {}", on, names_.unit(unit), states);
    }
  } else {
    std::string text;
    const auto add = [&](const States& states, std::string_view verb, std::string_view to) {
      if (states.any()) text += fmt::format("{}{} {} switches it {}", text.empty() ? "" : ", ", verb, list(states), to);
    };
    add(switching.enter_on, "entering", on);
    add(switching.leave_on, "leaving", on);
    add(switching.enter_off, "entering", off);
    add(switching.leave_off, "leaving", off);
    result.sentence += fmt::format(": {} switches it, {}", names_.unit(unit), text);
  }
  result.about.push_back({Reference::Kind::unit, unit});
  const States goals = level ? switching.enter_off : switching.enter_on;
  append(result.because, causes(std::vector{unit}, [&](std::uint32_t of) { return this->unit(of, goals); }));
}

/// An event that follows a condition.
void Walk::add_follow(std::uint32_t symbol, Explanation& result) {
  const auto row =
      std::lower_bound(tables_.follows.begin(), tables_.follows.end(), symbol,
                       [](const tables::FollowRow& follow, std::uint32_t of) { return follow.symbol < of; });
  if (row == tables_.follows.end() || row->symbol != symbol) return add_signal(symbol, result);
  const Network network = index_.conditions.network(row->condition);
  if (row->off != tables::kNone && add_switch(*row, network, result)) return;
  if (add_need(result, ": it follows a condition that", network)) return;
  const condition::Tree changes = changes_of(network, view_);
  result.sentence += ": it follows a condition that holds";
  append(result.because, causes_of(changes));
}

/// A numeric event that shows a formula.
void Walk::add_signal(std::uint32_t symbol, Explanation& result) {
  const auto& signals = tables_.values.signals;
  const auto row =
      std::lower_bound(signals.begin(), signals.end(), symbol,
                       [](const tables::SignalRow& signal, std::uint32_t of) { return signal.symbol < of; });
  if (row == signals.end() || row->symbol != symbol) return;
  const auto texts = tables::split_names(tables_.values.formula_texts);
  result.sentence += ": it shows " + formula_words(row->formula, texts[row->formula], index_, view_);
}

/// A switch with hysteresis that does not show the condition that switches it on; false if it does.
bool Walk::add_switch(const tables::FollowRow& row, const Network& on, Explanation& result) {
  const Network off = index_.conditions.network(row.off);
  if (holds(off, view_)) {
    result.sentence += ": it is switched off by a condition that holds";
    append(result.because, causes_of(changes_of(off, view_)));
    return true;
  }
  const bool level = (view_.value(row.symbol) != 0) != tables_.symbols[row.symbol].inverted();
  if (!level || holds(on, view_)) return false;
  result.sentence += ": it was switched on";
  return add_need(result, ", and switching it off", off);
}

/// Its state, and what it waits for.
Explanation Walk::requirement(std::uint32_t requirement) {
  const tables::RequirementRow& row = tables_.requirements[requirement];
  const Reference self{Reference::Kind::requirement, requirement};
  Explanation result{fmt::format("requirement `{}`", names_.requirement(requirement)), {self}, {}};
  const Level level(*this, self);
  const Network network = index_.conditions.network(row.condition);
  const bool never = row.kind == tables::RequirementRow::Kind::never;
  if (never && holds(network, view_)) {
    result.sentence += " is violated: its condition must never hold and now holds";
    append(result.because, violation(requirement).because);
  } else if (never) {
    const condition::Tree changes = changes_of(network, view_);
    result.sentence += changes.kind == condition::Tree::Kind::constant
                           ? " cannot be violated"
                           : " is not violated now: that needs " + condition_text(changes, names_);
  } else if (view_.is_pending(requirement).value_or(false)) {
    const Network expected = index_.conditions.network(row.expected);
    result.sentence += " waits for its expected condition";
    const std::string earliest = row.earliest > 0 ? trace::seconds(row.earliest) + " to " : "";
    add_need(result, fmt::format(" within {}{}, which", earliest, trace::seconds(row.within)), expected);
  } else {
    result.sentence += " expects nothing now";
    add_need(result, ": its `after`", network);
  }
  const std::string violated = view_.violated(requirement);
  if (!violated.empty()) result.sentence += "; it " + violated;
  return result;
}

Explanation Walk::violation(std::uint32_t requirement) {
  const tables::RequirementRow& row = tables_.requirements[requirement];
  const bool never = row.kind == tables::RequirementRow::Kind::never;
  const Network network = index_.conditions.network(never ? row.condition : row.expected);
  const bool early = row.earliest > 0 && holds(network, view_);
  Explanation result{
      trace::requirement_words(requirement, early, names_), {{Reference::Kind::requirement, requirement}}, {}};
  if (!never && !early) {
    if (!holds(network, view_)) result.because = causes_of(changes_of(network, view_));
    return result;
  }
  std::vector<condition::Atom> atoms;
  for (const condition::Atom& atom : atoms_of(changes_of(network, view_))) {
    const auto same = [&](const condition::Atom& other) { return reference_of(other) == reference_of(atom); };
    if (std::none_of(atoms.begin(), atoms.end(), same)) atoms.push_back(atom);
  }
  const auto since = [this](const condition::Atom& atom) {
    const Reference of = reference_of(atom);
    return of.kind == Reference::Kind::unit     ? view_.unit_since(of.index)
           : of.kind == Reference::Kind::symbol ? view_.since(of.index)
                                                : tables::Time{0};
  };
  std::stable_sort(atoms.begin(), atoms.end(),
                   [&](const condition::Atom& a, const condition::Atom& b) { return since(a) > since(b); });
  result.because = causes(atoms, [this](const condition::Atom& each) { return led(each); });
  return result;
}

/// What led to the state that an atom reads.
Explanation Walk::led(const condition::Atom& atom) {
  const Reference of = reference_of(atom);
  if (of.kind == Reference::Kind::unit) return led_unit(of.index);
  if (of.kind == Reference::Kind::value) return value(of.index);
  if (of.kind == Reference::Kind::location) return {location_head(of.index), {of}, {}};
  Explanation result{symbol_head(of.index), {of}, {}};
  const std::uint32_t unit = tables_.symbols[of.index].unit;
  done_.insert(of);
  if (unit != tables::kNone) {
    append(result.because, causes(std::vector{unit}, [this](std::uint32_t each) { return led_unit(each); }));
  }
  return result;
}

}  // namespace symplant::why
