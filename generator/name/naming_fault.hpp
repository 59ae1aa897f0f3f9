// Why a naming rule cannot be used.
#pragma once

#include <cstddef>
#include <string>

namespace symplant::name {

/// A fault of a naming rule: a JSON pointer into naming.json ("/rules/0/pattern") and a message. `column` is the offset
/// within the text at the pointer, in bytes from 0.
struct NamingFault {
  std::string pointer;
  std::string message;
  std::size_t column = 0;
};

}  // namespace symplant::name
