// Decides which rows are I/O: direction, type, address and initial value of each.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "model/plant_model.hpp"
#include "read/types/data_types.hpp"

namespace symplant::model {

using read::data_type;
using read::data_type_bits;
using read::data_type_name;

/// Reads an Initial cell of a type: TRUE, FALSE, 0, 1; decimal, 16#, 8#, 2#, TYPE#value, K and H constants; REAL. Empty
/// is 0. Nothing if it cannot be read or does not fit.
std::optional<std::uint64_t> initial_value(std::string_view text, tables::DataType type);

/// The addresses of a row.
struct RowAddress {
  std::optional<address::Address> address;
  std::string_view cell;      ///< the cell that counts; empty without an address
  std::string_view bad_cell;  ///< an address cell that is not an address; empty if there is none
  /// Set if both columns hold comparable addresses: the vendor's address, and whether the IEC address differs.
  std::optional<address::Address> vendor;
  bool contradicts = false;
};
/// `dialect` is that of the row's list.
RowAddress row_address(const read::ListRow& row, const address::Dialect& dialect);

/// Fills in a new I/O symbol without unit and leader, whose account is that of the reading. Returns the reason if the
/// row is not an I/O symbol, which then is not complete. The naming rule's evidence decides the direction, mostly the
/// address before the name.
std::optional<InternalReason> classify(const read::ListRow& row, const name::Reading& reading,
                                       const RowAddress& address, Symbol& symbol);

/// The radix of X and Y in the lists of a controller: as rows with both address columns prove, else `forced`, else
/// hexadecimal.
RadixChoice choose_radix(std::span<const read::SymbolTable* const> tables, std::optional<address::Radix> forced);

}  // namespace symplant::model
