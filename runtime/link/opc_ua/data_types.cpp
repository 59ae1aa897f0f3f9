// The data types of symbols in OPC UA.
#include "symplant/link/opc_ua/data_types.hpp"

#include <array>
#include <cstring>

namespace symplant::link::opc_ua {

const UA_DataType& data_type_of(tables::DataType type) noexcept {
  constexpr std::array<std::size_t, 15> kTypes = {
      UA_TYPES_BOOLEAN, UA_TYPES_SBYTE,  UA_TYPES_INT16,  UA_TYPES_INT32, UA_TYPES_INT64,  UA_TYPES_BYTE,
      UA_TYPES_UINT16,  UA_TYPES_UINT32, UA_TYPES_UINT64, UA_TYPES_BYTE,  UA_TYPES_UINT16, UA_TYPES_UINT32,
      UA_TYPES_UINT64,  UA_TYPES_FLOAT,  UA_TYPES_DOUBLE};  // in the order of tables::DataType
  return UA_TYPES[kTypes[static_cast<std::size_t>(type)]];
}

namespace {

template <class T>
std::uint64_t bytes_of(std::uint64_t number) noexcept {
  const T value = static_cast<T>(number);
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, &value, sizeof value);
  return bytes;
}

template <class T>
std::uint64_t read(const void* data) noexcept {
  T value;
  std::memcpy(&value, data, sizeof value);
  return value;
}

}  // namespace

Scalar::Scalar(std::uint64_t number, tables::DataType type) noexcept : type_(&data_type_of(type)) {
  // Floating-point numbers are their bits, and integers are truncated in two's complement.
  if (type == tables::DataType::boolean) number = number != 0 ? 1 : 0;
  switch (type_->memSize) {
    case 1:
      bytes_ = bytes_of<std::uint8_t>(number);
      break;
    case 2:
      bytes_ = bytes_of<std::uint16_t>(number);
      break;
    case 4:
      bytes_ = bytes_of<std::uint32_t>(number);
      break;
    default:
      bytes_ = number;
  }
}

UA_Variant Scalar::variant() const noexcept {
  UA_Variant view;
  UA_Variant_init(&view);
  UA_Variant_setScalar(&view, const_cast<std::uint64_t*>(&bytes_), type_);
  view.storageType = UA_VARIANT_DATA_NODELETE;
  return view;
}

std::optional<std::uint64_t> number_of(const UA_Variant& value, tables::DataType type) noexcept {
  const UA_DataType& expected = data_type_of(type);
  if (!UA_Variant_hasScalarType(&value, &expected)) return std::nullopt;
  switch (expected.memSize) {
    case 1:
      return read<std::uint8_t>(value.data);
    case 2:
      return read<std::uint16_t>(value.data);
    case 4:
      return read<std::uint32_t>(value.data);
    default:
      return read<std::uint64_t>(value.data);
  }
}

}  // namespace symplant::link::opc_ua
