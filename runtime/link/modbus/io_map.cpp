// The I/O map of Modbus: the table and number of each symbol.
#include "symplant/link/modbus/io_map.hpp"

#include <algorithm>
#include <functional>

#include "symplant/tables/lists.hpp"

namespace symplant::link::modbus {

namespace {

constexpr std::uint32_t kAddresses = 65'536;  ///< size of a full table: protocol addresses have 16 bits
constexpr std::uint32_t kRounding = 16;
constexpr std::uint32_t kStatusRounding = 100;

Table table_of(const tables::SymbolRow& symbol) { return modbus::table_of(image::plane_of(symbol)); }

class MapMaker {
 public:
  MapMaker(const tables::PlantTables& tables, std::uint32_t controller, const LinkSettings& settings)
      : tables_(tables),
        controller_(controller),
        settings_(settings),
        leader_(tables.symbols.size()),
        position_(tables.symbols.size(), tables::kNone),
        word_orders_(tables.symbols.size()) {
    for (std::uint32_t symbol = 0; symbol < leader_.size(); ++symbol) leader_[symbol] = symbol;
    for (const tables::SharedAddress& shared : tables.shared_addresses) {
      if (table_of(tables.symbols[shared.symbol]) == table_of(tables.symbols[shared.leader])) {
        leader_[shared.symbol] = shared.leader;
      }
    }
  }

  IoMap run() {
    sort_out();
    std::stable_partition(carried_.begin(), carried_.end(), [](const Carried& c) { return c.number != tables::kNone; });
    // Symbols with internal addresses are the last ones with a number to be found: the others keep theirs.
    const auto is_internal = [&](const Carried& c) {
      return c.number == tables::kNone && tables_.symbols[c.symbol].form() == tables::AddressForm::internal;
    };
    const auto internal = std::stable_partition(carried_.begin(), carried_.end(), std::not_fn(is_internal));
    for (auto carried = carried_.begin(); carried != internal; ++carried) assign(*carried);
    place_after_numbers();
    for (auto carried = internal; carried != carried_.end(); ++carried) assign(*carried);
    std::sort(map_.points.begin(), map_.points.end(),
              [](const IoPoint& a, const IoPoint& b) { return a.symbol < b.symbol; });
    std::sort(map_.too_many.begin(), map_.too_many.end());
    map_.status_order = settings_.word_order;
    add_watchdog();
    add_status_block();
    set_sizes();
    return std::move(map_);
  }

 private:
  struct Carried {
    std::uint32_t symbol;
    std::uint32_t number;  ///< tables::kNone: yet to be packed
    bool given;            ///< the number comes from the settings
    WordOrder word_order;
    OnLoss on_loss;
  };

  /// Finds the symbols that the link carries, and those with a number of their address or settings.
  void sort_out() {
    const MapRow* next = settings_.rows.data();
    const MapRow* const end = next + settings_.rows.size();
    for (std::uint32_t index = 0; index < tables_.symbols.size(); ++index) {
      const bool is_set = next != end && next->symbol == index;
      const MapRow row = is_set ? *next++ : MapRow{.symbol = index};
      if (tables::controller_of(tables_, index) != controller_) continue;
      if (row.excluded) {
        map_.excluded.push_back(index);
        continue;
      }
      const tables::SymbolRow& symbol = tables_.symbols[index];
      const bool given = row.number != MapRow::kDefault;
      if (!given && symbol.form() == tables::AddressForm::none) {
        map_.without_address.push_back(index);
      } else if (!given && is_8_bits(symbol.type())) {
        map_.of_8_bits.push_back(index);
      } else {
        const std::uint32_t number = given ? row.number : own_number(symbol);
        const bool internal = symbol.form() == tables::AddressForm::internal;
        if (number == tables::kNone && !internal) map_.packed[static_cast<std::size_t>(table_of(symbol))] = true;
        const OnLoss on_loss = row.on_loss == OnLoss::as_link ? settings_.on_loss : row.on_loss;
        const WordOrder order = row.word_order == WordOrder::as_link ? settings_.word_order : row.word_order;
        carried_.push_back({index, number, given, order, on_loss});
      }
    }
    for (Carried& carried : carried_) {
      const Table table = table_of(tables_.symbols[carried.symbol]);
      if (map_.packed[static_cast<std::size_t>(table)] && !carried.given) carried.number = tables::kNone;
    }
  }

