// Observations of the derivation that the model does not need: for the rules and for --verbose.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "address/address.hpp"
#include "description/description.hpp"
#include "read/symbol_table.hpp"

namespace symplant::model {

/// Two rows of one name. The first counts.
struct Duplicate {
  const read::ListRow* first;
  const read::ListRow* second;
  bool same;  ///< address and type agree: harmless
};

/// A unit with more symbols or states than a unit may have; its symbols stay unmodelled.
struct TooLarge {
  std::string_view path;
  std::vector<std::uint32_t> symbols;
  std::size_t operations;
  std::size_t events;
  std::size_t states;
};

/// A row with an input or output address whose type is not a type of I/O symbols.
struct TypelessIo {
  const read::ListRow* row;
  std::string_view address_cell;
};

/// A row whose two addresses differ; at least one is an input or output. The IEC address counts.
struct AddressContradiction {
  const read::ListRow* row = nullptr;
  std::uint32_t list = 0;
  address::Address vendor;
  address::Address iec;
};

/// An address cell that is not an address.
struct BadAddress {
  const read::ListRow* row;
  std::string_view cell;
};

/// Observations about one unit.
struct UnitEvidence {
  bool two_words = false;                         ///< X has only an operation, Y only an event: perhaps one state
  std::uint32_t initial_candidates = 0;           ///< states whose event has Initial TRUE
  std::vector<std::uint32_t> ambiguous_sequence;  ///< states with several candidates for their predecessor
};

/// Views and pointers refer to the symbol lists that PlantModel::lists keeps.
struct Evidence {
  std::vector<Duplicate> duplicates;
  std::vector<TooLarge> too_large;
  std::vector<BadAddress> bad_addresses;
  std::vector<AddressContradiction> address_contradictions;  ///< in list order
  std::vector<TypelessIo> typeless_io;
  /// Pairs of events on one address that different units drive: second, first; by the second.
  std::vector<std::array<std::uint32_t, 2>> driven_twice;
  std::vector<UnitEvidence> units;  ///< one for each of PlantModel::units
  /// Errors of the description: with any of them the model is incomplete and only fit for further checks.
  std::vector<description::DescriptionFault> faults;
  std::vector<description::DescriptionFault> warnings;  ///< of the description
  std::vector<std::string> decisions;                   ///< how many devices each pattern matches, for --verbose
};

}  // namespace symplant::model
