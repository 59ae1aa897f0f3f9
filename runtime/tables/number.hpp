// How numbers of symbols are kept and compared.
#pragma once

#include <cstdint>

namespace symplant::tables {

enum class Comparison : std::uint8_t { less, less_equal, equal, greater_equal, greater };
/// How the 64 bits of a slot are compared.
enum class NumberKind : std::uint8_t { signed_integer, unsigned_integer, real };

}  // namespace symplant::tables
