// Puts the guard's functions in the place of the allocator's and the locks', in a program that runs.
#pragma once

#include <string>

namespace symplant::exec::guard {

/// Every call between the program's files (itself, its libraries) of a function of heap or locks goes through the guard
/// from now on: the addresses that the loader has put in for them are replaced. To be called once, before the threads
/// to be looked at start; a further call does nothing. Until it is called a program pays nothing. Gives why that cannot
/// be; empty: it is so. Not seen: calls within one file (of glibc's own locks, say), and libraries that are loaded
/// later.
std::string interpose();

}  // namespace symplant::exec::guard
