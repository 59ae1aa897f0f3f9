// Values and signals in the reference (docs/values.md): numbers that change with time, and numeric events that show
// them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/reference/round.hpp"
#include "support/reference/value_rules.hpp"

namespace symplant::reference {

/// The number of a symbol as a double.
double as_double(tables::DataType type, std::uint64_t value);
/// The number of an integer, exactly; empty for reals.
std::optional<long double> as_integer(tables::DataType type, std::uint64_t value);
/// The sum of the weights of the parts at a location, from 0 and from the front-most part on.
double weight_at(const Rules& rules, const World& world, std::uint32_t location);

std::vector<ValueWorld> first_values(const Rules& rules);
/// Within `min` and `max`; -0.0 becomes 0.
double limited(const ValueRules& rules, double number);
bool writes_signal(const Rules& rules, std::uint32_t symbol);

// Before the first round of the first instant of a time (value_steps.cpp, value_results.cpp, signals.cpp).
bool is_due(const World& world, Time step);
/// The three steps of docs/values.md 3.
void compute_values(const Rules& rules, World& world, Counters& counters);
/// Step 2 for one value.
void compute_result(const Rules& rules, World& world, std::uint32_t value, Counters& counters);
void write_signals(const Rules& rules, World& world, Counters& counters);

// A round (value_round.cpp).
/// The jumps. True if an output changed.
bool change_values(Round& round, int number);

// By hand (value_round.cpp). False if the value cannot be set.
bool set_value(const Rules& rules, World& world, std::uint32_t value, double number, Counters& counters);

// The end of an instant (value_times.cpp).
/// What the trace gets: names of outputs and their numbers.
std::vector<std::pair<std::string, double>> traced_values(const Rules& rules, World& world);
void end_instant_of_values(World& world);
/// `steps`: also those of values and signals, not only what the trace gets.
Time next_due_of_values(const Rules& rules, const World& world, bool steps);

/// The names of the values of a plant, in their order.
std::vector<std::string> value_names(const model::PlantModel& model);

}  // namespace symplant::reference
