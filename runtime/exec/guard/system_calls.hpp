// Names of system calls, for reports.
#pragma once

#include <string>

namespace symplant::exec::guard {

/// The name of a system call, such as "write", or "number 512" if it is not in the table.
std::string system_call_name(long number);

}  // namespace symplant::exec::guard