  /// The next packed symbols of a table come after its numbers.
  void place_after_numbers() {
    for (const IoPoint& point : map_.points) {
      std::uint32_t& next = next_[static_cast<std::size_t>(point.table)];
      next = std::max(next, (point.last() + kRounding) / kRounding * kRounding);
    }
  }

  void assign(const Carried& carried) {
    const tables::SymbolRow& symbol = tables_.symbols[carried.symbol];
    const Table table = table_of(symbol);
    const std::uint8_t width = image::words_of(symbol.type());
    const std::uint32_t number =
        carried.number != tables::kNone ? carried.number : packed(carried.symbol, table, width);
    if (number == tables::kNone) {
      map_.too_many.push_back(carried.symbol);
    } else if (number >= kAddresses || number + width > kAddresses) {
      fault(MapFault::Kind::beyond_end, carried.symbol);
    } else {
      occupy(
          map_.points.emplace_back(IoPoint{carried.symbol, table, number, width, carried.word_order, carried.on_loss}));
    }
  }

  /// The next free number of a packed table; symbols of one address get the same. tables::kNone if the table is full.
  std::uint32_t packed(std::uint32_t symbol, Table table, std::uint8_t width) {
    std::uint32_t first = symbol;
    while (leader_[first] != first) first = leader_[first];
    if (position_[first] != tables::kNone) return position_[first];
    std::uint32_t& next = next_[static_cast<std::size_t>(table)];
    const auto& owners = owners_[static_cast<std::size_t>(table)];
    const auto is_free = [&](std::uint32_t number) {
      for (std::uint32_t i = number; i < number + width && i < owners.size(); ++i) {
        if (owners[i] != tables::kNone) return false;
      }
      return true;
    };
    while (next + width <= kAddresses && !is_free(next)) ++next;
    if (next + width > kAddresses) return tables::kNone;
    position_[first] = next;
    next += width;
    return position_[first];
  }

  /// Symbols that share a number have the word order of the first one.
  void occupy(IoPoint& point) {
    auto& owners = owners_[static_cast<std::size_t>(point.table)];
    if (owners.size() <= point.last())
      owners.resize(std::max<std::size_t>(point.last() + 1, 2 * owners.size()), tables::kNone);
    std::uint32_t reported = tables::kNone;
    for (std::uint32_t number = point.number; number <= point.last(); ++number) {
      const std::uint32_t other = owners[number];
      if (other == tables::kNone) {
        owners[number] = point.symbol;
      } else if (may_share(point, other)) {
        point.word_order = word_orders_[other];
      } else if (other != reported) {
        fault(MapFault::Kind::overlap, other, point.symbol);
        reported = other;
      }
    }
    word_orders_[point.symbol] = point.word_order;
    highest_ = std::max(highest_, std::uint64_t{point.last()} + 1);
  }

  /// Whether `other`, a symbol on some of the point's registers, has the same address and width: then both may share
  /// it.
  bool may_share(const IoPoint& point, std::uint32_t other) const {
    const tables::SymbolRow& a = tables_.symbols[point.symbol];
    const tables::SymbolRow& b = tables_.symbols[other];
    if (image::words_of(a.type()) != image::words_of(b.type())) return false;
    if (leader_[point.symbol] == leader_[other]) return true;
    return a.form() == tables::AddressForm::number && b.form() == a.form() && a.number == b.number;
  }

