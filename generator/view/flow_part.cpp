// Layers and order of one part of the signal flow: circles are opened, boxes get layers by their longest path, long
// arrows get lanes, and boxes and lanes are sorted until few arrows cross.
#include "view/flow_part.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "view/layout.hpp"

namespace symplant::view {
namespace {

using model::kNone;

constexpr std::size_t kMostLanes = 100'000;
constexpr std::size_t kMostPassed = 200'000;  // lanes of all arrows: each arrow is drawn through all that it passes
constexpr int kSortSweeps = 12;
constexpr int kHeightSweeps = 10;
constexpr int kLaneHeight = 8;
constexpr int kLoopHeight = 16;
constexpr int kInputDistance = 9;
constexpr int kBoxGap = 14;  // between boxes
constexpr int kLaneGap = 4;

class PartPlacer {
 public:
  PartPlacer(const Flow& flow, const std::vector<std::uint32_t>& boxes, const std::vector<std::uint32_t>& arrows)
      : flow_(flow), boxes_(boxes.size()) {
    std::map<std::uint32_t, std::uint32_t> node_of;
    for (const std::uint32_t box : boxes) {
      node_of[box] = static_cast<std::uint32_t>(part_.nodes.size());
      part_.nodes.emplace_back().box = box;
    }
    for (const std::uint32_t arrow : arrows) {
      FlowEdge& edge = part_.edges.emplace_back();
      edge.arrow = arrow;
      edge.from = node_of.at(flow.arrows[arrow].from);
      edge.to = node_of.at(flow.arrows[arrow].to);
    }
  }

  FlowPart run() {
    place_in_layers();
    set_heights();
    add_lanes();
    fill_layers();
    sort_layers();
    place_heights();
    return std::move(part_);
  }

 private:
  struct Neighbor {
    std::uint32_t node;
    int weight;
  };

  FlowBox::Kind kind(std::uint32_t node) const { return flow_.boxes[part_.nodes[node].box].kind; }
  bool joins_values(const FlowEdge& edge) const {
    return kind(edge.from) == FlowBox::Kind::value && kind(edge.to) == FlowBox::Kind::value && edge.from != edge.to;
  }

  /// The values in an order in which few arrows lead back (Eades, Lin and Smyth 1993): those that read no other come
  /// first, those that no other reads come last. Of a circle the one with the most readers for its inputs begins; of
  /// equals one that reads from the border.
  std::vector<std::uint32_t> sequence() const {
    std::vector<std::vector<std::uint32_t>> inputs(boxes_);
    std::vector<std::vector<std::uint32_t>> readers(boxes_);
    std::vector<bool> at_border(boxes_);
    for (const FlowEdge& edge : part_.edges) {
      if (joins_values(edge)) {
        inputs[edge.to].push_back(edge.from);
        readers[edge.from].push_back(edge.to);
      } else if (kind(edge.from) == FlowBox::Kind::source) {
        at_border[edge.to] = true;
      }
    }
    std::vector<int> in(boxes_);
    std::vector<int> out(boxes_);
    using Key = std::tuple<int, int, bool, std::uint32_t>;
    const auto key = [&](std::uint32_t node) -> Key {
      if (in[node] == 0) return {0, 0, false, node};
      if (out[node] == 0) return {1, 0, false, node};
      return {2, in[node] - out[node], !at_border[node], node};
    };
    std::set<Key> open;
    for (std::uint32_t node = 0; node < boxes_; ++node) {
      in[node] = static_cast<int>(inputs[node].size());
      out[node] = static_cast<int>(readers[node].size());
      if (kind(node) == FlowBox::Kind::value) open.insert(key(node));
    }
    const auto lose = [&](std::uint32_t node, std::vector<int>& degrees) {
      const bool is_open = open.erase(key(node)) != 0;
      --degrees[node];
      if (is_open) open.insert(key(node));
    };
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> last;
    while (!open.empty()) {
      const auto [rank, ignored, also_ignored, node] = *open.begin();
      open.erase(open.begin());
      (rank == 1 ? last : first).push_back(node);
      for (const std::uint32_t reader : readers[node]) lose(reader, in);
      for (const std::uint32_t input : inputs[node]) lose(input, out);
    }
    first.insert(first.end(), last.rbegin(), last.rend());
    return first;
  }

