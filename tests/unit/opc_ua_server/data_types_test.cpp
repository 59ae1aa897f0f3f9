// The types of symbols in OPC UA.
#include "symplant/link/opc_ua/data_types.hpp"

#include <bit>
#include <string>

#include "support/catch.hpp"

using namespace symplant;
using link::opc_ua::data_type_of;
using link::opc_ua::number_of;
using link::opc_ua::Scalar;
using tables::DataType;

TEST_CASE("Each type of IEC 61131-3 has its type of OPC UA") {
  const auto name = [](DataType type) { return std::string(data_type_of(type).typeName); };
  CHECK(name(DataType::boolean) == "Boolean");
  CHECK(name(DataType::sint) == "SByte");
  CHECK(name(DataType::int_) == "Int16");
  CHECK(name(DataType::dint) == "Int32");
  CHECK(name(DataType::lint) == "Int64");
  CHECK(name(DataType::usint) == "Byte");
  CHECK(name(DataType::uint) == "UInt16");
  CHECK(name(DataType::udint) == "UInt32");
  CHECK(name(DataType::ulint) == "UInt64");
  CHECK(name(DataType::byte) == "Byte");
  CHECK(name(DataType::word) == "UInt16");
  CHECK(name(DataType::dword) == "UInt32");
  CHECK(name(DataType::lword) == "UInt64");
  CHECK(name(DataType::real) == "Float");
  CHECK(name(DataType::lreal) == "Double");
}

TEST_CASE("A number keeps its value as a scalar of its type") {
  for (int type = 0; type <= static_cast<int>(DataType::lreal); ++type) {
    for (const std::uint64_t number : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{0x7F}}) {
      const UA_Variant variant = Scalar(number, static_cast<DataType>(type)).variant();
      const std::uint64_t expected = type == 0 && number != 0 ? 1 : number;
      CHECK(number_of(variant, static_cast<DataType>(type)) == expected);
    }
  }
  const Scalar minus(static_cast<std::uint64_t>(-5), DataType::int_);
  CHECK(*static_cast<const std::int16_t*>(minus.variant().data) == -5);
  const Scalar half(std::bit_cast<std::uint32_t>(0.5F), DataType::real);
  CHECK(*static_cast<const float*>(half.variant().data) == 0.5F);
}

TEST_CASE("A value of another type, or an array, is not a number of the symbol") {
  const Scalar word(7, DataType::word);
  CHECK_FALSE(number_of(word.variant(), DataType::int_));
  CHECK_FALSE(number_of(word.variant(), DataType::dword));
  CHECK_FALSE(number_of(UA_Variant{}, DataType::word));
  std::uint16_t two[] = {1, 2};
  UA_Variant array;
  UA_Variant_setArray(&array, two, 2, &UA_TYPES[UA_TYPES_UINT16]);
  array.storageType = UA_VARIANT_DATA_NODELETE;
  CHECK_FALSE(number_of(array, DataType::word));
}