  std::uint32_t owner_of(Table table, std::uint32_t first, std::uint32_t count) const {
    const auto& owners = owners_[static_cast<std::size_t>(table)];
    for (std::uint32_t i = first; i < first + count && i < owners.size(); ++i) {
      if (owners[i] != tables::kNone) return owners[i];
    }
    return tables::kNone;
  }

  std::uint32_t end_of(Table table) const {
    const std::uint32_t size = settings_.sizes[static_cast<std::size_t>(table)];
    return size == 0 ? kAddresses : size;
  }

  void add_watchdog() {
    if (settings_.watchdog == kNowhere) return;
    const std::uint32_t end = end_of(Table::holding_register);
    if (settings_.watchdog >= end) return fault(MapFault::Kind::watchdog_beyond, settings_.watchdog, end);
    map_.watchdog = settings_.watchdog;
    const std::uint32_t owner = owner_of(Table::holding_register, settings_.watchdog, 1);
    if (owner != tables::kNone) fault(MapFault::Kind::watchdog_overlap, owner);
  }

  void add_status_block() {
    if (settings_.status_block == kNowhere) return;
    const std::uint32_t end = end_of(Table::input_register);
    if (settings_.status_block == kAbove) {
      // `highest_` counts from 1: the first multiple of 100 not below it is above the highest number, which counts from
      // 0.
      const std::uint64_t first =
          std::max<std::uint64_t>(1, (highest_ + kStatusRounding - 1) / kStatusRounding) * kStatusRounding;
      map_.no_room_for_status = first + kStatusWords > end;
      if (!map_.no_room_for_status) map_.status_block = static_cast<std::uint32_t>(first);
      return;
    }
    if (settings_.status_block >= end || settings_.status_block + kStatusWords > end) {
      return fault(MapFault::Kind::status_beyond, settings_.status_block, end);
    }
    map_.status_block = settings_.status_block;
    const std::uint32_t owner = owner_of(Table::input_register, settings_.status_block, kStatusWords);
    if (owner != tables::kNone) fault(MapFault::Kind::status_overlap, owner);
  }

  void set_sizes() {
    std::array<std::uint32_t, kTables> needed{};
    for (const IoPoint& point : map_.points) {
      const auto t = static_cast<std::size_t>(point.table);
      needed[t] = std::max(needed[t], point.last() + 1);
      if (settings_.sizes[t] != 0 && point.last() >= settings_.sizes[t]) {
        fault(MapFault::Kind::beyond_size, point.symbol);
      }
    }
    const auto needs = [&](Table table, std::uint32_t end) {
      std::uint32_t& size = needed[static_cast<std::size_t>(table)];
      size = std::max(size, end);
    };
    if (map_.status_block) needs(Table::input_register, *map_.status_block + kStatusWords);
    if (map_.watchdog) needs(Table::holding_register, *map_.watchdog + 1);
    for (std::size_t t = 0; t < kTables; ++t) {
      const std::uint32_t rounded = (needed[t] + kRounding - 1) / kRounding * kRounding;
      map_.sizes[t] = settings_.sizes[t] != 0 ? settings_.sizes[t] : rounded;
    }
  }

  void fault(MapFault::Kind kind, std::uint32_t symbol, std::uint32_t other = tables::kNone) {
    map_.faults.push_back({kind, symbol, other});
  }

