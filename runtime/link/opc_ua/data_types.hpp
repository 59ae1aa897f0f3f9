// The data types of symbols in OPC UA, and their values.
#pragma once

#include <cstdint>
#include <optional>

#include "symplant/link/opc_ua/open62541.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::opc_ua {

/// BOOL Boolean, SINT SByte, USINT and BYTE Byte, INT Int16, UINT and WORD UInt16, DINT Int32, UDINT and DWORD UInt32,
/// LINT Int64, ULINT and LWORD UInt64, REAL Float, LREAL Double.
const UA_DataType& data_type_of(tables::DataType type) noexcept;

/// A scalar of a type of data_type_of(), in memory of fixed size, so that making one allocates nothing.
class Scalar {
 public:
  /// `number` as image::number_of() makes it; of BOOL 0 or 1. Bits above those of the type do not matter.
  Scalar(std::uint64_t number, tables::DataType type) noexcept;

  /// A view of this scalar, valid as long as it. Not to be cleared.
  UA_Variant variant() const noexcept;

  /// Floating-point numbers are compared by their bits.
  friend bool operator==(const Scalar&, const Scalar&) noexcept = default;

 private:
  std::uint64_t bytes_ = 0;
  const UA_DataType* type_;
};

/// The number of a scalar as image::value_of() takes it; nothing if the value is not a scalar of the symbol's type.
std::optional<std::uint64_t> number_of(const UA_Variant& value, tables::DataType type) noexcept;

}  // namespace symplant::link::opc_ua
