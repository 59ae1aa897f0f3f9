// Explanations: levels and circles, causes by condition, the words for units, symbols and locations.
#include "symplant/why/walk.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "symplant/tables/level.hpp"
#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/influences.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::why {
Explanation Walk::thing(const Reference& thing) {
  if (path_.empty()) is_asked_ = true;
  switch (thing.kind) {
    case Reference::Kind::unit:
      return unit(thing.index);
    case Reference::Kind::symbol:
      return symbol(thing.index);
    case Reference::Kind::requirement:
      return requirement(thing.index);
    case Reference::Kind::location:
      return location(thing.index);
    case Reference::Kind::transfer:
      return transfer(thing.index);
    case Reference::Kind::work:
      return work(thing.index);
    case Reference::Kind::source:
      return source(thing.index);
    case Reference::Kind::value:
      return asked_value(thing.index);
    case Reference::Kind::part:
      break;
  }
  return {};
}

/// Whether a thing is explained elsewhere, which the sentence then says.
bool Walk::is_mentioned(const Reference& thing, Explanation& result) const {
  const auto begin = std::find(path_.begin(), path_.end(), thing);
  if (begin == path_.end()) {
    if (!done_.contains(thing)) return false;
    result.sentence += ", see above";
    return true;
  }
  const auto name = [this](const Reference& other) {
    return (other.kind == Reference::Kind::part ? "part " : "") + name_of(other, names_);
  };
  result.sentence += fmt::format("; a circle: {} waits for ", name(thing));
  for (auto next = begin + 1; next != path_.end(); ++next) {
    result.sentence += fmt::format("{}, which waits for ", name(*next));
  }
  result.sentence += path_.end() - begin == 1 ? "itself" : name(thing);
  return true;
}

void Walk::append(std::vector<Explanation>& list, std::vector<Explanation> more) {
  for (Explanation& explanation : more) list.push_back(std::move(explanation));
}

/// A single cause: one sentence with what it causes.
void Walk::absorb(Explanation& result, Explanation cause) {
  result.sentence.append(": ").append(cause.sentence);
  result.about.insert(result.about.end(), cause.about.begin(), cause.about.end());
  append(result.because, std::move(cause.because));
}

/// Why an atom is true or false.
Explanation Walk::atom(const condition::Atom& atom) {
  switch (atom.kind) {
    case condition::Atom::Kind::settled: {
      States goals;
      if (!holds(atom, view_)) goals.set(atom.state);
      return unit(atom.of, goals);
    }
    case condition::Atom::Kind::moving:
      return unit(atom.of);
    case condition::Atom::Kind::bit:
    case condition::Atom::Kind::number:
      return symbol(atom.of);
    case condition::Atom::Kind::compare:
      return thing(reference_of(atom));
    case condition::Atom::Kind::parts:
      break;
  }
  return location(atom.of);
}

/// What a value is now.
Explanation Walk::value(std::uint32_t output) const {
  const Reference self{Reference::Kind::value, output};
  const std::optional<double> now = view_.output(output);
  return {name_of(self, names_) + (now ? fmt::format(" is {}", *now) : ""), {self}, {}};
}

std::vector<Explanation> Walk::causes_of(const condition::Tree& changes) {
  return causes(atoms_of(changes), [this](const condition::Atom& each) { return atom(each); });
}

bool Walk::add_need(Explanation& result, std::string_view before, const Network& network) {
  if (holds(network, view_)) return false;
  const condition::Tree changes = changes_of(network, view_);
  result.sentence += before;
  if (changes.kind == condition::Tree::Kind::constant) {
    result.sentence += " can never hold";
    return true;
  }
  result.sentence += " needs " + condition_text(changes, names_);
  append(result.because, causes_of(changes));
  return true;
}

using trace::seconds;
using trace::since_words;

/// Whether an operation is on, or an inverted one is off.
bool Walk::commands(std::uint32_t operation) const {
  return (view_.value(operation) != 0) != tables_.symbols[operation].inverted();
}

/// `Y0008 (operation OPEN, body-shop.csv:30)`; with `to`, if the operation has another name, `(operation PUSH to P2,
/// ...)`; of an inverted one `(inverted, operation OPEN, ...)`.
std::string Walk::operation_head(std::uint32_t operation, std::string_view to) const {
  const std::string_view task = names_.task(operation);
  return fmt::format("{} ({}operation {}{}{}, {})", trace::address_or_name(operation, names_),
                     tables_.symbols[operation].inverted() ? "inverted, " : "", task,
                     to.empty() || to == task ? "" : " to ", to == task ? std::string_view() : to,
                     names_.cite(operation));
}

/// "on" means that an operation commands.
std::string_view Walk::level_words(std::uint32_t operation, bool on) const {
  return tables::level_text(on, tables_.symbols[operation].inverted());
}

/// ", forced by malfunction `wire`"; empty if none overrides the symbol.
std::string Walk::forcing_words(std::uint32_t symbol) const {
  const std::string by = trace::overriding_malfunction(symbol, names_, view_.malfunctions());
  return by.empty() ? by : ", forced by " + by;
}

/// `Y0008 (operation OPEN, body-shop.csv:30) has been on since 21.9 s`.
std::string Walk::operation_words(std::uint32_t operation, std::string_view to) const {
  std::string text = operation_head(operation, to);
  const tables::Time rose = view_.rose(operation);
  if (commands(operation)) {
    text += fmt::format(" has been {} {}", level_words(operation, true), since_words(std::max<tables::Time>(rose, 0))) +
            trace::written_words(operation, rose, names_);
  } else {
    text += rose < 0
                ? fmt::format(" has never been {}", level_words(operation, true))
                : fmt::format(" has been {} {}", level_words(operation, false), since_words(view_.since(operation))) +
                      trace::written_words(operation, view_.since(operation), names_);
    const std::string why = view_.unwritten(operation);
    if (!why.empty()) text += " (" + why + ")";
  }
  const std::string forced = view_.forced(operation);
  if (!forced.empty()) text += ", forced " + forced;
  return text + forcing_words(operation);
}