  const tables::PlantTables& tables_;
  const std::uint32_t controller_;
  const LinkSettings& settings_;
  IoMap map_;
  std::vector<Carried> carried_;
  std::vector<std::uint32_t> leader_;
  std::vector<std::uint32_t> position_;  ///< in a packed table: the number of a leader and its followers
  std::vector<WordOrder> word_orders_;   ///< by symbol that has a point
  std::array<std::uint32_t, kTables> next_{};
  std::array<std::vector<std::uint32_t>, kTables> owners_;  ///< by table and number: the first symbol, or tables::kNone
  std::uint64_t highest_ = 0;                               ///< the highest number of all tables, counted from 1
};

}  // namespace

IoMap make_io_map(const tables::PlantTables& tables, std::uint32_t controller, const LinkSettings& settings) {
  return MapMaker(tables, controller, settings).run();
}

std::uint32_t own_number(const tables::SymbolRow& symbol) {
  if (symbol.form() != tables::AddressForm::number) return tables::kNone;
  const std::uint64_t number = std::uint64_t{symbol.number} * image::words_of(symbol.type());
  return number + image::words_of(symbol.type()) <= kAddresses ? static_cast<std::uint32_t>(number) : tables::kNone;
}

std::uint32_t modicon_number(Table table, std::uint32_t number) {
  constexpr std::array<std::uint32_t, kTables> kDigit = {0, 1, 4, 3};
  constexpr std::uint32_t kFiveDigits = 10'000;
  const std::uint32_t counted = number + 1;
  const std::uint32_t digit = kDigit[static_cast<std::size_t>(table)];
  return digit * (counted < kFiveDigits ? kFiveDigits : 10 * kFiveDigits) + counted;
}

image::Map image_of(const tables::PlantTables& tables, const IoMap& map) {
  image::Map placed;
  std::array<std::vector<std::uint32_t>, kTables> firsts;  // by table of registers: the first one of each number
  for (const IoPoint& point : map.points) {
    if (!has_bits(point.table)) firsts[static_cast<std::size_t>(point.table)].push_back(point.number);
  }
  for (std::size_t t = 0; t < kTables; ++t) {
    std::sort(firsts[t].begin(), firsts[t].end());
    firsts[t].erase(std::unique(firsts[t].begin(), firsts[t].end()), firsts[t].end());
    placed.sizes[t] = has_bits(static_cast<Table>(t)) ? map.sizes[t] : static_cast<std::uint32_t>(firsts[t].size());
  }
  placed.points.reserve(map.points.size());
  for (const IoPoint& point : map.points) {
    const auto& numbers = firsts[static_cast<std::size_t>(point.table)];
    const auto place = std::lower_bound(numbers.begin(), numbers.end(), point.number) - numbers.begin();
    placed.points.push_back({point.symbol, plane_of(point.table),
                             has_bits(point.table) ? point.number : static_cast<std::uint32_t>(place), point.on_loss});
  }
  if (map.status_block) {
    std::uint32_t& size = placed.sizes[static_cast<std::size_t>(Plane::event_numbers)];
    placed.status = size;
    size += static_cast<std::uint32_t>(kStatusFields.size());
  }
  placed.hash = map_hash(tables, map);
  return placed;
}

std::vector<std::uint32_t> lanes_of(const IoMap& map, const image::Map& placed, Table table) {
  std::vector<std::uint32_t> lanes(map.sizes[static_cast<std::size_t>(table)], kNoLane);
  const auto place = [&](std::uint32_t first, std::uint32_t words, WordOrder order, std::uint32_t position) {
    for (std::uint32_t k = 0; k < words; ++k) {
      const std::uint32_t away = order == WordOrder::low_first ? k : words - 1 - k;
      lanes[first + away] = image::kLanesPerWord * position + k;
    }
  };
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    const IoPoint& point = map.points[i];
    if (point.table == table) place(point.number, point.width, point.word_order, placed.points[i].position);
  }
  if (table != Table::input_register || !placed.status) return lanes;
  std::uint32_t position = *placed.status;
  for (const StatusField& field : kStatusFields) {
    place(*map.status_block + field.first, field.words, map.status_order, position++);
  }
  return lanes;
}

const char* table_name(Table table) {
  constexpr std::array<const char*, kTables> kNames = {"coil", "discrete input", "holding register", "input register"};
  return kNames[static_cast<std::size_t>(table)];
}

}  // namespace symplant::link::modbus
