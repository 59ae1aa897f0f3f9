// Large blocks of memory, for which the system is asked for large pages: a list of a million rows fills some, and to
// get them in pages of 4 KiB would take longer than to read it.
#pragma once

#include <cstddef>

namespace symplant::base {

/// Tells that all of a block, not yet written to, will be. Only a hint; of small blocks nothing is told.
void expect_large(void* begin, std::size_t bytes);

/// Reserves room in a vector or string that will be filled.
template <class Items>
void reserve_large(Items& items, std::size_t count) {
  if (count <= items.capacity()) return;
  items.reserve(count);
  expect_large(items.data(), items.capacity() * sizeof(*items.data()));
}

}  // namespace symplant::base
