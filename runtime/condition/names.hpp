// The names of a plant, for conditions and formulas.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::condition {

/// The names of a plant that a condition may use. Names compare without regard to the case of ASCII letters.
class Names {
 public:
  struct Symbol {
    std::uint32_t index;
    tables::DataType type;
  };

  /// Outputs `output` to `output + outputs - 1` of a value; only one of kind `linear` has more than one.
  struct Value {
    std::uint32_t output;
    std::uint32_t outputs;
  };

  virtual ~Names() = default;

  /// The unit of a device, or of one of its facets if `facet` is not empty.
  virtual std::optional<std::uint32_t> unit(std::string_view device, std::string_view facet) const = 0;
  /// The units of a device's facets that have a name, in their order.
  virtual std::vector<std::uint32_t> facets(std::string_view device) const = 0;
  /// `DEVICE`, or `DEVICE.FACET`.
  virtual std::string path(std::uint32_t unit) const = 0;
  virtual std::optional<std::uint8_t> state(std::uint32_t unit, std::string_view name) const = 0;
  virtual std::optional<Symbol> symbol(std::string_view name) const = 0;
  /// A track or place, by index. No device has the same name. Only in a plant with material.
  virtual std::optional<std::uint32_t> location(std::string_view) const { return {}; }
  virtual std::optional<std::uint32_t> part_kind(std::string_view) const { return {}; }
  /// A value, by its identifiers joined by dots. Nothing else in the plant has the same name.
  virtual std::optional<Value> value(std::string_view /*dotted_name*/) const { return {}; }

  // For messages only: the nearest known name, empty if no name is near. In nearest_device() a location counts as a
  // device.
  virtual std::string nearest_device(std::string_view device, std::string_view facet) const = 0;
  virtual std::string nearest_state(std::uint32_t unit, std::string_view name) const = 0;
  virtual std::string nearest_symbol(std::string_view name) const = 0;
  virtual std::string nearest_part_kind(std::string_view) const { return {}; }
  virtual std::string nearest_value(std::string_view /*dotted_name*/) const { return {}; }
  /// Why the name of a task of the unit is not one of its states, such as "`BUSY` is an event that ..."; empty if it is
  /// not a task.
  virtual std::string why_no_state(std::uint32_t unit, std::string_view name) const = 0;
};

}  // namespace symplant::condition
