// The functions of heap and locks that the guard replaces.
#pragma once

#include <span>

#include "symplant/exec/guard/guard.hpp"

namespace symplant::exec::guard {

struct Hook {
  const char* symbol;  ///< the name for the linker
  const char* name;    ///< the name in reports
  Violation::Kind kind;
  void* ours;   ///< the replacement: records the call, then calls `*next`
  void** next;  ///< the original function; null until interpose() sets it
};

/// All hooks; the same array in each call.
std::span<const Hook> hooks() noexcept;

}  // namespace symplant::exec::guard
