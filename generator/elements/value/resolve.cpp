// Resolves the formulas and jumps of values.
#include "elements/value/resolve.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "elements/value/entry.hpp"
#include "elements/value/readers.hpp"
#include "text/ascii.hpp"

namespace symplant::model {
namespace {

using description::Pointer;
using description::ticked;
using tables::ValueKind;

/// Resolves the texts of one value.
class ValueResolver {
 public:
  ValueResolver(PlantModel& plant, Value& value, ConditionReader& conditions, MadeNames& made,
                description::Faults& faults)
      : plant_(plant),
        value_(value),
        given_(plant.description->values[value.given]),
        conditions_(conditions),
        made_(made),
        faults_(faults),
        here_(pointer()) {
    if (value.matched != kNone) matched_ = MatchedNames::of(plant, plant.units[value.matched], given_.for_each);
  }

  void run() {
    switch (value_.row.kind) {
      case ValueKind::parameter:
      case ValueKind::noise:
        break;
      case ValueKind::position:
        position();
        break;
      case ValueKind::pid:
        formula(given_.of, here_ / "pid" / "of");
        formula(given_.to, here_ / "pid" / "to");
        break;
      case ValueKind::linear:
        for (std::size_t i = 0; i < given_.u.size(); ++i) formula(given_.u[i], here_ / "linear" / "u" / i);
        break;
      default:
        formula(given_.formula, here_ / tables::value_kind_name(value_.row.kind));
        if (value_.row.kind != ValueKind::ramp) break;
        formula(given_.up, here_ / "up");
        if (!given_.down.empty()) formula(given_.down, here_ / "down");
    }
    for (std::size_t i = 0; i < given_.changes.size(); ++i) change(given_.changes[i], here_ / "changes" / i);
    if (matched_) made_.takes(here_);
    if (!lacking_.empty()) made_.lacks(here_, plant_.units[value_.matched].device_path(), std::move(lacking_));
    if (!sound_) leave_out();
  }

 private:
  Pointer pointer() const {
    const Pointer here = Pointer("/values") / std::string_view(given_.name);
    return given_.for_each.empty() ? here : here.matched_by(given_.for_each);
  }

  void formula(const std::string& text, const Pointer& here) {
    condition::Formula resolved;
    if (read(text, here, resolved)) {
      value_.formulas.push_back(std::move(resolved));
    } else {
      sound_ = false;
    }
  }

  bool read(const std::string& text, const Pointer& here, condition::Formula& resolved) {
    return conditions_.formula(text, matched_ ? &*matched_ : nullptr, here, resolved, &lacking_);
  }

  void change(const description::GivenChange& given, const Pointer& here) {
    Change change;
    const bool when = matched_ ? conditions_.resolve_made(given.when, *matched_, here / "when", change.when, &lacking_)
                               : conditions_.resolve(given.when, here / "when", change.when);
    const bool to = read(given.to, here / "to", change.to);
    if (when && to) {
      value_.changes.push_back(std::move(change));
    } else {
      sound_ = false;
    }
  }

  void position() {
    std::string device = given_.formula;
    if (matched_) {
      auto made = conditions_.make(device, *matched_, here_ / "position");
      if (!made) {
        sound_ = false;
        return;
      }
      device = std::move(*made);
    }
    const std::size_t dot = device.find('.');
    const std::string_view facet = dot == device.npos ? std::string_view() : std::string_view(device).substr(dot + 1);
    const auto unit = conditions_.names().unit(std::string_view(device).substr(0, dot), facet);
    if (!unit) {
      std::string message =
          description::missing("device " + ticked(device),
                               conditions_.names().nearest_device(std::string_view(device).substr(0, dot), facet));
      sound_ = false;
      if (matched_) {
        lacking_ = std::move(message);
      } else {
        faults_.add(here_ / "position", std::move(message), description::FaultKind::unknown_name);
      }
      return;
    }
    value_.row.unit = *unit;
    read_states(plant_.units[*unit]);
    watch(*unit, plant_.units[*unit].states.size());
  }

  void read_states(const Unit& unit) {
    value_.numbers.assign(unit.states.size(), 0);
    std::vector<bool> known(unit.states.size());
    for (const auto& [name, number] : given_.at) {
      const std::size_t state = state_of(unit, name);
      if (state == unit.states.size()) {
        const auto state_name = [&](std::size_t i) -> std::string_view { return unit.states[i].name; };
        faults_.add(here_ / "at", description::missing("state " + ticked(name) + " of " + ticked(unit.path),
                                                       faults_.nearest(name, unit.states.size(), state_name)));
        sound_ = false;
        continue;
      }
      value_.numbers[state] = number;
      known[state] = true;
    }
    for (std::size_t s = 0; s < unit.states.size(); ++s) {
      if (known[s]) continue;
      faults_.add(here_ / "at", "state " + ticked(unit.states[s].name) + " of " + ticked(unit.path) +
                                    " has no number; add it to `at`");
      sound_ = false;
    }
  }

