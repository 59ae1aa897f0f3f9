// The names of elementary types.
#include "read/types/data_types.hpp"

#include <string_view>
#include <vector>

#include "support/catch.hpp"

namespace symplant::read {
namespace {

using tables::DataType;

struct Names {
  DataType type;
  std::vector<std::string_view> names;
};

TEST_CASE("Each tool's names of elementary types are read") {
  const Names all[] = {
      {DataType::boolean, {"BOOL", "bool", "BIT", "Bit", "EBOOL", "Boolean", "ビット", "비트"}},
      {DataType::sint, {"SINT", "SInt"}},
      {DataType::int_, {"INT", "Int", "Short", "Word [Signed]", "Word[Signed]", "ワード[符号付き]", "워드[부호있음]"}},
      {DataType::dint, {"DINT", "Long", "Double Word [Signed]", "ダブルワード[符号付き]", "더블 워드[부호있음]"}},
      {DataType::lint, {"LINT", "LLong"}},
      {DataType::usint, {"USINT", "USInt", "Char"}},
      {DataType::uint, {"UINT", "UINT_BCD"}},
      {DataType::udint, {"UDINT", "UDINT_BCD"}},
      {DataType::ulint, {"ULINT"}},
      {DataType::byte, {"BYTE", "Byte"}},
      {DataType::word,
       {"WORD", "CHANNEL", "Word [Unsigned]/Bit String [16-bit]", "ワード[符号なし]/ビット列[16ビット]",
        "워드[부호없음]/비트열[16비트]"}},
      {DataType::dword,
       {"DWORD", "Double Word [Unsigned]/Bit String [32-bit]", "ダブルワード[符号なし]/ビット列[32ビット]",
        "더블 워드[부호없음]/비트열[32비트]"}},
      {DataType::lword, {"LWORD", "QWord"}},
      {DataType::real,
       {"REAL", "Float", "FLOAT (Single Precision)", "FLOAT [Single Precision]", "単精度実数", "단정도 실수"}},
      {DataType::lreal, {"LREAL", "Double", "FLOAT [Double Precision]", "倍精度実数", "배정도 실수"}},
  };
  for (const Names& names : all) {
    for (const std::string_view name : names.names) {
      INFO(name);
      CHECK(data_type(name) == names.type);
    }
  }
}

TEST_CASE("Other types are not elementary") {
  for (const std::string_view name :
       {"", " ", "TIME", "STRING", "STRING(32)", "TON", "BOOLX", "ARRAY [0..7] OF BOOL", "Word["}) {
    INFO(name);
    CHECK_FALSE(data_type(name));
  }
  CHECK_FALSE(data_type(std::string(100'000, ' ') + "BOOL"));
}

}  // namespace
}  // namespace symplant::read
