// From names to what a plant has.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "symplant/condition/expression.hpp"
#include "symplant/condition/tree.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::condition {

/// What a condition may name: a plant, as seen by its names. Names compare without regard to the case of ASCII letters.
class Names {
 public:
  struct Symbol {
    std::uint32_t index;
    tables::DataType type;
  };

  virtual ~Names() = default;

  /// The unit of a device, or of the device's facet where one is named (else `facet` is empty).
  virtual std::optional<std::uint32_t> unit(std::string_view device, std::string_view facet) const = 0;
  virtual std::optional<std::uint8_t> state(std::uint32_t unit, std::string_view name) const = 0;
  virtual std::optional<Symbol> symbol(std::string_view name) const = 0;

  // For messages only: the nearest name that there is, empty where none is near.
  virtual std::string nearest_device(std::string_view device, std::string_view facet) const = 0;
  virtual std::string nearest_state(std::uint32_t unit, std::string_view name) const = 0;
  virtual std::string nearest_symbol(std::string_view name) const = 0;
  /// Why the name of a task of the unit is no state of it, as "`BUSY` is an event that ..."; empty where it is no task.
  virtual std::string why_no_state(std::uint32_t unit, std::string_view name) const = 0;
};

/// The tree of an expression, or the first name or number in it that does not fit the plant. Numbers compare exactly: a
/// comparison with an integer symbol becomes one with an integer (`x < 3.5` is `x <= 3`), or a constant where no value
/// or every value of its type meets it. O(expression) look-ups.
std::variant<Tree, Fault> resolve(const Expression& expression, const Names& names);

/// Both steps at once.
std::variant<Tree, Fault> parse_and_resolve(std::string_view text, const Names& names);

}  // namespace symplant::condition
