// One part of the signal flow, whose boxes arrows join: its layers, and the order of boxes and arrows in them.
#pragma once

#include <cstdint>
#include <vector>

#include "view/flow.hpp"

namespace symplant::view {

/// A box, or a lane on which the arrows of one box pass through a layer.
struct FlowNode {
  std::uint32_t box = model::kNone;  ///< index in Flow::boxes; kNone: a lane
  std::uint32_t layer = 0;
  int height = 0;     ///< with `loop`
  int loop = 0;       ///< the room below a box for its arrow to itself
  int y = 0;          ///< of the middle
  bool back = false;  ///< a lane that leads to the left

  bool is_lane() const { return box == model::kNone; }
};

struct FlowEdge {
  std::uint32_t arrow = 0;  ///< index in Flow::arrows
  std::uint32_t from = 0;   ///< a node, as `to`
  std::uint32_t to = 0;
  bool back = false;                 ///< it closes a circle: `to` is not right of `from`
  std::vector<std::uint32_t> lanes;  ///< the nodes that it passes, in its direction
};

struct FlowPart {
  std::vector<FlowNode> nodes;                     ///< the boxes come first, in the order given
  std::vector<FlowEdge> edges;                     ///< in the order given
  std::vector<std::vector<std::uint32_t>> layers;  ///< the nodes of each, from top to bottom
};

/// `boxes` and `arrows` are indexes in the flow. Sources are in the first layer, sinks in the last one. Heights begin
/// at 0. If the arrows would need more than 100,000 lanes, or pass
/// more than 200,000 in all, they have none.
FlowPart lay_out_part(const Flow& flow, const std::vector<std::uint32_t>& boxes,
                      const std::vector<std::uint32_t>& arrows);

}  // namespace symplant::view
