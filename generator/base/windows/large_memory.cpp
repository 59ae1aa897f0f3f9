// Windows chooses its pages itself.
#include "base/large_memory.hpp"

namespace symplant::base {

void expect_large(void* /*begin*/, std::size_t /*bytes*/) {}

void return_freed_memory() {}

}  // namespace symplant::base
