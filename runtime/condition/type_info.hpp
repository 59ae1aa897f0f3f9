// What the elementary types hold.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "symplant/tables/tables.hpp"

namespace symplant::condition {

struct TypeInfo {
  std::string_view name;
  int bits;
  tables::NumberKind kind;
};
/// In the order of tables::DataType.
inline constexpr std::array<TypeInfo, 15> kTypes{{
    {"BOOL", 1, tables::NumberKind::unsigned_integer},
    {"SINT", 8, tables::NumberKind::signed_integer},
    {"INT", 16, tables::NumberKind::signed_integer},
    {"DINT", 32, tables::NumberKind::signed_integer},
    {"LINT", 64, tables::NumberKind::signed_integer},
    {"USINT", 8, tables::NumberKind::unsigned_integer},
    {"UINT", 16, tables::NumberKind::unsigned_integer},
    {"UDINT", 32, tables::NumberKind::unsigned_integer},
    {"ULINT", 64, tables::NumberKind::unsigned_integer},
    {"BYTE", 8, tables::NumberKind::unsigned_integer},
    {"WORD", 16, tables::NumberKind::unsigned_integer},
    {"DWORD", 32, tables::NumberKind::unsigned_integer},
    {"LWORD", 64, tables::NumberKind::unsigned_integer},
    {"REAL", 32, tables::NumberKind::real},
    {"LREAL", 64, tables::NumberKind::real},
}};

inline const TypeInfo& info_of(tables::DataType type) { return kTypes[static_cast<std::size_t>(type)]; }

}  // namespace symplant::condition
