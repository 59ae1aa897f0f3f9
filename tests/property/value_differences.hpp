// Compares values, and what the trace gets of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "support/reference/reference.hpp"
#include "symplant/plant/plant.hpp"

namespace symplant::property {

/// The number of the value with this name, in any case of its letters.
std::optional<std::uint32_t> value_number(const model::PlantModel& model, const std::string& name);

/// How a number is shown: its shortest text.
std::string number_text(double number);

/// Outputs must have the same bits.
std::string values_difference(const plant::Plant& engine, const reference::Plant& reference,
                              const model::PlantModel& plant);

/// The lines of values in a trace, as a reader of the engine's reports writes them.
class ValueTrace {
 public:
  explicit ValueTrace(const tables::ValueTables& values);

  /// After a reset: nothing is written yet.
  void clear();
  /// What the trace gets at the end of an instant: names of outputs and their numbers.
  std::vector<std::pair<std::string, double>> lines_at(tables::Time time, const plant::Plant& plant);

 private:
  struct Output {
    std::string name;
    tables::Time trace = 0;  ///< 0: never
    std::optional<double> written;
  };
  std::vector<Output> outputs_;
};

}  // namespace symplant::property