  void place_in_layers() {
    const std::vector<std::uint32_t> order = sequence();
    std::vector<std::uint32_t> place(boxes_);
    for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
    std::vector<std::vector<std::uint32_t>> readers(boxes_);
    std::vector<bool> begins(boxes_, true);
    bool has_sources = false;
    bool has_sinks = false;
    for (FlowEdge& edge : part_.edges) {
      edge.back = edge.from == edge.to || (joins_values(edge) && place[edge.from] > place[edge.to]);
      if (!edge.back) readers[edge.from].push_back(edge.to);
      if (edge.from != edge.to) begins[edge.to] = false;
    }
    for (std::uint32_t node = 0; node < boxes_; ++node) {
      has_sources = has_sources || kind(node) == FlowBox::Kind::source;
      has_sinks = has_sinks || kind(node) == FlowBox::Kind::sink;
    }
    auto& nodes = part_.nodes;
    const std::uint32_t least = has_sources ? 1 : 0;
    std::uint32_t last = least;
    for (const std::uint32_t node : order) nodes[node].layer = least;
    for (const std::uint32_t node : order) {
      last = std::max(last, nodes[node].layer);
      for (const std::uint32_t reader : readers[node]) {
        nodes[reader].layer = std::max(nodes[reader].layer, nodes[node].layer + 1);
      }
    }
    const std::uint32_t end = order.empty() ? least : last + 1;
    for (std::uint32_t node = 0; node < boxes_; ++node) {
      if (kind(node) == FlowBox::Kind::sink) nodes[node].layer = end;
    }
    // What reads nothing is next to what reads it.
    for (std::size_t i = order.size(); i-- > 0;) {
      if (!begins[order[i]] || readers[order[i]].empty()) continue;
      std::uint32_t next = end;
      for (const std::uint32_t reader : readers[order[i]]) next = std::min(next, nodes[reader].layer);
      nodes[order[i]].layer = std::min(next - 1, last);
    }
    for (FlowEdge& edge : part_.edges) edge.back = nodes[edge.from].layer >= nodes[edge.to].layer;
    part_.layers.resize(has_sinks ? end + 1 : last + 1);
  }

  void set_heights() {
    std::vector<int> inputs(boxes_);
    for (const FlowEdge& edge : part_.edges) {
      ++inputs[edge.to];
      if (edge.from == edge.to) part_.nodes[edge.to].loop = kLoopHeight;
    }
    for (std::uint32_t node = 0; node < boxes_; ++node) {
      FlowNode& box = part_.nodes[node];
      const int texts = static_cast<int>(flow_.boxes[box.box].lines.size()) * kLineHeight + 10;
      box.height = std::max(texts, (inputs[node] + 1) * kInputDistance) + box.loop;
    }
  }

  /// How many lanes an arrow would have if it shared none.
  std::size_t span(const FlowEdge& edge) const {
    const std::size_t from = part_.nodes[edge.from].layer;
    const std::size_t to = part_.nodes[edge.to].layer;
    return edge.from == edge.to ? 0 : edge.back ? from - to + 1 : to - from - 1;
  }

  /// Arrows of one box share the lanes of one direction.
  void add_lanes() {
    std::size_t lanes = 0;
    std::size_t passed = 0;
    std::vector<std::array<std::size_t, 2>> longest(boxes_);
    for (const FlowEdge& edge : part_.edges) {
      std::size_t& known = longest[edge.from][edge.back ? 1 : 0];
      lanes += std::max(known, span(edge)) - known;
      known = std::max(known, span(edge));
      passed += span(edge);
    }
    if (lanes > kMostLanes || passed > kMostPassed) return;
    std::vector<std::array<std::vector<std::uint32_t>, 2>> lanes_of(boxes_);
    for (FlowEdge& edge : part_.edges) {
      const std::uint32_t from = part_.nodes[edge.from].layer;
      std::vector<std::uint32_t>& known = lanes_of[edge.from][edge.back ? 1 : 0];
      for (std::size_t i = 0; i < span(edge); ++i) {
        if (i == known.size()) {
          FlowNode lane;
          const auto distance = static_cast<std::uint32_t>(i);
          lane.layer = edge.back ? from - distance : from + 1 + distance;
          lane.height = kLaneHeight;
          lane.back = edge.back;
          known.push_back(static_cast<std::uint32_t>(part_.nodes.size()));
          part_.nodes.push_back(lane);
        }
        edge.lanes.push_back(known[i]);
      }
    }
  }

