// Populates the memory of the process before the cycle uses it.
#pragma once

namespace symplant::exec {

/// Populates every page of the program, its libraries and its heap, so that the cycle causes no page faults. Stacks of
/// threads and mappings larger than 256 MB are skipped. Does nothing before Linux 5.14. Takes milliseconds.
void populate_memory();

}  // namespace symplant::exec
