// Where the symbols of a controller are on its link, for people and for programs that show it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/link/link.hpp"
#include "symplant/link/link_settings.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link {

namespace modbus {
struct IoMap;
}

/// A symbol that the link carries.
struct MappedSymbol {
  std::uint32_t symbol = 0;
  std::string location;  ///< as the protocol writes it: "D100"
  WordOrder word_order = WordOrder::low_first;
  OnLoss on_loss = OnLoss::hold;  ///< of an operation
};

/// A symbol that the link does not carry.
struct Unreachable {
  std::uint32_t symbol;
  std::string reason;  ///< "has no address", "is BOOL at D100, which has 16 bits"
};

struct LinkMap {
  std::vector<MappedSymbol> symbols;  ///< ascending by symbol
  std::vector<Unreachable> left_out;
  std::vector<std::string> notes;  ///< for the user: "operations: 2 requests to read all"
  /// The tables that the clients of a Modbus server poll; null of another link.
  std::shared_ptr<const modbus::IoMap> served;
  std::string_view where = "in the PLC";  ///< what the locations are, for the title of their column
};

/// The map of a link by its URL. Opens nothing. An invalid URL, and symbols that the link cannot have together, are
/// errors of kind usage. A link without a URL, or one that carries symbols by name, has the map of a Modbus server.
/// O(symbols log symbols).
std::variant<LinkMap, LinkError> map_of(const LinkChoice& link, const tables::PlantTables& tables);

/// What operations do while the link is lost: "hold", "go to zero", "hold, 2 of 3 go to zero". O(symbols).
std::string loss_words(const tables::PlantTables& tables, const LinkMap& map);

}  // namespace symplant::link
