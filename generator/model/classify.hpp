// Which rows are I/O: direction, type, address and initial value of each.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "model/plant_model.hpp"

namespace symplant::model {

/// The I/O type of a list's type cell, compared without regard to case; BOOL's other spelling BIT counts. Nothing for
/// every other type.
std::optional<tables::DataType> data_type(std::string_view text);
std::string_view data_type_name(tables::DataType type);
int data_type_bits(tables::DataType type);

/// Reads an Initial cell of a type: TRUE, FALSE, 0, 1; decimal, 16#, 8#, 2#, TYPE#value, K and H constants; REAL. Empty
/// is 0. Nothing where it cannot be read or does not fit.
std::optional<std::uint64_t> initial_value(std::string_view text, tables::DataType type);

/// What one row is.
struct RowAddress {
  std::optional<address::Address> address;
  std::string_view cell;      ///< the one that counts; empty without an address
  std::string_view bad_cell;  ///< an address cell that is no address; empty where all are
  /// Where both columns hold an address that can be compared: the vendor's, and whether the IEC one is another.
  std::optional<address::Address> vendor;
  bool contradicts = false;
};
RowAddress row_address(const read::ListRow& row, address::Radix radix);

/// An I/O symbol without unit and leader, or why it is none.
std::variant<Symbol, InternalReason> classify(const read::ListRow& row, const name::NameReading& reading,
                                              const RowAddress& address);

/// How the rows of a controller's lists count X and Y: what rows with both address columns prove, else `forced`, else
/// hexadecimal.
RadixChoice choose_radix(std::span<const read::SymbolTable* const> tables, std::optional<address::Radix> forced);

}  // namespace symplant::model
