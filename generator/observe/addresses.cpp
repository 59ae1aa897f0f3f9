// Which symbol of a plant has an address.
#include "observe/addresses.hpp"

#include <array>
#include <optional>

#include "address/notation.hpp"
#include "text/ascii.hpp"

namespace symplant::observe {
namespace {

using model::kNone;

/// The symbol whose value this one has.
std::uint32_t leader_of(const model::PlantModel& plant, std::uint32_t symbol) {
  const std::uint32_t leader = plant.symbols[symbol].leader;
  return leader == kNone ? symbol : leader;
}

}  // namespace

Addresses::Addresses(const model::PlantModel& plant) : plant_(plant) {
  for (std::uint32_t s = 0; s < plant.symbols.size(); ++s) {
    const model::Symbol& symbol = plant.symbols[s];
    const std::uint32_t leader = leader_of(plant, s);
    for (const std::string_view text :
         {std::string_view(symbol.row->vendor_address), std::string_view(symbol.row->iec_address)}) {
      if (text.empty()) continue;
      const auto [found, is_new] = texts_.emplace(text::to_upper(text), leader);
      if (!is_new && found->second != leader) found->second = kNone;
    }
    if (symbol.address && leader == s) numbers_.emplace(symbol.address->number, s);
  }
}

std::uint32_t Addresses::symbol_at(std::string_view text) const {
  if (const auto found = texts_.find(text::to_upper(text)); found != texts_.end()) return found->second;
  std::uint32_t symbol = kNone;
  for (std::uint32_t list = 0; list < plant_.lists.size(); ++list) {
    for (const auto& address :
         std::array{address::parse(text, plant_.lists[list].dialect()), address::parse_iec(text)}) {
      const std::uint32_t found = address ? symbol_at(*address, list) : kNone;
      if (found != kNone && symbol != kNone && found != symbol) return kNone;
      if (found != kNone) symbol = found;
    }
  }
  return symbol;
}

std::uint32_t Addresses::symbol_at(const address::Address& address, std::uint32_t list) const {
  const auto [begin, end] = numbers_.equal_range(address.number);
  for (auto at = begin; at != end; ++at) {
    const model::Symbol& symbol = plant_.symbols[at->second];
    if (symbol.list == list && address::same_location(*symbol.address, address)) return at->second;
  }
  return kNone;
}

}  // namespace symplant::observe
