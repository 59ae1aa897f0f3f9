// The numbers of values, and which of them a malfunction holds.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "symplant/panel/role.hpp"
#include "symplant/plant/plant.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/trace/record.hpp"

namespace symplant::panel {

/// The outputs of values as last seen, in records or in a copy, and what changed since the last event. Used by one
/// thread at a time.
class ValueStates {
 public:
  /// `tables` must outlive it.
  explicit ValueStates(const tables::PlantTables& tables);

  /// A record of a value; ignored after a copy, since copies have all outputs, and more often. O(1).
  void apply(const trace::Record& record);
  /// A copy of all outputs. O(outputs).
  void take(std::span<const double> numbers);
  /// A malfunction started or ended. O(what it sets).
  void change(std::uint32_t malfunction, bool active);
  /// The plant was set to another state: everything counts as changed. O(values and active malfunctions).
  void load(const plant::Plant& plant);

  /// All outputs.
  std::span<const double> numbers() const { return numbers_; }
  bool has_changes() const { return !changed_.empty(); }
  /// Appends the key `values` with all of them, `[number,flags]` each; nothing in a plant without values.
  void put_all(std::string& json, Role role) const;
  /// The same of those that changed, their index first.
  void put_changes(std::string& json, Role role) const;
  void forget_changes();

 private:
  void set(std::uint32_t output, double number);
  void mark(std::uint32_t output, bool for_all = true);
  void put_one(std::string& json, std::uint32_t output, Role role) const;

  const tables::PlantTables& tables_;
  std::vector<double> numbers_;
  std::vector<std::uint32_t> holds_;  ///< by output: how many active malfunctions hold it
  bool by_copies_ = false;
  std::vector<bool> marked_;
  std::vector<bool> shown_;  ///< a change that not only the mark of a malfunction shows
  std::vector<std::uint32_t> changed_;
};

/// The outputs of the parameters that a malfunction holds. O(what it sets).
std::vector<std::uint32_t> held_outputs(const tables::PlantTables& tables, std::uint32_t malfunction);

}  // namespace symplant::panel