/// `Y0008 (operation OPEN, body-shop.csv:30) was on from 3 s to 4 s`.
std::string Walk::last_words(std::uint32_t operation) const {
  return fmt::format("{} was {} from {} to {}", operation_head(operation), level_words(operation, true),
                     seconds(view_.rose(operation)), seconds(view_.since(operation)));
}

/// The operations of a unit that have been on, the latest first.
std::vector<std::uint32_t> Walk::risen_operations(std::uint32_t unit) const {
  std::vector<std::uint32_t> risen;
  for (const std::uint32_t symbol : names_.symbols_of(unit)) {
    if (names_.is_operation(symbol) && view_.rose(symbol) >= 0) risen.push_back(symbol);
  }
  std::stable_sort(risen.begin(), risen.end(),
                   [this](std::uint32_t a, std::uint32_t b) { return view_.rose(a) > view_.rose(b); });
  return risen;
}

/// What led a unit to its state: the operation that came on last, and those that are still on.
std::string Walk::led_words(std::uint32_t unit) const {
  std::string text;
  for (const std::uint32_t symbol : risen_operations(unit)) {
    if (commands(symbol)) {
      text += ", " + operation_words(symbol);
    } else if (text.empty()) {
      text += ", " + last_words(symbol);
    }
  }
  const auto symbols = names_.symbols_of(unit);
  const bool has_operations =
      std::any_of(symbols.begin(), symbols.end(), [this](std::uint32_t symbol) { return names_.is_operation(symbol); });
  return text.empty() && has_operations ? ", none of its operations has been on" : text;
}

std::vector<std::uint32_t> Walk::disablers(std::uint32_t unit) const {
  std::vector<std::uint32_t> units;
  for (const tables::DisableRow& row : index_.disables_of(unit)) {
    const plant::UnitView by = view_.unit(row.by);
    if (!by.moving && by.state == row.state) units.push_back(row.by);
  }
  return units;
}

/// `EXLINE_MB_AGV has been in P1, disabled by EXLINE_MB_DOOR in OPEN1, malfunction `jam` since 3 s`.
std::string Walk::unit_head(std::uint32_t unit) const {
  const plant::UnitView now = view_.unit(unit);
  std::string by;
  if (now.disabled && !now.frozen) {
    for (const std::uint32_t other : disablers(unit)) {
      by += fmt::format("{}{} in {}", by.empty() ? " by " : ", ", names_.unit(other),
                        names_.state(other, view_.unit(other).state));
    }
    const std::string malfunctions = trace::disabling_malfunctions(unit, names_, view_.malfunctions());
    if (!malfunctions.empty()) by += (by.empty() ? " by " : ", ") + malfunctions;
  }
  const std::string slowing = trace::slowing_malfunctions(unit, names_, view_.malfunctions());
  return fmt::format("{} has been in {}{} {}{}{}", names_.unit(unit), trace::state_words(unit, names_, now), by,
                     since_words(view_.unit_since(unit)), slowing.empty() ? "" : ", slowed by ", slowing);
}

/// `EXLINE_MB_AGV_I_P2 has been off since 0.5 s, PLC input X0002, event P2 of EXLINE_MB_AGV (excell.csv:3)`.
std::string Walk::symbol_head(std::uint32_t symbol) const {
  std::string text =
      fmt::format("{} has been {} {}", names_.symbol(symbol),
                  trace::value_text(tables_.symbols[symbol], view_.value(symbol)), since_words(view_.since(symbol)));
  const std::string forced = view_.forced(symbol);
  if (!forced.empty()) text += ", forced " + forced;
  return text + forcing_words(symbol) + ", " + trace::symbol_words(symbol, names_);
}

/// `FIXTURE has part 11 (raw) since 3.2 s`.
std::string Walk::location_head(std::uint32_t location) const {
  constexpr std::size_t kMostNamed = 4;
  const std::vector<PartState> parts = view_.parts(location);
  if (parts.empty()) return fmt::format("{} has no part", names_.location(location));
  std::string text;
  for (std::size_t i = 0; i < parts.size() && i < kMostNamed; ++i) {
    text += fmt::format("{}part {} ({}) {}", i == 0 ? "" : ", ", parts[i].number, names_.part_kind(parts[i].kind),
                        since_words(parts[i].since));
  }
  if (parts.size() > kMostNamed) text += fmt::format(" and {} more", parts.size() - kMostNamed);
  return fmt::format("{} has {}", names_.location(location), text);
}

/// `FIXTURE`, `CV1@1400 mm`.
std::string Walk::place_words(const tables::PartLocation& at) const {
  const std::string name(names_.location(at.location));
  return at.at == tables::kWhole ? name : fmt::format("{}@{}", name, millimeters(at.at));
}

/// `P2`, or `P2 or P3`.
std::string Walk::state_list(std::uint32_t unit, const States& states) const {
  constexpr std::size_t kMostNamed = 4;
  std::string text;
  std::size_t named = 0;
  for (std::size_t state = 0; state < states.size(); ++state) {
    if (!states[state]) continue;
    if (named++ == kMostNamed) return text + fmt::format(" or {} more", states.count() - kMostNamed);
    text.append(text.empty() ? "" : " or ").append(names_.state(unit, static_cast<std::uint8_t>(state)));
  }
  return text;
}

std::string millimeters(std::int64_t micrometers) {
  return fmt::format("{} mm", static_cast<double>(micrometers) / 1000);
}

}  // namespace symplant::why
