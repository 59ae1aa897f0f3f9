// On Windows the guard checks nothing, and its reports give the reason.
#include "symplant/exec/guard/guard.hpp"

#include "symplant/exec/guard/interpose.hpp"
#include "symplant/exec/guard/system_calls.hpp"

namespace symplant::exec {
namespace guard {

std::string interpose() { return "functions are interposed on 64-bit Linux only"; }

std::string system_call_name(long number) { return "number " + std::to_string(number); }

}  // namespace guard

std::string trap_system_calls() { return "system calls are trapped on x86-64 Linux only"; }

std::string caller_of(const Violation& /*violation*/) { return {}; }

}  // namespace symplant::exec
