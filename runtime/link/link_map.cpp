// The policies of a link's symbols, in words.
#include "symplant/link/link_map.hpp"

namespace symplant::link {

std::string loss_words(const tables::PlantTables& tables, const LinkMap& map) {
  std::size_t all = 0;
  std::size_t zeroed = 0;
  for (const MappedSymbol& mapped : map.symbols) {
    if (tables.symbols[mapped.symbol].direction() != tables::Direction::operation) continue;
    ++all;
    if (mapped.on_loss == OnLoss::zero) ++zeroed;
  }
  if (zeroed == 0) return "hold";
  if (zeroed == all) return "go to zero";
  return "hold, " + std::to_string(zeroed) + " of " + std::to_string(all) + " go to zero";
}

}  // namespace symplant::link
