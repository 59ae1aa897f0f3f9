// Where each symbol lies in a PLC that is a Modbus server.
#include "symplant/link/modbus/client_map.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "symplant/link/url_values.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::modbus {

namespace {

constexpr std::uint32_t kLastAddress = 65'535;

LinkError map_error(std::string message) { return {LinkError::Kind::usage, std::move(message)}; }

/// "holding registers 10-11", "holding register 1024.3".
std::string address_words(const IoPoint& point, const Placement& placement, BitOrder order) {
  const std::uint32_t first = address_of(placement, point.table, point.number);
  std::string text = range_text(area_name(placement.area), first, point.width);
  if (!is_packed(placement, point.table)) return text;
  const std::uint32_t bit = point.number % kBitsInRegister;
  return text + "." + std::to_string(order == BitOrder::low_first ? bit : kBitsInRegister - 1 - bit);
}

/// What a map occupies in the PLC.
struct Occupied {
  Area area;
  std::uint32_t first;
  std::uint32_t last;
  Table table;
  std::uint32_t point;  ///< tables::kNone: the status block
};

class MapChecker {
 public:
  MapChecker(const tables::PlantTables& tables, const IoMap& map, const ClientSettings& settings)
      : texts_(tables::split_names(tables.symbol_names)), map_(map), settings_(settings) {}

  std::optional<LinkError> error() {
    for (std::uint32_t i = 0; i < map_.points.size(); ++i) {
      const IoPoint& point = map_.points[i];
      if (auto error = add(point.table, point.number, point.width, i)) return error;
    }
    if (map_.status_block) {
      if (auto error = add(Table::input_register, *map_.status_block, kStatusWords, tables::kNone)) return error;
    }
    return overlap();
  }

 private:
  std::string name(std::uint32_t point) const {
    if (point == tables::kNone) return "the status block";
    return ticked_text(texts_[std::size_t{2} * map_.points[point].symbol]);
  }

  std::string location(const Occupied& one) const {
    if (one.point == tables::kNone) {
      return "holding registers " + std::to_string(one.first) + "-" + std::to_string(one.last);
    }
    const IoPoint& point = map_.points[one.point];
    return address_words(point, *settings_.placements[static_cast<std::size_t>(point.table)], settings_.bit_order);
  }

  std::optional<LinkError> add(Table table, std::uint32_t number, std::uint32_t width, std::uint32_t point) {
    const auto& placement = settings_.placements[static_cast<std::size_t>(table)];
    if (!placement) return no_choice(table, point);
    const std::uint32_t first = address_of(*placement, table, number);
    const Occupied one{placement->area, first, first + width - 1, table, point};
    if (one.last > kLastAddress) {
      return map_error(name(point) + " would be on " + location(one) +
                       ", but the last address of Modbus is 65535: use a lower offset");
    }
    occupied_.push_back(one);
    return std::nullopt;
  }

  /// Events have no default, since the PLC's program must read them where they are written.
  LinkError no_choice(Table table, std::uint32_t point) const {
    const bool bits = table == Table::discrete_input;
    return map_error(
        name(point) + (bits ? " is an event" : " is a numeric event") +
        ", and a Modbus client cannot write to inputs of a PLC: choose where its program reads events. " +
        (bits ? "`events=coils:OFFSET` or `events=holding-registers:OFFSET` (16 events in a register)"
              : "`event-values=holding-registers:OFFSET`") +
        ". OpenPLC: coils are %QX, %IX cannot be written, holding registers from 1024 on are %MW. FX: coils from 0 on "
        "are M, holding registers are D as its parameters assign them. Factory I/O as a server: coils and holding "
        "registers. docs/links.md compares them");
  }

  std::optional<LinkError> overlap() {
    std::sort(occupied_.begin(), occupied_.end(), [](const Occupied& a, const Occupied& b) {
      return std::tuple(a.area, a.first, a.point) < std::tuple(b.area, b.first, b.point);
    });
    std::array<const Occupied*, kTables> latest{};  // by table: what reaches furthest
    for (const Occupied& one : occupied_) {
      for (const Occupied* const other : latest) {
        if (other == nullptr || other->table == one.table || other->area != one.area || other->last < one.first)
          continue;
        return map_error(name(other->point) + " on " + location(*other) + " and " + name(one.point) + " on " +
                         location(one) +
                         " overlap in the PLC: give `operations`, `events`, `operation-values` and `event-values` "
                         "areas or offsets that keep them apart");
      }
      const Occupied*& mine = latest[static_cast<std::size_t>(one.table)];
      if (mine == nullptr || mine->area != one.area || mine->last < one.last) mine = &one;
    }
    return std::nullopt;
  }

  std::vector<std::string_view> texts_;  ///< two for each symbol: name, address
  const IoMap& map_;
  const ClientSettings& settings_;
  std::vector<Occupied> occupied_;
};

}  // namespace

std::variant<IoMap, LinkError> make_client_map(const tables::PlantTables& tables, std::uint32_t controller,
                                               const LinkSettings& link, const ClientSettings& settings) {
  if (link.watchdog != kNowhere && !link.reads_only) {
    return map_error("a link `modbus-tcp` has no `watchdog`: remove it; the link is lost if the PLC does not answer");
  }
  LinkSettings own = link;
  own.sizes = {};  // those of a server
  if (link.reads_only) own.watchdog = kNowhere;
  if (link.reads_only || own.status_block == kAbove) own.status_block = kNowhere;
  IoMap map = make_io_map(tables, controller, own);
  if (!map.faults.empty()) return map;
  if (auto error = MapChecker(tables, map, settings).error()) return std::move(*error);
  return map;
}

std::vector<std::string> client_addresses(const IoMap& map, const ClientSettings& settings) {
  std::vector<std::string> addresses;
  addresses.reserve(map.points.size());
  for (const IoPoint& point : map.points) {
    const auto& placement = settings.placements[static_cast<std::size_t>(point.table)];
    addresses.push_back(placement ? address_words(point, *placement, settings.bit_order) : "-");
  }
  return addresses;
}

}  // namespace symplant::link::modbus
