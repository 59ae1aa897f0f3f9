// Windows cannot copy a process: the work is done in this one.
#include "batch/workers.hpp"

#include "symplant/program/crash.hpp"

namespace symplant::batch {

std::string do_in_processes(std::size_t count, std::size_t /*jobs*/,
                            const std::function<std::string(std::size_t)>& work,
                            const std::function<void(const Done&)>& done, const std::function<bool()>& stop) {
  const program::CallLimit limit;  // ends the program, since there is no other process
  for (std::size_t piece = 0; piece < count && !stop(); ++piece) done({piece, work(piece), ""});
  return "";
}

}  // namespace symplant::batch
