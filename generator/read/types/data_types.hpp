// The elementary types of symbols, as the tools of all vendors name them.
#pragma once

#include <optional>
#include <string_view>

#include "symplant/tables/tables.hpp"

namespace symplant::read {

/// The I/O type of a list's type cell, without regard to ASCII case and blanks: IEC 61131-3 names, and those of GX
/// Works (English, Japanese, Korean), TIA, CX-Programmer, Logix and OPC servers; BIT is BOOL. Nothing for any other
/// type.
std::optional<tables::DataType> data_type(std::string_view text);
std::string_view data_type_name(tables::DataType type);
int data_type_bits(tables::DataType type);

}  // namespace symplant::read
