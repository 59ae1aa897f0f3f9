// A scenario: the actions on a plant and its expected reactions, step by step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "symplant/condition/tree.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::scenario {

/// A symbol and a value in the representation of its plane: 0 or 1, two's complement, or the bits of a double.
struct SymbolValue {
  std::uint32_t symbol;
  std::uint64_t value;
  friend bool operator==(const SymbolValue&, const SymbolValue&) = default;
};

struct UnitState {
  std::uint32_t unit;
  std::uint8_t state;
  friend bool operator==(const UnitState&, const UnitState&) = default;
};

/// An expectation holds if all values and the condition hold.
struct Expectation {
  std::vector<SymbolValue> values;
  std::optional<condition::Tree> condition;
  std::string text;  ///< of the condition, as in the file
};

struct Step {
  enum class When : unsigned char {
    at,    ///< at `time`, or at once if that is past
    plus,  ///< `time` after the previous step
    wait,  ///< until `expect` holds, for at most `time`
  };
  When when = When::at;
  tables::Time time = 0;
  std::vector<SymbolValue> set;
  std::vector<UnitState> states;
  std::vector<SymbolValue> force;
  std::vector<std::uint32_t> release;
  std::optional<Expectation> expect;
  std::size_t line = 0;  ///< in the file, from 1
};

struct Scenario {
  std::vector<Step> steps;
};

}  // namespace symplant::scenario
