// The names in a plant model, for conditions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "description/faults.hpp"
#include "model/plant_model.hpp"
#include "symplant/condition/resolve.hpp"
#include "text/ascii.hpp"

namespace symplant::model {

/// The plant's units and their states, and the names of its material, must be complete and outlive this object.
/// O(symbols) to construct.
class PlantNames final : public condition::Names {
 public:
  PlantNames(const PlantModel& plant, const description::Faults& faults);

  std::optional<std::uint32_t> unit(std::string_view device, std::string_view facet) const override;
  std::vector<std::uint32_t> facets(std::string_view device) const override;
  std::string path(std::uint32_t unit) const override;
  std::optional<std::uint8_t> state(std::uint32_t unit, std::string_view name) const override;
  std::optional<Symbol> symbol(std::string_view name) const override;
  std::optional<std::uint32_t> location(std::string_view name) const override;
  std::optional<std::uint32_t> part_kind(std::string_view name) const override;
  std::optional<Value> value(std::string_view name) const override;
  std::string nearest_value(std::string_view name) const override;
  std::string nearest_part_kind(std::string_view name) const override;
  std::string nearest_device(std::string_view device, std::string_view facet) const override;
  std::string nearest_state(std::uint32_t unit, std::string_view name) const override;
  std::string nearest_symbol(std::string_view name) const override;
  std::string why_no_state(std::uint32_t unit, std::string_view name) const override;

 private:
  const PlantModel& plant_;
  const description::Faults& faults_;
  text::ByName<std::uint32_t> units_;
  text::ByName<std::vector<std::uint32_t>> facets_;  ///< by device: units with a name after the device's
  text::ByName<std::uint32_t> symbols_;
  text::ByName<std::uint32_t> locations_;
  text::ByName<std::uint32_t> part_kinds_;
  text::ByName<std::uint32_t> values_;
};

}  // namespace symplant::model
