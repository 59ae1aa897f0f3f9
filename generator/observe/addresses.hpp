// Which symbol of a plant has an address.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

#include "model/plant_model.hpp"

namespace symplant::observe {

/// The addresses of all symbols: as the lists have them, vendor's and IEC, and as values, so that X1 is X0001.
class Addresses {
 public:
  /// The plant must outlive this object. O(symbols).
  explicit Addresses(const model::PlantModel& plant);

  /// The symbol with this address. Of several on one address that whose value the others follow. kNone if there is
  /// none, or one in several PLCs. O(lists).
  std::uint32_t symbol_at(std::string_view text) const;

 private:
  std::uint32_t symbol_at(const address::Address& address, std::uint32_t list) const;

  const model::PlantModel& plant_;
  std::unordered_map<std::string, std::uint32_t> texts_;           ///< in capitals
  std::unordered_multimap<std::uint64_t, std::uint32_t> numbers_;  ///< by Address::number
};

}  // namespace symplant::observe
