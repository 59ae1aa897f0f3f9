// Which symbol stands where on a link: the default I/O map.
#include "symplant/link/io_map.hpp"

#include <optional>

#include "symplant/core/lists.hpp"

namespace symplant::link {

namespace {

constexpr std::uint32_t kPlaces = 65'536;  ///< of one table: protocol addresses have 16 bits
constexpr std::uint32_t kRounding = 16;
constexpr std::uint32_t kNoPlace = 0xFFFF'FFFF;

bool is_16_bits(core::DataType type) {
  return type == core::DataType::int_ || type == core::DataType::uint || type == core::DataType::word;
}

Table table_of(const core::SymbolRow& symbol) {
  const bool bit = symbol.type() == core::DataType::boolean;
  if (symbol.direction() == core::Direction::operation) return bit ? Table::coil : Table::holding_register;
  return bit ? Table::discrete_input : Table::input_register;
}

/// The table a symbol belongs on, or none with the reason noted in `map`.
std::optional<Table> sort_out(const core::SymbolRow& symbol, std::uint32_t index, IoMap& map) {
  if (symbol.form() == core::AddressForm::none) {
    map.without_address.push_back(index);
    return std::nullopt;
  }
  if (symbol.type() != core::DataType::boolean && !is_16_bits(symbol.type())) {
    map.too_wide.push_back(index);
    return std::nullopt;
  }
  return table_of(symbol);
}

/// Gives out the positions of packed tables; symbols of one address get one position.
class Packer {
 public:
  explicit Packer(const core::PlantTables& tables) : leader_(tables.symbols.size()), place_(tables.symbols.size()) {
    for (std::uint32_t symbol = 0; symbol < leader_.size(); ++symbol) leader_[symbol] = symbol;
    for (const core::SharedAddress& shared : tables.shared_addresses) {
      const core::SymbolRow& follower = tables.symbols[shared.symbol];
      const core::SymbolRow& leader = tables.symbols[shared.leader];
      if (table_of(follower) == table_of(leader)) leader_[shared.symbol] = shared.leader;
    }
    place_.assign(leader_.size(), kNoPlace);
  }

  /// kNoPlace where the table is full.
  std::uint32_t place(std::uint32_t symbol, Table table) {
    std::uint32_t first = symbol;
    while (leader_[first] != first) first = leader_[first];
    std::uint32_t& next = next_[static_cast<std::size_t>(table)];
    if (place_[first] == kNoPlace && next < kPlaces) place_[first] = next++;
    return place_[first];
  }

 private:
  std::vector<std::uint32_t> leader_;
  std::vector<std::uint32_t> place_;  ///< a leader: the position given to it and its followers
  std::array<std::uint32_t, kTables> next_{};
};

}  // namespace

IoMap make_io_map(const core::PlantTables& tables, std::uint32_t controller) {
  IoMap map;
  std::vector<std::optional<Table>> table_of_symbol;
  table_of_symbol.reserve(tables.symbols.size());
  for (std::uint32_t index = 0; index < tables.symbols.size(); ++index) {
    const core::SymbolRow& symbol = tables.symbols[index];
    const bool carried = core::controller_of(tables, index) == controller;
    const auto table = carried ? sort_out(symbol, index, map) : std::nullopt;
    table_of_symbol.push_back(table);
    const bool fits = symbol.form() == core::AddressForm::number && symbol.number < kPlaces;
    if (table && !fits) map.packed[static_cast<std::size_t>(*table)] = true;
  }

  Packer packer(tables);
  for (std::uint32_t index = 0; index < tables.symbols.size(); ++index) {
    if (!table_of_symbol[index]) continue;
    const Table table = *table_of_symbol[index];
    const auto t = static_cast<std::size_t>(table);
    const std::uint32_t number = map.packed[t] ? packer.place(index, table) : tables.symbols[index].number;
    if (number == kNoPlace) {
      map.too_many.push_back(index);
      continue;
    }
    map.points.push_back({index, table, static_cast<std::uint16_t>(number)});
    const std::uint32_t size = (number / kRounding + 1) * kRounding;
    if (size > map.sizes[t]) map.sizes[t] = size;
  }
  return map;
}

std::uint32_t modicon_number(Table table, std::uint16_t number) {
  constexpr std::array<std::uint32_t, kTables> kDigit = {0, 1, 4, 3};
  constexpr std::uint32_t kFiveDigits = 10'000;
  const std::uint32_t counted = number + 1U;
  const std::uint32_t digit = kDigit[static_cast<std::size_t>(table)];
  return digit * (counted < kFiveDigits ? kFiveDigits : 10 * kFiveDigits) + counted;
}

const char* table_name(Table table) {
  constexpr std::array<const char*, kTables> kNames = {"coil", "discrete input", "holding register", "input register"};
  return kNames[static_cast<std::size_t>(table)];
}

}  // namespace symplant::link
