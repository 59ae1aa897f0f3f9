// Large blocks of memory, for which the system is asked for large pages.
//
// A list of a million rows fills several; getting them in pages of 4 KiB would take longer than reading the list.
#pragma once

#include <cstddef>

namespace symplant::base {

/// Hints to the system that all of a block, not yet written to, will be written. Does nothing for small blocks.
void expect_large(void* begin, std::size_t bytes);

/// Returns freed memory to the system, for a program that continues with little of the memory that it used. O(freed
/// blocks).
void return_freed_memory();

/// Reserves room for `count` items in a vector or string that will be filled.
template <class Items>
void reserve_large(Items& items, std::size_t count) {
  if (count <= items.capacity()) return;
  items.reserve(count);
  expect_large(items.data(), items.capacity() * sizeof(*items.data()));
}

}  // namespace symplant::base
