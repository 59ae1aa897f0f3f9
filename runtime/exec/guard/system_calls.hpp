// Names of system calls, for reports.
#pragma once

#include <string>

namespace symplant::exec::guard {

/// "write", or "number 512" of one that code of ours is not likely to make.
std::string system_call_name(long number);

}  // namespace symplant::exec::guard
