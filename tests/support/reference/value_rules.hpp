// What the reference derives of values and signals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "elements/value/given.hpp"
#include "support/reference/formula.hpp"
#include "support/reference/value_condition.hpp"
#include "symplant/tables/time.hpp"
#include "symplant/tables/value.hpp"

namespace symplant::reference {

struct Rules;

struct ChangeRules {
  CompareTree when;
  Formula to;
};

struct ValueRules {
  std::string name;
  tables::ValueKind kind{};
  double start = 0;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  tables::Time step = 0;   ///< 0: a parameter
  tables::Time trace = 0;  ///< 0: never
  /// u; `ramp`: u, up, and down if it is given; `pid`: of, to; `linear`: each u. The others have none.
  std::vector<Formula> inputs;
  double factor = 0;       ///< `lag`: a; `noise`: s; `pid`: kp
  double ti = 0;           ///< `pid`, in seconds; 0: none
  double td = 0;           ///< `pid`, in seconds
  std::size_t length = 0;  ///< `delay`: the stored inputs that it holds
  std::uint32_t unit = 0;  ///< `position`
  std::vector<double> at;  ///< `position`: of each state
  description::Matrix a;   ///< `linear`, with the next ones
  description::Matrix b;
  description::Matrix c;
  description::Matrix d;
  std::vector<double> start_states;
  std::size_t outputs = 1;
  std::vector<std::uint32_t> traced;  ///< outputs
  std::vector<ChangeRules> changes;

  double h() const { return static_cast<double>(step) / 1e9; }
  /// Step 1 of docs/values.md 3: it stores inputs, and makes steps from them.
  bool steps() const {
    using tables::ValueKind;
    return kind == ValueKind::integral || kind == ValueKind::lag || kind == ValueKind::ramp ||
           kind == ValueKind::delay || kind == ValueKind::linear;
  }
  bool can_be_set() const {
    using tables::ValueKind;
    return kind == ValueKind::parameter || kind == ValueKind::integral || kind == ValueKind::lag ||
           kind == ValueKind::ramp;
  }
  std::string output_name(std::uint32_t output) const {
    return outputs == 1 ? name : name + "[" + std::to_string(output + 1) + "]";
  }
};

struct SignalRules {
  std::uint32_t symbol = 0;
  Formula of;
  tables::Time every = 0;
  bool scaled = false;
  double a = 0;
  double b = 0;
  double c = 0;
  double d = 0;
  double noise = 0;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// The symbols of signals: before units are derived. A name beats patterns, the most specific pattern wins.
void derive_signal_symbols(Rules& rules);
/// All else, after units. What cannot be resolved is in Rules::fault.
void derive_values(Rules& rules);

// Names (value_names.cpp).
/// What a name means. Throws std::runtime_error if it means nothing.
Input resolve_name(const Rules& rules, const DottedName& name);
void resolve(const Rules& rules, Formula& formula);
void resolve(const Rules& rules, CompareTree& tree);
/// The number of a value with this name, in any case of its letters; kNone without one.
std::uint32_t find_value(const Rules& rules, const std::string& name);

/// Output `number` of all outputs, in the order of their values.
Input output_at(const Rules& rules, std::uint32_t number);

/// Replaces names in braces. `levels`: line, process, device and self, as in docs/plant-description.md; `shares`: what
/// the wildcards of the pattern matched.
std::string replace_braces(const std::string& text, const std::vector<std::string>& levels,
                           const std::vector<std::string>& shares);

}  // namespace symplant::reference
