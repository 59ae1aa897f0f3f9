// Shared by the parts of the guard: whether this thread is guarded, and its record of violations.
#pragma once

#include "symplant/exec/guard/guard.hpp"

namespace symplant::exec::guard {

bool guarded() noexcept;
/// Records a violation of the calling thread. Async-signal-safe.
void record(const Violation& violation) noexcept;

inline void note(Violation::Kind kind, const char* name, const void* caller) noexcept {
  if (guarded()) record({kind, name, 0, caller, {}});
}

}  // namespace symplant::exec::guard
