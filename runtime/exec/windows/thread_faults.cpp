// Windows counts no page faults of a thread.
#include "symplant/exec/thread_faults.hpp"

namespace symplant::exec {

ThreadFaults thread_faults() noexcept { return {}; }

}  // namespace symplant::exec
