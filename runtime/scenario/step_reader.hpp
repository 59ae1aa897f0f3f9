// Reads the steps of a scenario in order, and collects their faults.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/json/location.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/scenario/table_names.hpp"

namespace symplant::scenario {

/// The steps must match the schema.
class StepReader {
 public:
  StepReader(const trace::PlantNames& names, const std::vector<bool>& carried);

  /// `pointer` is the JSON pointer of the step. Call it for the steps in their order.
  Step read(const nlohmann::json& step, const std::string& pointer);

  /// Nothing, and a fault, if the text is not a duration up to 100 years.
  std::optional<tables::Time> read_duration(const nlohmann::json& value, const std::string& pointer);

  /// Around the steps of a repeat: in it no step may have an `at`.
  void begin_repeat();
  void end_repeat(std::uint32_t turns);

  std::vector<json::Fault> faults;

 private:
  void read_when(const nlohmann::json& step, const std::string& pointer, Step& result);
  void read_wait(const nlohmann::json& step, const std::string& pointer, Step& result);
  void check_order(const Step& step, const std::string& pointer);
  void read_expect(const nlohmann::json& value, const std::string& pointer, Step& result);
  std::optional<condition::Tree> read_condition(const std::string& text, const std::string& pointer);
  std::vector<SymbolValue> read_values(const nlohmann::json& object, const std::string& pointer, bool setting);
  void read_set(const nlohmann::json& object, const std::string& pointer, Step& result);
  void read_puts(const nlohmann::json& value, const std::string& pointer, Step& result);
  void read_put(const nlohmann::json& value, const std::string& pointer, Step& result);
  void read_takes(const nlohmann::json& value, const std::string& pointer, Step& result);
  std::optional<tables::PartLocation> read_location(const nlohmann::json& value, const std::string& pointer);
  std::vector<UnitState> read_states(const nlohmann::json& object, const std::string& pointer);
  void read_restart(const nlohmann::json& value, const std::string& pointer, Step& result);
  std::vector<std::uint32_t> read_malfunctions(const nlohmann::json& value, const std::string& pointer);
  std::vector<std::uint32_t> read_symbols(const nlohmann::json& array, const std::string& pointer);
  std::optional<std::uint32_t> symbol(const std::string& name, const std::string& pointer, bool at_key);
  std::string why_not_set(std::uint32_t symbol) const;
  void add(const std::string& pointer, std::string message, bool at_key = false, std::size_t column = 0);

  const trace::PlantNames& names_;
  const std::vector<bool>& carried_;
  TableNames by_name_;
  std::vector<bool> moved_;            ///< for each symbol: it, or another one on its address, is SymbolRow::moved()
  tables::Time earliest_ = 0;          ///< the earliest time of the next step, without the duration of waits
  std::string last_;                   ///< the key that set `earliest_`: `at` or `plus`
  std::vector<tables::Time> repeats_;  ///< of the repeats around this step: `earliest_` where each began
};

}  // namespace symplant::scenario
