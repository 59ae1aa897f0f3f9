// The symbols that a link of OPC UA carries.
#include "symplant/link/opc_ua/carried.hpp"

#include "symplant/tables/lists.hpp"

namespace symplant::link::opc_ua {

Carried carried_symbols(const tables::PlantTables& tables, std::uint32_t controller, const LinkSettings& settings) {
  const auto symbols = static_cast<std::uint32_t>(tables.symbols.size());
  std::vector<std::uint32_t> leaders(symbols);
  for (std::uint32_t symbol = 0; symbol < symbols; ++symbol) leaders[symbol] = symbol;
  for (const tables::SharedAddress& shared : tables.shared_addresses) leaders[shared.symbol] = shared.leader;

  Carried carried;
  std::vector<std::uint32_t> positions(symbols, tables::kNone);  // of leaders
  auto row = settings.rows.begin();
  for (std::uint32_t symbol = 0; symbol < symbols; ++symbol) {
    MapRow own;
    if (row != settings.rows.end() && row->symbol == symbol) own = *row++;
    if (tables::controller_of(tables, symbol) != controller && controller != kAllControllers) continue;
    if (own.excluded) {
      carried.left_out.push_back({symbol, "is excluded from the link"});
      continue;
    }
    const Plane plane = image::plane_of(tables.symbols[symbol]);
    // Addresses are shared within a plane only.
    std::uint32_t& position = positions[leaders[symbol]];
    if (position == tables::kNone) position = carried.map.sizes[static_cast<std::size_t>(plane)]++;
    carried.map.points.push_back(
        {symbol, plane, position, own.on_loss == OnLoss::as_link ? settings.on_loss : own.on_loss});
  }
  return carried;
}

}  // namespace symplant::link::opc_ua
