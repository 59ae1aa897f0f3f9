// Products of 64-bit numbers without loss.
#pragma once

#include <cstdint>

namespace symplant::engine {

#if defined(__SIZEOF_INT128__)
__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;
#else
#error "the engine needs a 128-bit integer type"
#endif

}  // namespace symplant::engine
