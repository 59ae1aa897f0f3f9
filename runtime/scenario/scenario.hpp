// A scenario: what is done to a plant and expected of it, step by step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "symplant/condition/tree.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::scenario {

/// A symbol and a value as the plane holds it: 0 or 1, two's complement, the bits of a double.
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

/// Values and condition must all hold.
struct Expectation {
  std::vector<SymbolValue> values;
  std::optional<condition::Tree> condition;
  std::string text;  ///< of the condition, as its author wrote it
};

struct Step {
  enum class When : unsigned char {
    at,    ///< at `time`, or at once where that is past
    plus,  ///< `time` after the step before
    wait,  ///< until `expect` holds, at most for `time`
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
