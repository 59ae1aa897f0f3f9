// The numbers of values, and which of them a malfunction holds.
#include "symplant/panel/picture/value_states.hpp"

#include <algorithm>
#include <bit>

#include "symplant/panel/picture/json_text.hpp"
#include "symplant/tables/malfunction_numbers.hpp"

namespace symplant::panel {
namespace {

enum : unsigned { kIsHeld = 1 };

}  // namespace

ValueStates::ValueStates(const tables::PlantTables& tables)
    : tables_(tables), holds_(tables.values.outputs), marked_(tables.values.outputs), shown_(tables.values.outputs) {
  for (const tables::ValueRow& row : tables.values.rows) {
    numbers_.insert(numbers_.end(), row.outputs, row.start_output());
  }
}

void ValueStates::mark(std::uint32_t output, bool for_all) {
  if (!marked_[output]) changed_.push_back(output);
  marked_[output] = true;
  if (for_all) shown_[output] = true;
}

void ValueStates::set(std::uint32_t output, double number) {
  if (std::bit_cast<std::uint64_t>(numbers_[output]) == std::bit_cast<std::uint64_t>(number)) return;
  numbers_[output] = number;
  mark(output);
}

void ValueStates::apply(const trace::Record& record) {
  if (!by_copies_) set(record.of, std::bit_cast<double>(record.value));
}

void ValueStates::take(std::span<const double> numbers) {
  for (std::uint32_t output = 0; output < numbers.size(); ++output) set(output, numbers[output]);
  by_copies_ = true;
}

void ValueStates::change(std::uint32_t malfunction, bool active) {
  for (const std::uint32_t output : held_outputs(tables_, malfunction)) {
    active ? ++holds_[output] : --holds_[output];
    mark(output, false);
  }
}

void ValueStates::load(const plant::Plant& plant) {
  for (std::uint32_t output = 0; output < numbers_.size(); ++output) {
    numbers_[output] = plant.output(output);
    mark(output);
  }
  std::fill(holds_.begin(), holds_.end(), 0);
  for (const engine::ActiveMalfunction& one : plant.active_malfunctions()) change(one.number, true);
}

void ValueStates::put_one(std::string& json, std::uint32_t output, Role role) const {
  json += trace::json_value(tables::DataType::lreal, std::bit_cast<std::uint64_t>(numbers_[output]));
  put(json, ",{}", sees_all(role) && holds_[output] != 0 ? +kIsHeld : 0U);
}

void ValueStates::put_all(std::string& json, Role role) const {
  if (numbers_.empty()) return;
  put_key(json, "values");
  json += '[';
  for (std::uint32_t output = 0; output < numbers_.size(); ++output) {
    json += output == 0 ? "[" : ",[";
    put_one(json, output, role);
    json += ']';
  }
  json += ']';
}

void ValueStates::put_changes(std::string& json, Role role) const {
  std::string rows;
  for (const std::uint32_t output : changed_) {
    if (!sees_all(role) && !shown_[output]) continue;
    put(rows, "{}{},", rows.empty() ? "[" : ",[", output);
    put_one(rows, output, role);
    rows += ']';
  }
  if (rows.empty()) return;
  put_key(json, "values");
  json += "[" + rows + "]";
}

void ValueStates::forget_changes() {
  for (const std::uint32_t output : changed_) marked_[output] = shown_[output] = false;
  changed_.clear();
}

std::vector<std::uint32_t> held_outputs(const tables::PlantTables& tables, std::uint32_t malfunction) {
  std::vector<std::uint32_t> outputs;
  if (!tables::MalfunctionNumbers(tables).is_written(malfunction)) return outputs;
  for (const tables::EffectRow& effect : tables.malfunctions.effects_of(malfunction)) {
    for (const tables::MalfunctionSet& set : tables.malfunctions.sets_of(effect)) {
      outputs.push_back(tables.values.rows[set.value].output);
    }
  }
  return outputs;
}

}  // namespace symplant::panel