  void join(std::uint32_t left, std::uint32_t right) {
    if (part_.nodes[right].is_lane() && !left_[right].empty()) return;  // another arrow of the box shares it
    const int lanes = (part_.nodes[left].is_lane() ? 1 : 0) + (part_.nodes[right].is_lane() ? 1 : 0);
    const int weight = lanes == 2 ? 6 : lanes == 1 ? 2 : 1;
    right_[left].push_back({right, weight});
    left_[right].push_back({left, weight});
  }

  void fill_layers() {
    left_.resize(part_.nodes.size());
    right_.resize(part_.nodes.size());
    turns_at_.assign(part_.nodes.size(), kNone);
    positions_.assign(part_.nodes.size(), 0);
    for (const FlowEdge& edge : part_.edges) {
      if (edge.from == edge.to) continue;
      if (edge.back) {
        for (std::size_t i = 1; i < edge.lanes.size(); ++i) join(edge.lanes[i], edge.lanes[i - 1]);
        if (edge.lanes.empty()) continue;
        turns_at_[edge.lanes.back()] = edge.to;
        turns_at_[edge.lanes.front()] = edge.from;
        continue;
      }
      std::uint32_t before = edge.from;
      for (const std::uint32_t lane : edge.lanes) {
        join(before, lane);
        before = lane;
      }
      if (part_.nodes[edge.to].layer == part_.nodes[before].layer + 1) join(before, edge.to);
    }
    for (std::uint32_t node = 0; node < part_.nodes.size(); ++node) {
      part_.layers[part_.nodes[node].layer].push_back(node);
    }
    number_positions();
  }

  void number_positions() {
    for (const auto& layer : part_.layers) {
      for (std::uint32_t i = 0; i < layer.size(); ++i) positions_[layer[i]] = i;
    }
  }

  std::uint64_t crossings() const {
    std::uint64_t count = 0;
    for (const auto& layer : part_.layers) {
      std::vector<std::uint32_t> ends;
      std::size_t most = 0;
      for (const std::uint32_t node : layer) {
        const std::size_t begin = ends.size();
        for (const Neighbor& right : right_[node]) ends.push_back(positions_[right.node]);
        std::sort(ends.begin() + static_cast<std::ptrdiff_t>(begin), ends.end());
        if (!right_[node].empty()) most = std::max<std::size_t>(most, ends.back() + 1);
      }
      // A Fenwick tree counts, for each arrow, those before it that end below it.
      std::vector<std::uint64_t> tree(most + 1);
      for (std::size_t i = 0; i < ends.size(); ++i) {
        std::uint64_t up_to = 0;
        for (std::size_t at = ends[i] + 1; at > 0; at &= at - 1) up_to += tree[at];
        count += i - up_to;
        for (std::size_t at = ends[i] + 1; at < tree.size(); at += at & (~at + 1)) ++tree[at];
      }
    }
    return count;
  }

  void sort_layer(std::vector<std::uint32_t>& layer, bool from_left) {
    constexpr std::int64_t kScale = 1024;
    std::vector<std::pair<std::int64_t, std::uint32_t>> keys;
    for (const std::uint32_t node : layer) {
      const auto& neighbors = from_left ? left_[node] : right_[node];
      std::int64_t key = std::int64_t{positions_[node]} * kScale;
      if (!neighbors.empty()) {
        std::int64_t sum = 0;
        for (const Neighbor& neighbor : neighbors) sum += positions_[neighbor.node];
        key = sum * kScale / static_cast<std::int64_t>(neighbors.size());
      } else if (turns_at_[node] != kNone) {
        key = std::int64_t{positions_[turns_at_[node]]} * kScale + kScale / 2;  // below its box
      }
      keys.emplace_back(key, node);
    }
    std::stable_sort(keys.begin(), keys.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::uint32_t i = 0; i < keys.size(); ++i) {
      layer[i] = keys[i].second;
      positions_[layer[i]] = i;
    }
  }

