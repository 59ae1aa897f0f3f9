// The nodes of a PLC's server that a link `opc-ua` reads and writes.
#include "symplant/link/opc_ua/client_map.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "symplant/link/opc_ua/address.hpp"
#include "symplant/link/opc_ua/carried.hpp"
#include "symplant/link/url_values.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::opc_ua {

namespace {

class Maker {
 public:
  Maker(const tables::PlantTables& tables, const LinkSettings& link, const ClientSettings& settings, Carried carried)
      : tables_(tables),
        texts_(tables::split_names(tables.symbol_names)),
        link_(link),
        settings_(settings),
        points_(std::move(carried.map.points)) {
    map_.image.sizes = carried.map.sizes;
    map_.left_out = std::move(carried.left_out);
  }

  std::variant<ClientMap, LinkError> make() {
    choose_templates();
    for (const image::Point& point : points_) {
      if (auto error = add(point)) return std::move(*error);
    }
    if (auto error = conflict()) return std::move(*error);
    std::sort(map_.left_out.begin(), map_.left_out.end(),
              [](const Unreachable& a, const Unreachable& b) { return a.symbol < b.symbol; });
    return std::move(map_);
  }

 private:
  using Position = std::pair<Plane, std::uint32_t>;
  /// The symbol that decides on the node of a position.
  struct Source {
    std::uint32_t symbol;
    std::string_view text;  ///< template
    bool own;               ///< `node` in plant.json
  };

  std::string_view name(std::uint32_t symbol) const { return texts_[std::size_t{2} * symbol]; }
  std::string_view address(std::uint32_t symbol) const { return texts_[std::size_t{2} * symbol + 1]; }

  void choose_templates() {
    auto row = link_.rows.begin();
    for (const image::Point& point : points_) {
      while (row != link_.rows.end() && row->symbol < point.symbol) ++row;
      const bool own = row != link_.rows.end() && row->symbol == point.symbol && !row->node.empty();
      const Source source{point.symbol, own ? row->node : std::string_view(settings_.nodes), own};
      const auto [found, is_new] = sources_.try_emplace(Position(point.plane, point.position), source);
      if (!is_new && own && !found->second.own) found->second = source;
    }
  }

  std::optional<LinkError> add(const image::Point& point) {
    const Source& source = sources_.at({point.plane, point.position});
    if (source.text.empty()) {
      return usage_error(
          ticked_text(name(point.symbol)) +
          " has no node: give the link the node ids of all symbols, as in "
          "`opc-ua://HOST:PORT?nodes=ns=3;s=\"{symbol}\"`, or this one a `node` in plant.json; docs/opc-ua.md "
          "has examples for PLCs");
    }
    if (source.text.find("{address}") != source.text.npos && address(source.symbol).empty()) {
      map_.left_out.push_back({point.symbol, "has no address, and its node id needs one"});
      return std::nullopt;
    }
    const std::string text = fill_template(source.text, name(source.symbol), address(source.symbol));
    const auto id = parse_node_id(text);
    if (!id) {
      return usage_error(ticked_text(name(point.symbol)) + " would have the node " + ticked_text(text) +
                         ", which is not a node id: correct " + (source.own ? "its `node`" : "`nodes`"));
    }
    map_.image.points.push_back(point);
    map_.addresses.push_back(node_id_text(*id));
    if (source.symbol != point.symbol) return std::nullopt;
    const tables::DataType type = tables_.symbols[point.symbol].type();
    (is_event(point.plane) ? map_.events : map_.operations)
        .push_back({*id, point.plane, point.position, type, std::string(name(point.symbol))});
    return std::nullopt;
  }

  /// An event's node that another symbol also has.
  std::optional<LinkError> conflict() const {
    std::map<std::string, const ClientNode*> events;
    for (const ClientNode& node : map_.events) {
      const auto [found, is_new] = events.try_emplace(node_id_text(node.id), &node);
      if (!is_new) return shared(*found->second, node);
    }
    for (const ClientNode& node : map_.operations) {
      const auto found = events.find(node_id_text(node.id));
      if (found != events.end()) return shared(*found->second, node);
    }
    return std::nullopt;
  }

  static LinkError shared(const ClientNode& event, const ClientNode& other) {
    return usage_error("the event " + ticked_text(event.symbol) + " and " + ticked_text(other.symbol) +
                       " have the same node " + ticked_text(node_id_text(event.id)) +
                       ": give each its own, by `{symbol}` in `nodes` or by `node` in plant.json");
  }

  const tables::PlantTables& tables_;
  const std::vector<std::string_view> texts_;  ///< two for each symbol: name, address
  const LinkSettings& link_;
  const ClientSettings& settings_;
  const std::vector<image::Point> points_;
  std::map<Position, Source> sources_;
  ClientMap map_;
};

}  // namespace

std::variant<ClientMap, LinkError> make_client_map(const tables::PlantTables& tables, std::uint32_t controller,
                                                   const LinkSettings& link, const ClientSettings& settings) {
  return Maker(tables, link, settings, carried_symbols(tables, controller, link)).make();
}

}  // namespace symplant::link::opc_ua
