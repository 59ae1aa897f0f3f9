// Interposes the guard's functions for those of the allocator and of locks in a running program.
#pragma once

#include <string>

namespace symplant::exec::guard {

/// Routes every call of a heap or lock function between the program's files (the program and its libraries) through
/// the guard: replaces the addresses that the loader filled in. Call it before the threads to check start; after a
/// success further calls do nothing. Without the call a program has no cost. Returns the reason if that is not
/// possible, else an empty text. Not detected: calls within one file (locks inside glibc, for example), and calls from
/// libraries loaded later.
std::string interpose();

}  // namespace symplant::exec::guard
