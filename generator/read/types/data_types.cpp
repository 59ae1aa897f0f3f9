// The elementary types of symbols.
#include "read/types/data_types.hpp"

#include <array>
#include <string>

#include "text/ascii.hpp"

namespace symplant::read {
namespace {

using tables::DataType;

struct TypeName {
  std::string_view name;
  DataType type;
  int bits;
};

/// IEC 61131-3, in the order of DataType.
constexpr std::array<TypeName, 15> kElementaryTypes{{
    {"BOOL", DataType::boolean, 1},
    {"SINT", DataType::sint, 8},
    {"INT", DataType::int_, 16},
    {"DINT", DataType::dint, 32},
    {"LINT", DataType::lint, 64},
    {"USINT", DataType::usint, 8},
    {"UINT", DataType::uint, 16},
    {"UDINT", DataType::udint, 32},
    {"ULINT", DataType::ulint, 64},
    {"BYTE", DataType::byte, 8},
    {"WORD", DataType::word, 16},
    {"DWORD", DataType::dword, 32},
    {"LWORD", DataType::lword, 64},
    {"REAL", DataType::real, 32},
    {"LREAL", DataType::lreal, 64},
}};

struct OtherName {
  std::string_view name;  ///< without blanks
  DataType type;
};

constexpr std::array kOtherNames{
    // Several tools
    OtherName{"BIT", DataType::boolean},
    OtherName{"EBOOL", DataType::boolean},
    OtherName{"CHAR", DataType::usint},
    // CX-Programmer
    OtherName{"CHANNEL", DataType::word},
    OtherName{"UINT_BCD", DataType::uint},
    OtherName{"UDINT_BCD", DataType::udint},
    // GX Works in English
    OtherName{"WORD[SIGNED]", DataType::int_},
    OtherName{"WORD[UNSIGNED]/BITSTRING[16-BIT]", DataType::word},
    OtherName{"DOUBLEWORD[SIGNED]", DataType::dint},
    OtherName{"DOUBLEWORD[UNSIGNED]/BITSTRING[32-BIT]", DataType::dword},
    OtherName{"FLOAT(SINGLEPRECISION)", DataType::real},
    OtherName{"FLOAT[SINGLEPRECISION]", DataType::real},
    OtherName{"FLOAT(DOUBLEPRECISION)", DataType::lreal},
    OtherName{"FLOAT[DOUBLEPRECISION]", DataType::lreal},
    // GX Works in Japanese
    OtherName{"ビット", DataType::boolean},
    OtherName{"ワード[符号付き]", DataType::int_},
    OtherName{"ワード[符号なし]/ビット列[16ビット]", DataType::word},
    OtherName{"ダブルワード[符号付き]", DataType::dint},
    OtherName{"ダブルワード[符号なし]/ビット列[32ビット]", DataType::dword},
    OtherName{"単精度実数", DataType::real},
    OtherName{"倍精度実数", DataType::lreal},
    // GX Works in Korean
    OtherName{"비트", DataType::boolean},
    OtherName{"워드[부호있음]", DataType::int_},
    OtherName{"워드[부호없음]/비트열[16비트]", DataType::word},
    OtherName{"더블워드[부호있음]", DataType::dint},
    OtherName{"더블워드[부호없음]/비트열[32비트]", DataType::dword},
    OtherName{"단정도실수", DataType::real},
    OtherName{"배정도실수", DataType::lreal},
    // OPC servers
    OtherName{"BOOLEAN", DataType::boolean},
    OtherName{"SHORT", DataType::int_},
    OtherName{"LONG", DataType::dint},
    OtherName{"LLONG", DataType::lint},
    OtherName{"QWORD", DataType::lword},
    OtherName{"FLOAT", DataType::real},
    OtherName{"DOUBLE", DataType::lreal},
};

/// The names that are not of IEC 61131-3. O(1).
std::optional<DataType> other_type(std::string_view text) {
  static const auto by_name = [] {
    text::ByName<DataType> types;
    for (const OtherName& other : kOtherNames) types.emplace(other.name, other.type);
    return types;
  }();
  const auto found = by_name.find(text);
  if (found == by_name.end()) return std::nullopt;
  return found->second;
}

constexpr std::size_t kLongestName = 128;

}  // namespace

std::optional<DataType> data_type(std::string_view text) {
  for (const TypeName& type : kElementaryTypes) {
    if (text::equal_ignoring_case(type.name, text)) return type.type;
  }
  if (text.find(' ') == text.npos) return other_type(text);
  if (text.size() > kLongestName) return std::nullopt;
  std::string joined(text);
  std::erase(joined, ' ');
  return other_type(joined);
}

std::string_view data_type_name(DataType type) { return kElementaryTypes[static_cast<std::size_t>(type)].name; }

int data_type_bits(DataType type) { return kElementaryTypes[static_cast<std::size_t>(type)].bits; }

}  // namespace symplant::read
