// Draws values: their kinds first, so that formulas can name all of them, then what each of them has.
#include "property/random_values.hpp"

#include <algorithm>
#include <cctype>

#include "property/random_formula.hpp"
#include "property/simpler.hpp"

namespace symplant::property {
namespace {

using description::GivenChange;
using description::GivenSignal;
using description::GivenValue;
using tables::kMillisecond;
using tables::ValueKind;

class ValueWriter {
 public:
  ValueWriter(Dice& dice, PlantText& text, const model::PlantModel& model)
      : dice_(dice), text_(text), model_(model), names_(formula_names(model)) {}

  void write() {
    for (description::GivenKind& kind : text_.description.material.kinds) kind.weight = dice_.pick(kWeights);
    const std::size_t signals = dice_.below(4);
    for (std::size_t i = 0; i < signals; ++i) draw_symbol(i);
    draw_kinds();
    for (GivenValue& given : values()) {
      draw_settings(given);
      draw_own(given);
      if (is_jumping(given.kind) && dice_.percent(45)) draw_changes(given);
    }
    if (dice_.percent(12)) draw_loop();
    for (std::size_t i = 0; i < signals; ++i) draw_signal(i);
  }

 private:
  std::vector<GivenValue>& values() { return text_.description.values; }

  static bool is_jumping(ValueKind kind) {
    return kind == ValueKind::parameter || kind == ValueKind::integral || kind == ValueKind::lag ||
           kind == ValueKind::ramp;
  }
  /// In one computation it reads others: only those before it, so that there is no circle.
  static bool reads_at_once(const GivenValue& given) {
    return given.kind == ValueKind::is || given.kind == ValueKind::derivative || given.kind == ValueKind::pid ||
           (given.kind == ValueKind::linear && !given.d.empty());
  }

  void draw_kinds() {
    const std::size_t count = 2 + dice_.below(dice_.percent(80) ? 6 : 14);
    for (std::size_t i = 0; i < count; ++i) {
      GivenValue given;
      given.kind = i == 0 ? ValueKind::parameter : dice_.pick(kKinds);
      given.name = "v" + std::to_string(i) + (dice_.percent(30) ? ".x" : "");
      if (given.kind == ValueKind::position && !set_position(given)) given.kind = ValueKind::is;
      if (given.kind == ValueKind::linear) draw_matrices(given);
      for (const std::string& output : outputs_of(given)) {
        (reads_at_once(given) ? later_ : names_.values).push_back(output);
      }
      values().push_back(std::move(given));
    }
    dice_.shuffle(values());
  }

  static std::vector<std::string> outputs_of(const GivenValue& given) {
    const std::size_t count = given.kind == ValueKind::linear ? given.c.size() : 1;
    if (count == 1) return {given.name};
    std::vector<std::string> outputs;
    for (std::size_t i = 1; i <= count; ++i) outputs.push_back(given.name + "[" + std::to_string(i) + "]");
    return outputs;
  }

  void draw_settings(GivenValue& given) {
    if (dice_.percent(40)) given.min = dice_.pick(kLeast);
    if (dice_.percent(40)) given.max = dice_.pick(kMost);
    if (is_jumping(given.kind) || given.kind == ValueKind::delay) {
      if (dice_.percent(60))
        given.start = std::clamp(random_value_number(dice_), given.min.value_or(-1e9), given.max.value_or(1e9));
      // A start is 0 by default, which is limited.
    }
    if (given.kind != ValueKind::parameter && dice_.percent(70)) given.step = dice_.pick(kSteps);
    if (dice_.percent(30)) given.trace = dice_.pick(kTraces);
  }

  tables::Time step_of(const GivenValue& given) const { return given.step.value_or(text_.description.defaults.step); }

  /// What others have read is not changed any more: only formulas and numbers.
  void draw_own(GivenValue& given) {
    switch (given.kind) {
      case ValueKind::integral:
        given.formula = formula();
        if (dice_.percent(12)) overflow(given);
        break;
      case ValueKind::lag:
        given.formula = formula();
        given.time = dice_.pick(kTimes);
        break;
      case ValueKind::ramp:
        given.formula = formula();
        given.up = dice_.percent(60) ? random_literal(dice_) : formula();
        if (dice_.percent(50)) given.down = dice_.percent(60) ? random_literal(dice_) : formula();
        break;
      case ValueKind::delay:
        given.formula = formula();
        given.time = step_of(given) * static_cast<tables::Time>(1 + dice_.below(dice_.percent(70) ? 4 : 40));
        break;
      case ValueKind::derivative:
      case ValueKind::is:
        given.formula = formula_of_earlier();
        break;
      case ValueKind::noise:
        given.noise = dice_.pick(kDeviations);
        break;
      case ValueKind::pid:
        draw_controller(given);
        break;
      case ValueKind::linear:
        for (std::string& u : given.u) u = given.d.empty() ? formula() : formula_of_earlier();
        break;
      case ValueKind::parameter:
      case ValueKind::position:
        break;
    }
    if (!reads_at_once(given)) return;
    const std::vector<std::string> outputs = outputs_of(given);
    earlier_.insert(earlier_.end(), outputs.begin(), outputs.end());
  }

