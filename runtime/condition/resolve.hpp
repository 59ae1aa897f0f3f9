// Resolves the names of a condition to units, states and symbols of a plant.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/condition/expression.hpp"
#include "symplant/condition/tree.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::condition {

/// The names of a plant that a condition may use. Names compare without regard to the case of ASCII letters.
class Names {
 public:
  struct Symbol {
    std::uint32_t index;
    tables::DataType type;
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

  // For messages only: the nearest known name, empty if no name is near. In nearest_device() a location counts as a
  // device.
  virtual std::string nearest_device(std::string_view device, std::string_view facet) const = 0;
  virtual std::string nearest_state(std::uint32_t unit, std::string_view name) const = 0;
  virtual std::string nearest_symbol(std::string_view name) const = 0;
  virtual std::string nearest_part_kind(std::string_view) const { return {}; }
  /// Why the name of a task of the unit is not one of its states, such as "`BUSY` is an event that ..."; empty if it is
  /// not a task.
  virtual std::string why_no_state(std::uint32_t unit, std::string_view name) const = 0;
};

/// The tree of an expression, or the first name or number in it that does not fit the plant. Numbers compare exactly: a
/// comparison with an integer symbol becomes one with an integer (`x < 3.5` is `x <= 3`), or a constant if no value or
/// every value of the type meets it. O(expression) look-ups.
std::variant<Tree, Fault> resolve(const Expression& expression, const Names& names);

/// Calls parse(), then resolve().
std::variant<Tree, Fault> parse_and_resolve(std::string_view text, const Names& names);

}  // namespace symplant::condition
