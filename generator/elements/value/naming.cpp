// Names the values of a plant and numbers their outputs.
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include "elements/value/entry.hpp"
#include "elements/value/resolve.hpp"
#include "text/ascii.hpp"
#include "text/braces.hpp"

namespace symplant::model {
namespace {

using description::FaultKind;
using description::Pointer;
using description::ticked;
using tables::ValueKind;

constexpr std::uint32_t kMostDelaySteps = 100'000;
constexpr std::uint64_t kMostDelayStepsOfPlant = 10'000'000;

/// A name is identifiers joined by dots: letters, digits and `_` of any script.
bool is_name(std::string_view name) {
  const auto is_letter = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  bool in_word = false;
  for (const char c : name) {
    if (c == '.' ? !in_word : !is_letter(c)) return false;
    in_word = c != '.';
  }
  return in_word;
}

class Namer {
 public:
  Namer(PlantModel& plant, description::Faults& faults) : plant_(plant), faults_(faults) {
    for (const Unit& unit : plant.units) taken_.try_emplace(unit.path, "a device");
    for (const Symbol& symbol : plant.symbols) taken_.try_emplace(symbol.name(), "a symbol");
    const auto& material = plant.description->material;
    for (const auto& track : material.tracks) taken_.try_emplace(track.name, "a track");
    for (const auto& place : material.places) taken_.try_emplace(place.name, "a place");
  }

  void run() {
    const auto& given = plant_.description->values;
    for (std::uint32_t i = 0; i < given.size(); ++i) {
      const Pointer here = Pointer("/values") / std::string_view(given[i].name);
      if (given[i].for_each.empty()) {
        if (text::has_braces(given[i].name)) {
          faults_.add(here, "names in braces are replaced only with `for`; add `for`, or write the name");
        } else {
          add(i, given[i].name, kNone, here);
        }
        continue;
      }
      add_for_each(i, here.matched_by(given[i].for_each));
    }
  }

 private:
  void add_for_each(std::uint32_t index, const Pointer& here) {
    const description::GivenValue& given = plant_.description->values[index];
    const bool any = for_each_device(plant_, given.for_each, [&](const Unit& unit) {
      const MatchedNames matched = MatchedNames::of(plant_, unit, given.for_each);
      text::Replaced name = matched.replace(given.name);
      if (name.unknown.empty()) {
        add(index, std::move(name.text), static_cast<std::uint32_t>(&unit - plant_.units.data()), here);
      } else {
        faults_.add(here, ticked(name.unknown) + " is unknown here; use one of " + matched.choices(),
                    FaultKind::unknown_name);
      }
    });
    if (!any) {
      faults_.warn(here / "for", ticked(given.for_each) + " matches no device", FaultKind::matches_nothing);
    }
  }

  void add(std::uint32_t index, std::string name, std::uint32_t matched, const Pointer& here) {
    if (!check(name, here)) return;
    Value value;
    value.given = index;
    value.matched = matched;
    value.unit = plant_.description->values[index].unit;
    set_numbers(plant_.description->values[index], value, here);
    value.name = std::move(name);
    value.row.output = outputs_;
    outputs_ += value.row.outputs;
    plant_.values.push_back(std::move(value));
  }

  bool check(const std::string& name, const Pointer& here) {
    if (!is_name(name)) {
      faults_.add(here, ticked(name) + " is not a name of a value; write letters, digits and `_`, joined by dots");
      return false;
    }
    if (condition::is_formula_word(name)) {
      faults_.add(here, ticked(name) + " is a word of formulas; choose another name");
      return false;
    }
    const std::size_t dot = name.rfind('.');
    if (dot != name.npos &&
        !check_last(name, std::string_view(name).substr(0, dot), std::string_view(name).substr(dot + 1), here)) {
      return false;
    }
    const auto [found, added] = taken_.try_emplace(names_.emplace_back(name), "a value");
    if (!added) {
      faults_.add(here, ticked(name) + " is also the name of " + std::string(found->second) + "; choose another name");
    }
    return added;
  }

  /// `X.y` with a device X that has the state y, or with a word that locations and devices have.
  bool check_last(const std::string& name, std::string_view first, std::string_view last, const Pointer& here) {
    for (const std::string_view word : {"moving", "part", "parts", "weight"}) {
      if (!text::equal_ignoring_case(last, word)) continue;
      faults_.add(here, "a value cannot end in " + ticked("." + std::string(word)) + "; choose another name");
      return false;
    }
    for (const Unit& unit : plant_.units) {
      const std::string_view path = unit.path;
      if (path.size() > first.size() && text::equal_ignoring_case(path, name)) {
        faults_.add(here, ticked(name) + " is a facet of a device; choose another name");
        return false;
      }
      if (!text::equal_ignoring_case(path, first)) continue;
      for (const State& state : unit.states) {
        if (!text::equal_ignoring_case(state.name, last)) continue;
        faults_.add(here, ticked(name) + " is a state of a device; choose another name");
        return false;
      }
    }
    for (const auto& kind : plant_.description->material.kinds) {
      const auto found = taken_.find(first);
      if (found == taken_.end() || (found->second != "a track" && found->second != "a place")) break;
      if (!text::equal_ignoring_case(kind.name, last)) continue;
      faults_.add(here, ticked(name) + " is the parts of a kind at a location; choose another name");
      return false;
    }
    return true;
  }

