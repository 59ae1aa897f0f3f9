// Reads `values` of a plant.json.
#include "elements/value/entry.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

namespace symplant::description {
namespace {

using Json = nlohmann::json;
using tables::ValueKind;

/// A key that gives a value its kind, and the keys that only this kind has, each between blanks.
struct ValueKey {
  std::string_view key;
  ValueKind kind;
  std::string_view others;
};
constexpr std::array kValueKeys{ValueKey{"integral", ValueKind::integral, ""},
                                ValueKey{"lag", ValueKind::lag, " time "},
                                ValueKey{"ramp", ValueKind::ramp, " up down "},
                                ValueKey{"delay", ValueKind::delay, " time "},
                                ValueKey{"derivative", ValueKind::derivative, ""},
                                ValueKey{"is", ValueKind::is, ""},
                                ValueKey{"position", ValueKind::position, " at "},
                                ValueKey{"noise", ValueKind::noise, " every "},
                                ValueKey{"pid", ValueKind::pid, ""},
                                ValueKey{"linear", ValueKind::linear, ""}};

/// The keys that values of some kinds have, with the words for a message.
struct LimitedKey {
  std::string_view key;
  std::string_view of;
};
constexpr std::array kLimitedKeys{LimitedKey{"time", "`lag` and `delay`"}, LimitedKey{"up", "`ramp`"},
                                  LimitedKey{"down", "`ramp`"}, LimitedKey{"at", "`position`"},
                                  LimitedKey{"every", "`noise`"}};

std::optional<double> real_member(const Json& object, std::string_view key) {
  const Json* value = member(object, key);
  if (value == nullptr || !value->is_number()) return {};
  return value->get<double>();
}

std::vector<double> numbers_of(const Json& array) {
  std::vector<double> numbers;
  for (const Json& number : array) {
    if (number.is_number()) numbers.push_back(number.get<double>());
  }
  return numbers;
}

Matrix matrix_member(const Json& object, std::string_view key) {
  Matrix matrix;
  const Json* rows = member(object, key);
  if (rows == nullptr || !rows->is_array()) return matrix;
  for (const Json& row : *rows) matrix.push_back(row.is_array() ? numbers_of(row) : std::vector<double>());
  return matrix;
}

class ValueReader {
 public:
  ValueReader(const std::string& name, const Json& entry, ShapeFaults& faults)
      : entry_(entry), here_(Pointer("/values") / std::string_view(name)), faults_(faults) {
    value_.name = name;
  }

  GivenValue read() {
    check_text(value_.name, here_, faults_);
    value_.for_each = text_or_empty(entry_, "for");
    value_.unit = text_or_empty(entry_, "unit");
    check_text(value_.unit, here_ / "unit", faults_);
    const ValueKey* kind = read_kind();
    if (several_) return std::move(value_);
    if (kind != nullptr) value_.kind = kind->kind;
    check_keys(kind);
    value_.min = real_member(entry_, "min");
    value_.max = real_member(entry_, "max");
    read_start();
    value_.step = step_member(entry_, value_.kind == ValueKind::noise ? "every" : "step", here_, faults_);
    read_trace();
    if (kind != nullptr) read_members();
    read_changes();
    return std::move(value_);
  }

 private:
  /// Null for a parameter, and if there are several, which is a fault.
  const ValueKey* read_kind() {
    const ValueKey* found = nullptr;
    for (const ValueKey& kind : kValueKeys) {
      if (member(entry_, kind.key) == nullptr) continue;
      if (found != nullptr) {
        faults_.add(here_ / kind.key,
                    ticked(found->key) + " and " + ticked(kind.key) + " are two kinds of values; write two values",
                    FaultKind::contradiction);
        several_ = true;
        return nullptr;
      }
      found = &kind;
    }
    return found;
  }

  void check_keys(const ValueKey* kind) {
    for (const LimitedKey& limited : kLimitedKeys) {
      if (member(entry_, limited.key) == nullptr) continue;
      const std::string word = " " + std::string(limited.key) + " ";
      if (kind != nullptr && kind->others.find(word) != kind->others.npos) continue;
      refuse(limited.key, "only a value with " + std::string(limited.of) + " has " + ticked(limited.key) +
                              "; remove it, or add the other key");
    }
    if (member(entry_, "start") != nullptr && !tables::keeps_its_output(value_.kind) &&
        value_.kind != ValueKind::delay && value_.kind != ValueKind::linear) {
      refuse("start", "a value with " + ticked(tables::value_kind_name(value_.kind)) + " has no `start`; remove it");
    }
    if (member(entry_, "changes") != nullptr && !tables::keeps_its_output(value_.kind)) {
      refuse("changes", "a value with " + ticked(tables::value_kind_name(value_.kind)) +
                            " follows its formula at each step and cannot jump; remove `changes`");
    }
    if (member(entry_, "step") != nullptr && value_.kind == ValueKind::parameter) {
      refuse("step", "a parameter has no `step`; remove it");
    }
    if (member(entry_, "step") != nullptr && value_.kind == ValueKind::noise) {
      refuse("step", "the step of `noise` is `every`; write `every`");
    }
  }