  /// A formula that reads all that a position depends on, so that the position is computed when it changes.
  void watch(std::uint32_t unit, std::size_t states) {
    condition::Formula formula;
    formula.steps.push_back({tables::FormulaOp::input, 0, 0});
    condition::FormulaInput input;
    input.kind = condition::FormulaInput::Kind::atom;
    input.atom.of = unit;
    input.atom.kind = condition::Atom::Kind::moving;
    formula.inputs.push_back(input);
    input.atom.kind = condition::Atom::Kind::settled;
    for (std::size_t s = 0; s < states; ++s) {
      input.atom.state = static_cast<std::uint8_t>(s);
      formula.inputs.push_back(input);
    }
    value_.formulas.push_back(std::move(formula));
  }

  /// A rest state that no symbol names may be called `rest`.
  static std::size_t state_of(const Unit& unit, std::string_view name) {
    for (std::size_t s = 0; s < unit.states.size(); ++s) {
      if (text::equal_ignoring_case(unit.states[s].name, name)) return s;
    }
    if (!text::equal_ignoring_case(name, "rest") || unit.rest == kNone) return unit.states.size();
    const State& rest = unit.states[unit.rest];
    return rest.operation == kNone && rest.event == kNone ? unit.rest : unit.states.size();
  }

  /// A fault is reported, or the device lacks a name: the value keeps its place, so that others may name it.
  void leave_out() {
    const tables::ValueRow kept = value_.row;
    value_.row = {};
    value_.row.min = kept.min;
    value_.row.max = kept.max;
    value_.row.start = kept.start;
    value_.row.output = kept.output;
    value_.row.outputs = kept.outputs;
    value_.formulas.clear();
    value_.numbers.clear();
    value_.changes.clear();
  }

  PlantModel& plant_;
  Value& value_;
  const description::GivenValue& given_;
  ConditionReader& conditions_;
  MadeNames& made_;
  description::Faults& faults_;
  const Pointer here_;
  std::optional<MatchedNames> matched_;
  std::string lacking_;
  bool sound_ = true;
};

/// Whether the output of a value follows its inputs in the same computation.
bool is_direct(const Value& value) {
  switch (value.row.kind) {
    case ValueKind::is:
    case ValueKind::derivative:
    case ValueKind::pid:
      return true;
    case ValueKind::linear:
      return value.row.direct;
    default:
      return false;
  }
}

}  // namespace

void resolve_values(PlantModel& plant, ConditionReader& conditions, MadeNames& made, description::Faults& faults) {
  for (Value& value : plant.values) ValueResolver(plant, value, conditions, made, faults).run();
  value_order(plant, &faults);
}

std::vector<std::uint32_t> value_order(const PlantModel& plant, description::Faults* faults) {
  const std::vector<std::uint32_t> value_of = values_of_outputs(plant);
  enum class Mark : std::uint8_t { fresh, open, done };
  std::vector<Mark> marks(plant.values.size(), Mark::fresh);
  std::vector<std::uint32_t> order;
  struct Level {
    std::uint32_t value;
    std::vector<std::uint32_t> reads;
    std::size_t next = 0;
  };
  const auto level = [&](std::uint32_t v) {
    Level made{v, {}, 0};
    if (!is_direct(plant.values[v])) return made;
    for (const condition::Formula& formula : plant.values[v].formulas) {
      for (const condition::FormulaInput& input : formula.inputs) {
        if (input.kind == condition::FormulaInput::Kind::output) made.reads.push_back(value_of[input.of]);
      }
    }
    std::sort(made.reads.begin(), made.reads.end());
    return made;
  };
  for (std::uint32_t first = 0; first < plant.values.size(); ++first) {
    if (marks[first] != Mark::fresh || !tables::is_computed(plant.values[first].row.kind)) continue;
    std::vector<Level> open{level(first)};
    marks[first] = Mark::open;
    while (!open.empty()) {
      Level& top = open.back();
      if (top.next == top.reads.size()) {
        marks[top.value] = Mark::done;
        order.push_back(top.value);
        open.pop_back();
        continue;
      }
      const std::uint32_t read = top.reads[top.next++];
      if (marks[read] == Mark::fresh && tables::is_computed(plant.values[read].row.kind)) {
        marks[read] = Mark::open;
        open.push_back(level(read));
      } else if (marks[read] == Mark::open && faults != nullptr) {
        std::string circle = ticked(plant.values[read].name);
        for (std::size_t i = open.size(); i-- > 0;) {
          circle += " reads " + ticked(plant.values[open[i].value].name);
          if (open[i].value == read) break;
        }
        faults->add(Pointer("/values") / std::string_view(plant.description->values[plant.values[read].given].name),
                    ticked(plant.values[read].name) + " depends on itself: " + circle +
                        "; put an `integral`, `lag`, `ramp` or `delay` into the circle");
        return order;
      }
    }
  }
  return order;
}

}  // namespace symplant::model
