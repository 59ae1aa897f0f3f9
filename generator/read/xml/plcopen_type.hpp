// Types of PLCopen XML as text.
#pragma once

#include <string>

#include "read/xml/document.hpp"

namespace symplant::read::xml {

/// `BOOL`, `ARRAY [0..7] OF INT`, `STRING(80)`, `POINTER TO T` or the name of a derived type. A subrange has its base
/// type. Reads 64 levels at most.
std::string plcopen_type(Element type);

}  // namespace symplant::read::xml