  void refuse(std::string_view key, std::string message) {
    faults_.add(here_ / key, std::move(message), FaultKind::contradiction);
  }

  void read_start() {
    const Json* start = member(entry_, "start");
    if (start == nullptr) return;
    if (start->is_number() && value_.kind != ValueKind::linear) value_.start = start->get<double>();
    if (start->is_array() && value_.kind == ValueKind::linear) value_.start_states = numbers_of(*start);
    if (start->is_array() == (value_.kind == ValueKind::linear)) return;
    refuse("start", value_.kind == ValueKind::linear ? "`start` of `linear` is a list of states, as in [0, 0]"
                                                     : "`start` is a number; only `linear` has a list of states");
  }

  void read_trace() {
    const Json* trace = member(entry_, "trace");
    if (trace == nullptr) return;
    if (trace->is_boolean()) {
      if (!trace->get<bool>()) value_.trace = 0;
      return;
    }
    value_.trace = time_member(entry_, "trace", here_, faults_);
    if (value_.trace == tables::Time{0})
      refuse("trace", "`trace` is above 0; write `false` for a value without a trace");
  }

  void read_members() {
    switch (value_.kind) {
      case ValueKind::noise:
        value_.noise = real_member(entry_, "noise").value_or(0);
        return;
      case ValueKind::pid:
        return read_pid();
      case ValueKind::linear:
        return read_linear();
      default:
        break;
    }
    value_.formula = formula_member(entry_, tables::value_kind_name(value_.kind));
    value_.up = formula_member(entry_, "up");
    value_.down = formula_member(entry_, "down");
    if (value_.kind == ValueKind::ramp && value_.up.empty()) {
      faults_.add(here_, "`ramp` needs `up`, its rate per second", FaultKind::shape);
    }
    read_time();
    if (value_.kind == ValueKind::position) read_positions();
  }

  void read_time() {
    if (value_.kind != ValueKind::lag && value_.kind != ValueKind::delay) return;
    value_.time = time_member(entry_, "time", here_, faults_);
    if (member(entry_, "time") == nullptr) {
      faults_.add(here_, ticked(tables::value_kind_name(value_.kind)) + " needs `time`", FaultKind::shape);
    } else if (value_.time == tables::Time{0}) {
      refuse("time", "`time` is above 0");
    }
  }

  void read_positions() {
    const Json* at = member(entry_, "at");
    if (at == nullptr || !at->is_object()) {
      faults_.add(here_, "`position` needs `at`, an object with the number of each state", FaultKind::shape);
      return;
    }
    for (const auto& [state, number] : at->items()) {
      if (number.is_number()) value_.at.emplace_back(state, number.get<double>());
    }
  }

  void read_pid() {
    const Json* pid = member(entry_, "pid");
    if (pid == nullptr || !pid->is_object()) return;
    const Pointer here = here_ / "pid";
    value_.of = formula_member(*pid, "of");
    value_.to = formula_member(*pid, "to");
    value_.kp = real_member(*pid, "kp").value_or(0);
    value_.ti = time_member(*pid, "ti", here, faults_);
    value_.td = time_member(*pid, "td", here, faults_).value_or(0);
    if (value_.ti == tables::Time{0}) {
      faults_.add(here / "ti", "`ti` is above 0; leave it out for a controller without an integral part",
                  FaultKind::contradiction);
    }
  }

  void read_linear() {
    const Json* linear = member(entry_, "linear");
    if (linear == nullptr || !linear->is_object()) return;
    value_.a = matrix_member(*linear, "a");
    value_.b = matrix_member(*linear, "b");
    value_.c = matrix_member(*linear, "c");
    value_.d = matrix_member(*linear, "d");
    const Json* u = member(*linear, "u");
    if (u == nullptr || !u->is_array()) return;
    for (const Json& formula : *u) value_.u.push_back(formula_text(formula));
  }

  void read_changes() {
    const Json* changes = member(entry_, "changes");
    if (changes == nullptr || !changes->is_array()) return;
    for (const Json& change : *changes) {
      value_.changes.push_back({text_or_empty(change, "when"), formula_member(change, "to")});
    }
  }

  const Json& entry_;
  const Pointer here_;
  ShapeFaults& faults_;
  GivenValue value_;
  bool several_ = false;  ///< kinds: a fault
};

}  // namespace

std::vector<GivenValue> value_entries(const Json& object, ShapeFaults& faults) {
  std::vector<GivenValue> values;
  if (!object.is_object()) return values;
  for (const auto& [name, entry] : object.items()) values.push_back(ValueReader(name, entry, faults).read());
  return values;
}

}  // namespace symplant::description