  /// Its steps are not finite while another value is small.
  void overflow(GivenValue& given) {
    FormulaNames all = names_;
    all.values.insert(all.values.end(), later_.begin(), later_.end());
    given.formula = "if(" + dice_.pick(all.values) + " > ";
    given.formula += random_literal(dice_) + ", 1e-3, 1e308)";
    given.start = 1.797e308;
    given.min.reset();
    given.max.reset();
  }

  /// Reads every value.
  std::string formula() {
    FormulaNames all = names_;
    all.values.insert(all.values.end(), later_.begin(), later_.end());
    return random_formula(dice_, all, size());
  }
  /// Reads values that make steps, and those of the others that come before it in the file.
  std::string formula_of_earlier() {
    FormulaNames all = names_;
    all.values.insert(all.values.end(), earlier_.begin(), earlier_.end());
    return random_formula(dice_, all, size());
  }
  std::size_t size() { return 1 + dice_.below(dice_.percent(80) ? 4 : 9); }

  void draw_controller(GivenValue& given) {
    given.of = formula_of_earlier();
    given.to = dice_.percent(50) ? random_literal(dice_) : formula_of_earlier();
    given.kp = dice_.pick(kGains);
    if (dice_.percent(70)) given.ti = dice_.pick(kTimes);
    if (dice_.percent(50)) given.td = dice_.pick(kTimes);
    if (dice_.percent(60)) {
      given.min = 0;
      given.max = 1 + static_cast<double>(dice_.below(10));
    }
  }

  bool set_position(GivenValue& given) {
    if (model_.units.empty()) return false;
    const model::Unit& unit = model_.units[dice_.below(std::min<std::size_t>(model_.units.size(), 12))];
    given.formula = std::string(unit.path);
    for (std::uint32_t i = 0; i < unit.states.size(); ++i) {
      const model::State& state = unit.states[i];
      const bool unnamed = state.operation == model::kNone && state.event == model::kNone && unit.rest == i;
      given.at.emplace_back(unnamed && dice_.percent(50) ? "rest" : state.name, random_value_number(dice_));
    }
    return !given.at.empty();
  }

  description::Matrix matrix(std::size_t rows, std::size_t columns) {
    description::Matrix made(rows);
    for (std::vector<double>& row : made) {
      for (std::size_t i = 0; i < columns; ++i) row.push_back(dice_.pick(kEntries));
    }
    return made;
  }

  void draw_matrices(GivenValue& given) {
    const std::size_t states = 1 + dice_.below(3);
    const std::size_t inputs = 1 + dice_.below(2);
    const std::size_t outputs = 1 + dice_.below(dice_.percent(50) ? 1 : 3);
    given.a = matrix(states, states);
    given.b = matrix(states, inputs);
    given.c = matrix(outputs, states);
    if (dice_.percent(40)) given.d = matrix(outputs, inputs);
    given.u.resize(inputs);
    if (!dice_.percent(50)) return;
    for (std::size_t i = 0; i < states; ++i) given.start_states.push_back(random_value_number(dice_));
  }

  void draw_changes(GivenValue& given) {
    FormulaNames all = names_;
    all.values.insert(all.values.end(), later_.begin(), later_.end());
    const std::size_t count = 1 + dice_.below(3);
    for (std::size_t i = 0; i < count; ++i) {
      GivenChange& change = given.changes.emplace_back();
      change.when = random_value_condition(dice_, all);
      // Two entries with one condition act in one round.
      if (i > 0 && dice_.percent(30)) change.when = given.changes.front().when;
      change.to = dice_.percent(40)   ? given.name + " + " + random_literal(dice_)
                  : dice_.percent(30) ? random_literal(dice_)
                                      : random_formula(dice_, all, size());
    }
  }

  /// A value that jumps in every round, or two that make each other jump.
  void draw_loop() {
    GivenValue one;
    one.name = "loop";
    const bool two = dice_.percent(40);
    const std::string other = two ? "echo" : "loop";
    one.changes = {{other + " = 0", "1"}, {other + " = 1", "0"}};
    values().push_back(one);
    if (!two) return;
    one.name = "echo";
    one.changes = {{"loop = 1", "1"}, {"loop = 0", "0"}};
    values().push_back(one);
  }

