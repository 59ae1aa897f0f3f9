// Whether a condition holds, as far as it is known.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "symplant/condition/tree.hpp"

namespace symplant::observe {

/// What conditions read. Nothing: not known.
struct Known {
  std::function<std::optional<double>(std::uint32_t symbol)> value;
  std::function<std::optional<bool>(std::uint32_t unit, std::uint32_t state)> settled;
  std::function<std::optional<bool>(std::uint32_t unit)> moving;
};

/// Nothing if it depends on what is not known: outputs of values and parts never are. O(condition).
std::optional<bool> holds(const condition::Tree& tree, const Known& known);

}  // namespace symplant::observe
