// Looks up units, states and symbols of a plant's tables by name, for conditions and scenarios.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "symplant/condition/resolve.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::scenario {

/// Names compare without regard to the case of ASCII letters. `names` must outlive this object. The constructor is
/// O(plant), a look-up O(name), the nearest names O(plant).
class TableNames final : public condition::Names {
 public:
  explicit TableNames(const trace::PlantNames& names);

  std::optional<std::uint32_t> unit(std::string_view device, std::string_view facet) const override;
  std::vector<std::uint32_t> facets(std::string_view device) const override;
  std::string path(std::uint32_t unit) const override;
  std::optional<std::uint8_t> state(std::uint32_t unit, std::string_view name) const override;
  std::optional<Symbol> symbol(std::string_view name) const override;
  std::optional<std::uint32_t> location(std::string_view name) const override;
  std::optional<std::uint32_t> part_kind(std::string_view name) const override;
  std::optional<Value> value(std::string_view name) const override;
  std::string nearest_value(std::string_view name) const override;
  /// The index of a value by its name.
  std::optional<std::uint32_t> value_index(std::string_view name) const;
  std::string nearest_part_kind(std::string_view name) const override;
  std::string nearest_location(std::string_view name) const;
  /// The number of a malfunction (tables::MalfunctionNumbers) by its name, written or ordinary.
  std::optional<std::uint32_t> malfunction(std::string_view name) const;
  std::string nearest_malfunction(std::string_view name) const;
  std::string nearest_device(std::string_view device, std::string_view facet) const override;
  std::string nearest_state(std::uint32_t unit, std::string_view name) const override;
  std::string nearest_symbol(std::string_view name) const override;
  std::string why_no_state(std::uint32_t unit, std::string_view name) const override;

 private:
  const trace::PlantNames& names_;
  std::unordered_map<std::string, std::uint32_t> units_;                ///< by name in upper case
  std::unordered_map<std::string, std::vector<std::uint32_t>> facets_;  ///< by device in upper case
  std::unordered_map<std::string, std::uint32_t> symbols_;
  std::unordered_map<std::string, std::uint32_t> locations_;
  std::unordered_map<std::string, std::uint32_t> part_kinds_;
  std::unordered_map<std::string, std::uint32_t> malfunctions_;
  std::unordered_map<std::string, std::uint32_t> values_;
};

}  // namespace symplant::scenario