  void sort_layers() {
    auto best = part_.layers;
    std::uint64_t least = crossings();
    for (int sweep = 0; sweep < kSortSweeps && least != 0; ++sweep) {
      const std::size_t count = part_.layers.size();
      for (std::size_t i = 0; i < count; ++i) {
        sort_layer(part_.layers[sweep % 2 == 0 ? i : count - 1 - i], sweep % 2 == 0);
      }
      const std::uint64_t now = crossings();
      if (now >= least) continue;
      least = now;
      best = part_.layers;
    }
    part_.layers = std::move(best);
    number_positions();
  }

  int distance(std::uint32_t above, std::uint32_t below) const {
    const FlowNode& a = part_.nodes[above];
    const FlowNode& b = part_.nodes[below];
    return (a.height + 1) / 2 + (b.height + 1) / 2 + (a.is_lane() && b.is_lane() ? kLaneGap : kBoxGap);
  }

  /// Moves the nodes of a layer as near as possible to their neighbors, in their order and with their distances: by
  /// least squares (isotonic regression, pooling adjacent violators).
  void place_layer(const std::vector<std::uint32_t>& layer, bool by_left, bool by_right) {
    struct Pool {
      std::int64_t sum;
      std::int64_t count;
    };
    std::vector<Pool> pools;
    std::vector<int> offsets;
    int offset = 0;
    for (std::size_t i = 0; i < layer.size(); ++i) {
      const FlowNode& node = part_.nodes[layer[i]];
      if (i > 0) offset += distance(layer[i - 1], layer[i]);
      offsets.push_back(offset);
      std::int64_t sum = 0;
      std::int64_t weight = 0;
      const auto add = [&](const std::vector<Neighbor>& neighbors) {
        for (const Neighbor& neighbor : neighbors) {
          sum += std::int64_t{part_.nodes[neighbor.node].y} * neighbor.weight;
          weight += neighbor.weight;
        }
      };
      if (by_left) add(left_[layer[i]]);
      if (by_right) add(right_[layer[i]]);
      pools.push_back({(weight == 0 ? node.y : sum / weight) - offset, 1});
      while (pools.size() > 1) {
        const Pool last = pools.back();
        Pool& before = pools[pools.size() - 2];
        if (before.sum * last.count <= last.sum * before.count) break;
        before = {before.sum + last.sum, before.count + last.count};
        pools.pop_back();
      }
    }
    std::size_t i = 0;
    for (const Pool& pool : pools) {
      const std::int64_t least = pool.sum / pool.count - (pool.sum % pool.count < 0 ? 1 : 0);
      for (std::int64_t n = 0; n < pool.count; ++n, ++i) {
        part_.nodes[layer[i]].y = static_cast<int>(least) + offsets[i];
      }
    }
  }

  void place_heights() {
    for (const auto& layer : part_.layers) {
      int y = 0;
      for (std::size_t i = 0; i < layer.size(); ++i) {
        if (i > 0) y += distance(layer[i - 1], layer[i]);
        part_.nodes[layer[i]].y = y;
      }
    }
    const std::size_t count = part_.layers.size();
    for (int sweep = 0; sweep < kHeightSweeps; ++sweep) {
      const bool from_left = sweep % 2 == 0;
      for (std::size_t i = 0; i < count; ++i) {
        place_layer(part_.layers[from_left ? i : count - 1 - i], from_left || sweep > 2, !from_left || sweep > 2);
      }
    }
    int top = 0;
    bool any = false;
    for (const FlowNode& node : part_.nodes) {
      const int upper = node.y - node.height / 2;
      top = any ? std::min(top, upper) : upper;
      any = true;
    }
    for (FlowNode& node : part_.nodes) node.y -= top;
  }

  const Flow& flow_;
  const std::size_t boxes_;
  FlowPart part_;
  std::vector<std::vector<Neighbor>> left_;   // of each node, in the layer before
  std::vector<std::vector<Neighbor>> right_;  // of each node, in the layer after
  std::vector<std::uint32_t> turns_at_;       // the box of a lane at which it turns; else kNone
  std::vector<std::uint32_t> positions_;      // of each node in its layer
};

}  // namespace

FlowPart lay_out_part(const Flow& flow, const std::vector<std::uint32_t>& boxes,
                      const std::vector<std::uint32_t>& arrows) {
  return PartPlacer(flow, boxes, arrows).run();
}

}  // namespace symplant::view
