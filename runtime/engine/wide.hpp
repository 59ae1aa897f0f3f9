// 128-bit integers for exact products of 64-bit numbers.
#pragma once

#include <cstdint>

namespace symplant::engine {

#if defined(__SIZEOF_INT128__)
__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;
#else
#error "the engine needs a 128-bit integer type; compile with GCC or Clang for a 64-bit target"
#endif

}  // namespace symplant::engine
