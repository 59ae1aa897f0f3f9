// A scenario: the actions on a plant and its expected reactions, step by step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "symplant/condition/tree.hpp"
#include "symplant/tables/material.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::scenario {

/// A symbol and a value in the representation of its plane: 0 or 1, two's complement, or the bits of a double.
struct SymbolValue {
  std::uint32_t symbol;
  std::uint64_t value;
  friend bool operator==(const SymbolValue&, const SymbolValue&) = default;
};

/// A value, and the number that it is set to.
struct ValueSetting {
  std::uint32_t value;
  double number;
  friend bool operator==(const ValueSetting&, const ValueSetting&) = default;
};

struct UnitState {
  std::uint32_t unit;
  std::uint8_t state;
  friend bool operator==(const UnitState&, const UnitState&) = default;
};

/// A part to be put by hand.
struct NewPart {
  tables::PartLocation at;
  std::uint32_t kind;
  friend bool operator==(const NewPart&, const NewPart&) = default;
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
  std::vector<std::uint32_t> restart;  ///< controllers whose programs start cold
  std::vector<SymbolValue> set;
  std::vector<ValueSetting> set_values;  ///< in the same object of the file as `set`, which comes first
  std::vector<UnitState> states;
  std::vector<NewPart> put;                ///< it fails if there is no room
  std::vector<tables::PartLocation> take;  ///< it fails if there is no part
  std::vector<SymbolValue> force;
  std::vector<std::uint32_t> release;
  std::vector<std::uint32_t> stop;   ///< malfunctions, as tables::MalfunctionNumbers numbers them
  std::vector<std::uint32_t> start;  ///< malfunctions; the step fails if too many ordinary ones are active
  bool starts_ordinary = false;      ///< one of `start` is an ordinary one
  std::optional<Expectation> expect;
  bool ends_instant = false;  ///< what follows at the same time acts in a further instant
  std::string text;           ///< for the trainee of an exercise; may be empty
  std::size_t line = 0;       ///< in the file, from 1
  std::uint32_t file = 0;     ///< index in Scenario::files

  /// Whether it can fail: it is an expectation (it has `expect`), or it does something that may be refused.
  bool is_checked() const { return expect.has_value() || !put.empty() || !take.empty() || starts_ordinary; }
};

/// Steps that are done several times: from `begin` to before `end`, which differ. Two of them are apart, or one is
/// within the other.
struct Repeat {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t turns;
};

/// Makes a scenario an exercise for a trainee at the panel.
struct Exercise {
  std::string title;
  std::string text;
  std::int64_t for_expectation = 0;  ///< points for each expectation and wait that is met
  std::int64_t for_violation = 0;    ///< points for each violation of a requirement; usually below 0
  tables::Time within = tables::kNever;
  std::int64_t for_time = 0;  ///< points if it is over within that time
  /// What a trainee may operate, as names or patterns; nothing: what persons operate in a plant.
  std::optional<std::vector<std::string>> allow = std::nullopt;
  bool shows_score = false;  ///< to the trainee
};

struct Scenario {
  std::string restore;  ///< the snapshot file from which the plant starts; empty: its initial state
  std::optional<Exercise> exercise;
  std::vector<Step> steps;         ///< each once, however often it is done
  std::vector<Repeat> repeats;     ///< sorted by end, then the inner one first
  std::vector<std::string> files;  ///< the scenario's own file is an empty text, then the included ones by their paths
};

/// How often a step is done in all, at most 2^63. O(repeats).
std::uint64_t executions(const Scenario& scenario, std::size_t step);

/// "turn 3 of 10", the outer turns first, for execution `number`, from 0, of a step; empty if it is not repeated.
std::string turn_words(const Scenario& scenario, std::size_t step, std::uint64_t number);

/// "line 4", or "line 4 of start-up.json" for a step of an included file.
std::string line_words(const Scenario& scenario, const Step& step);

}  // namespace symplant::scenario
