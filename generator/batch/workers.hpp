// Work in several processes: a crash ends one of them, and only its piece of work.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace symplant::batch {

/// The outcome of a piece of work.
struct Done {
  std::size_t piece;
  std::string answer;  ///< of `work`; empty if its process ended before
  std::string words;   ///< then: the end of what it wrote to standard output and error, or how it ended
};

/// Does pieces 0 to `count` - 1 in `jobs` processes that are copies of this one (without threads), each piece in the
/// next process that is free; a process that ends gets a successor. Calls `done` in this process, in the order in which
/// they end. Asks `stop` ten times a second: if it returns true, all processes end, and pieces that have not ended are
/// not reported. Where processes cannot be copied, the work is done here, one after the other. Empty, or why it cannot
/// begin.
std::string do_in_processes(std::size_t count, std::size_t jobs, const std::function<std::string(std::size_t)>& work,
                            const std::function<void(const Done&)>& done, const std::function<bool()>& stop);

}  // namespace symplant::batch
