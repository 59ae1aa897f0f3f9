// Work for several processors at once.
#pragma once

#include <cstddef>
#include <functional>

namespace symplant::base {

/// The number of threads that work on this many rows is worth: 1 for a list that one thread reads in some milliseconds,
/// else as many as there are processors, up to 4.
std::size_t threads_for(std::size_t rows);

/// Calls `work` with each number below `count` once, from up to `threads` threads at the same time, including the
/// calling one. The order is not defined, so no call may depend on another. Returns after the last call; if calls
/// threw, it throws the exception of one of them. If fewer threads can be started, it only takes longer.
void for_each_number(std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& work);

}  // namespace symplant::base
