// The functions of heap and locks that the guard takes the place of.
#pragma once

#include <span>

#include "symplant/exec/guard/guard.hpp"

namespace symplant::exec::guard {

struct Hook {
  const char* symbol;  ///< as the linker knows it
  const char* name;    ///< as people do
  Violation::Kind kind;
  void* ours;   ///< notes the call and makes it
  void** next;  ///< where `ours` finds the function itself; null until it is set
};

/// All of them; the same at each call.
std::span<const Hook> hooks() noexcept;

}  // namespace symplant::exec::guard
