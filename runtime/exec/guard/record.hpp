// What the guard's parts share: is this thread guarded, and the record of what it did.
#pragma once

#include "symplant/exec/guard/guard.hpp"

namespace symplant::exec::guard {

bool guarded() noexcept;
/// Callable from a signal handler.
void record(const Violation& violation) noexcept;

inline void note(Violation::Kind kind, const char* name, const void* caller) noexcept {
  if (guarded()) record({kind, name, 0, caller, {}});
}

}  // namespace symplant::exec::guard
