// The answer to a request of a client.
#include "symplant/panel/answer.hpp"

#include "symplant/panel/picture/json_text.hpp"

namespace symplant::panel {

Answer error_answer(int status, std::string_view what) {
  std::string body = "{";
  put_member(body, "error", what);
  return {status, body + "}"};
}

}  // namespace symplant::panel
