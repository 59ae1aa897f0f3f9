// The answer to a request of a client.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace symplant::panel {

/// The answer to a request.
struct Answer {
  int status = 200;
  std::string body;  ///< JSON
};
/// Called once, maybe by another thread, with the panel's mutex held.
using Answered = std::function<void(Answer)>;

Answer error_answer(int status, std::string_view what);

}  // namespace symplant::panel