  /// A symbol for a signal, with an address that no other row has. Formulas name it.
  void draw_symbol(std::size_t number) {
    static const std::vector<std::pair<std::string, std::string>> kSignalTypes = {
        {"SINT", "B118"}, {"INT", "W58"},  {"UINT", "W58"}, {"WORD", "W58"},  {"DINT", "D29"},
        {"UDINT", "D29"}, {"REAL", "D29"}, {"LINT", "L15"}, {"ULINT", "L15"}, {"LREAL", "L15"}};
    const auto& [type, address] = dice_.pick(kSignalTypes);
    const std::string name = "SIG" + std::to_string(number);
    text_.rows.push_back({name, "%I" + address + std::to_string(500 + number), type, dice_.percent(20) ? "1" : ""});
    for (auto* names : {&names_.plant, &names_.numbers}) names->push_back(name);
  }

  void draw_signal(std::size_t number) {
    GivenSignal signal;
    signal.symbol = "SIG" + std::to_string(number);
    signal.of = formula();
    if (dice_.percent(40)) {
      signal.from = {0, 1 + static_cast<double>(dice_.below(100))};
      signal.to = dice_.percent(50) ? std::array<double, 2>{0, 27648} : std::array<double, 2>{-10, 4.5};
    }
    if (dice_.percent(30)) signal.limit = {0, 1 + static_cast<double>(dice_.below(100))};
    if (dice_.percent(35)) signal.noise = dice_.pick(kDeviations);
    if (dice_.percent(60)) signal.every = dice_.pick(kSteps);
    text_.description.signals.push_back(std::move(signal));
  }

  static inline const std::vector<ValueKind> kKinds = {
      ValueKind::parameter, ValueKind::integral,   ValueKind::integral, ValueKind::lag, ValueKind::ramp,
      ValueKind::delay,     ValueKind::derivative, ValueKind::is,       ValueKind::is,  ValueKind::position,
      ValueKind::noise,     ValueKind::pid,        ValueKind::linear};
  static inline const std::vector<tables::Time> kSteps = {10 * kMillisecond, 20 * kMillisecond, 50 * kMillisecond,
                                                          5 * kMillisecond,  7 * kMillisecond,  3'000'001};
  static inline const std::vector<tables::Time> kTimes = {10 * kMillisecond, 100 * kMillisecond, tables::kSecond, 1,
                                                          15 * kMillisecond};
  static inline const std::vector<tables::Time> kTraces = {0, 10 * kMillisecond, 30 * kMillisecond, 77'000'000};
  static inline const std::vector<double> kLeast = {0, -1, -10, 0.5};
  static inline const std::vector<double> kMost = {1, 3, 10, 100, 0.75};
  static inline const std::vector<double> kWeights = {0, 0.1, 1, 2.5, 1e16};
  static inline const std::vector<double> kDeviations = {0, 0.5, 1, 5, 1000};
  static inline const std::vector<double> kGains = {0, 1, 4, -2, 0.3};
  static inline const std::vector<double> kEntries = {0, 0, 1, 0.5, -0.25, 0.1, -1, 1.5};