  void set_numbers(const description::GivenValue& given, Value& value, const Pointer& here) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    tables::ValueRow& row = value.row;
    row.kind = given.kind;
    row.min = given.min.value_or(-kInfinity);
    row.max = given.max.value_or(kInfinity);
    row.start = given.start.value_or(0);
    row.start = row.start_output();
    if (row.min > row.max) {
      faults_.add(here / "min", "`min` is above `max`; exchange them");
    } else if (given.start && *given.start != row.start) {
      faults_.add(here / "start", "`start` is outside of `min` and `max`; write a number between them");
    }
    row.step = given.kind == ValueKind::parameter ? 0 : given.step.value_or(plant_.description->defaults.step);
    row.trace = given.trace.value_or(100 * tables::kMillisecond);
    row.outputs = 1;
    const double h = static_cast<double>(row.step) / 1e9;
    if (given.kind == ValueKind::lag && given.time) {
      row.factor = 1 - std::exp(-h / (static_cast<double>(*given.time) / 1e9));
    }
    if (given.kind == ValueKind::noise) row.factor = given.noise;
    if (given.kind == ValueKind::delay && given.time) set_delay(*given.time, row, here);
    if (given.kind == ValueKind::pid) {
      row.factor = given.kp;
      row.ti = given.ti ? static_cast<double>(*given.ti) / 1e9 : 0;
      row.td = static_cast<double>(given.td) / 1e9;
    }
    if (given.kind == ValueKind::linear) set_linear(given, value, here);
  }

  void set_delay(tables::Time time, tables::ValueRow& row, const Pointer& here) {
    row.steps = 1;
    if (time % row.step != 0) {
      faults_.add(here / "time", "`time` of a delay is a whole multiple of its step; change one of the two");
    } else if (time / row.step > kMostDelaySteps) {
      faults_.add(here / "time", "`time` is more than 100,000 steps; write a longer `step`");
    } else {
      row.steps = static_cast<std::uint32_t>(time / row.step);
      delay_steps_ += row.steps;
      if (delay_steps_ > kMostDelayStepsOfPlant && delay_steps_ - row.steps <= kMostDelayStepsOfPlant) {
        faults_.add(here / "time", "the delays of the plant have more than 10,000,000 steps; write longer steps");
      }
    }
  }

  void set_linear(const description::GivenValue& given, Value& value, const Pointer& here) {
    const std::size_t states = given.a.size();
    const std::size_t inputs = given.u.size();
    value.row.states = static_cast<std::uint32_t>(states);
    value.row.outputs = std::max<std::uint32_t>(1, static_cast<std::uint32_t>(given.c.size()));
    value.row.direct = !given.d.empty();
    const auto fits = [](const description::Matrix& matrix, std::size_t rows, std::size_t columns) {
      return matrix.size() == rows &&
             std::all_of(matrix.begin(), matrix.end(), [&](const auto& row) { return row.size() == columns; });
    };
    const Pointer linear = here / "linear";
    if (!fits(given.a, states, states)) {
      faults_.add(linear / "a", "`a` has as many rows as columns, one for each state");
    } else if (!fits(given.b, states, inputs)) {
      faults_.add(linear / "b", "`b` has a row for each state and a column for each formula of `u`");
    } else if (!fits(given.c, given.c.size(), states)) {
      faults_.add(linear / "c", "`c` has a column for each state");
    } else if (!given.d.empty() && !fits(given.d, given.c.size(), inputs)) {
      faults_.add(linear / "d", "`d` has a row for each row of `c` and a column for each formula of `u`");
    } else if (!given.start_states.empty() && given.start_states.size() != states) {
      faults_.add(here / "start", "`start` has a number for each state");
    } else {
      value.numbers = given.start_states;
      value.numbers.resize(states, 0);
      for (const auto* matrix : {&given.a, &given.b, &given.c, &given.d}) {
        for (const std::vector<double>& row : *matrix) {
          value.numbers.insert(value.numbers.end(), row.begin(), row.end());
        }
      }
    }
  }

  PlantModel& plant_;
  description::Faults& faults_;
  std::deque<std::string> names_;         ///< of values, for `taken_`
  text::ByName<std::string_view> taken_;  ///< names, and what has them
  std::uint32_t outputs_ = 0;
  std::uint64_t delay_steps_ = 0;
};

}  // namespace

void name_values(PlantModel& plant, description::Faults& faults) {
  if (!plant.description->values.empty()) Namer(plant, faults).run();
}

}  // namespace symplant::model
