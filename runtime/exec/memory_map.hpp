// The process's memory, had before the cycle needs it.
#pragma once

namespace symplant::exec {

/// Has the kernel bring in every page of the program, its libraries and its heap, so that the cycle is not the first to
/// touch one. Stacks of threads and what is larger than 256 MB are left as they are; where the kernel cannot (before
/// Linux 5.14), nothing is done. Costs milliseconds.
void populate_memory();

}  // namespace symplant::exec
