// The signal flow of a plant in words: values, what they read, and what reads them, as boxes and arrows.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "view/scene.hpp"

namespace symplant::view {

struct FlowBox {
  enum class Kind : std::uint8_t {
    source,  ///< a symbol, a device or a location that formulas read: at the left border
    value,
    sink,  ///< a symbol, a device or an element of the material flow that reads values: at the right border
  };
  Kind kind = Kind::value;
  std::vector<std::string> lines;      ///< the name, then what it is; the long ones are cut
  std::vector<std::string> whole;      ///< lines without a cut, for a tooltip; empty if `lines` shows all
  std::uint32_t unit = model::kNone;   ///< of a device
  std::uint32_t value = model::kNone;  ///< index in PlantModel::values
};

/// From what is read to what reads it; at most one for two boxes.
struct FlowArrow {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  bool in_condition = false;  ///< only conditions read it; else a formula is computed from it
};

struct Flow {
  std::vector<FlowBox> boxes;     ///< sources, values, sinks, each in the order of the plant
  std::vector<FlowArrow> arrows;  ///< by target, then in the order in which it reads
  bool empty() const { return boxes.empty(); }
};

/// The class of style sheets: `flow-source`, `flow-value` or `flow-sink`.
std::string_view flow_class(FlowBox::Kind kind);

/// Empty in a plant without values and signals. If a scene shows only some devices, tracks and places: only the values
/// that read one of them, that one of them reads, or that a `for` made for one of them. O(formulas + conditions).
Flow flow_of(const Scene& scene);

}  // namespace symplant::view