  Dice& dice_;
  PlantText& text_;
  const model::PlantModel& model_;
  FormulaNames names_;
  std::vector<std::string> later_;    ///< outputs of values that read others in one computation
  std::vector<std::string> earlier_;  ///< those of them that have a formula
};

const std::vector<tables::Time> kStarts = {10 * kMillisecond, 25 * kMillisecond, 40 * kMillisecond, 5'000'003};

/// The names of all outputs, for conditions.
FormulaNames names_of_values(const PlantText& text) {
  FormulaNames names;
  for (const GivenValue& given : text.description.values) {
    const std::size_t outputs = given.kind == ValueKind::linear ? given.c.size() : 1;
    for (std::size_t i = 1; i <= outputs; ++i) {
      names.values.push_back(outputs == 1 ? given.name : given.name + "[" + std::to_string(i) + "]");
    }
  }
  return names;
}

}  // namespace

void add_random_values(Dice& dice, PlantText& text, const model::PlantModel& model) {
  ValueWriter(dice, text, model).write();
}

void let_conditions_read_values(Dice& dice, PlantText& text) {
  const FormulaNames names = names_of_values(text);
  if (names.values.empty()) return;
  const auto extend = [&](std::string& condition) {
    if (condition.empty() || !dice.percent(30)) return;
    std::string comparison = dice.percent(25) ? "not " : "";
    comparison += random_comparison(dice, names);
    const std::size_t kind = dice.below(3);
    condition = kind == 0 ? comparison : "(" + condition + (kind == 1 ? ") and " : ") or ") + comparison;
  };
  for (description::DeviceDescription& device : text.description.devices) {
    for (description::GivenTransition& transition : device.transitions) {
      if (transition.automatic && transition.when.empty() && dice.percent(15)) {
        transition.when = random_comparison(dice, names);
      }
      extend(transition.when);
      extend(transition.during);
    }
    for (auto& [name, condition] : device.inputs) extend(condition);
  }
  for (description::GivenFollow& follow : text.description.follow) extend(follow.condition);
  for (description::GivenRequirement& requirement : text.description.requirements) {
    for (std::string* condition : {&requirement.never, &requirement.after, &requirement.expect}) extend(*condition);
  }
  const auto extend_each = [&](std::string& condition, bool) { extend(condition); };
  each_condition(text.description.material, extend_each);
  each_condition(text.description.malfunctions, extend_each);
}

void let_times_read_values(Dice& dice, PlantText& text) {
  const FormulaNames names = names_of_values(text);
  const auto compute = [&](std::optional<description::Duration>& time) {
    if (!time || !dice.percent(12)) return;
    std::string formula = random_formula(dice, names, 1 + dice.below(3));
    if (dice.percent(70)) formula = "limit(" + formula + ", 0, 0.2)";
    time = description::Duration::seconds(std::move(formula));
  };
  for (description::DeviceDescription& device : text.description.devices) {
    for (description::GivenTransition& transition : device.transitions) {
      compute(transition.after);
      compute(transition.takes);
    }
  }
}

void let_followers_switch(Dice& dice, PlantText& text) {
  const FormulaNames names = names_of_values(text);
  for (description::GivenFollow& follow : text.description.follow) {
    if (names.values.empty() || !dice.percent(40)) continue;
    if (dice.percent(50)) follow.condition = random_comparison(dice, names);
    follow.off = dice.percent(70) ? random_comparison(dice, names) : "not (" + follow.condition + ")";
  }
}

void add_malfunctions_of_values(Dice& dice, PlantText& text) {
  const auto add = [&](description::GivenEffect effect) {
    auto& all = text.description.malfunctions;
    if (!all.empty() && !all.back().effects.empty() && dice.percent(40)) {
      all.back().effects.push_back(std::move(effect));
      return;
    }
    description::GivenMalfunction& given = all.emplace_back();
    given.name = "w" + std::to_string(all.size());
    given.one = std::move(effect);
    if (dice.percent(40)) given.chance = description::Duration::fixed(dice.pick(kStarts));
    if (dice.percent(50)) given.lasts = description::Duration::fixed(dice.pick(kStarts));
  };
  std::vector<std::string> parameters;
  for (const GivenValue& given : text.description.values) {
    if (given.kind == ValueKind::parameter) parameters.push_back(given.name);
  }
  for (std::size_t i = dice.below(3); !parameters.empty() && i > 0; --i) {
    description::GivenEffect effect;
    effect.kinds = {tables::MalfunctionKind::set};
    effect.set.emplace_back(dice.pick(parameters), random_value_number(dice));
    if (parameters.size() > 1 && dice.percent(30)) effect.set.emplace_back(parameters.back(), 7.5);
    add(std::move(effect));
  }
  for (std::size_t i = dice.below(4); !text.description.signals.empty() && i > 0; --i) {
    static const std::vector<double> kNumbers = {0, 0.5, 1, -3, 100};
    description::GivenEffect effect;
    effect.kinds = {tables::MalfunctionKind::distort};
    effect.distort.symbol = dice.pick(text.description.signals).symbol;
    if (dice.percent(60)) effect.distort.gain = dice.pick(kNumbers);
    if (dice.percent(60)) effect.distort.offset = dice.pick(kNumbers);
    if (dice.percent(50)) effect.distort.drift = dice.pick(kNumbers);
    add(std::move(effect));
  }
}

void let_drives_read_values(Dice& dice, PlantText& text) {
  std::vector<std::string> names;
  for (const GivenValue& given : text.description.values) {
    if (given.c.size() <= 1 && given.for_each.empty()) names.push_back(given.name);
  }
  if (names.empty()) return;
  for (description::GivenTrack& track : text.description.material.tracks) {
    for (description::GivenDrive& drive : track.drives) {
      if (!drive.speed.of.empty() && dice.percent(40)) drive.speed.of = dice.pick(names);
    }
  }
}

std::string random_settable_value(Dice& dice, const description::Description& description) {
  std::vector<std::string> names;
  for (const GivenValue& given : description.values) {
    const bool settable = given.kind == ValueKind::parameter || given.kind == ValueKind::integral ||
                          given.kind == ValueKind::lag || given.kind == ValueKind::ramp;
    if (settable) names.push_back(given.name);
  }
  if (names.empty()) return "none";
  std::string name = dice.pick(names);
  if (dice.percent(10)) {
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return name;
}

double random_value_number(Dice& dice) {
  static const std::vector<double> kNumbers = {0, 1, 2, 3, 0.5, -1, 10, 80, 0.1, -2.5, 1e3, 27648, 1e300, -0.0};
  return dice.pick(kNumbers);
}

}  // namespace symplant::property
