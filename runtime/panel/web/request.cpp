// From a message of HTTP to a request of the panel.
#include "symplant/panel/web/request.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "symplant/panel/web/gzip.hpp"
#include "symplant/panel/web/header_text.hpp"

namespace symplant::panel::web {
namespace {

/// Headers of which a request has one at most: another program between the client and this one might use the other.
constexpr const char* kSingle[] = {"Host",           "Origin",       "Authorization",     "X-Symplant-Run",
                                   "Content-Length", "Content-Type", "Transfer-Encoding", "X-Symplant-Name"};

std::string_view text_of(boost::beast::string_view text) { return {text.data(), text.size()}; }

/// All values of a header that is a list.
std::string list_of(const Message& message, const char* name) {
  std::string list;
  const auto [begin, end] = message.equal_range(name);
  for (auto field = begin; field != end; ++field) list += (list.empty() ? "" : ",") + std::string(field->value());
  return list;
}

}  // namespace

std::variant<Request, Answer> read_request(const Message& message) {
  for (const char* name : kSingle) {
    if (message.count(name) > 1) return error_answer(400, fmt::format("`{}` is there twice: send it once", name));
  }
  if (message.count("Transfer-Encoding") != 0) {
    if (message.count("Content-Length") != 0) {
      return error_answer(400, "`Content-Length` and `Transfer-Encoding` exclude each other: send one of them");
    }
    if (message.version() < 11) return error_answer(400, "`Transfer-Encoding` needs HTTP/1.1");
    if (!equal_ignoring_case(trimmed(text_of(message["Transfer-Encoding"])), "chunked")) {
      return error_answer(501, "the only `Transfer-Encoding` is `chunked`");
    }
  }
  return Request{text_of(message.method_string()),
                 text_of(message.target()),
                 {text_of(message["Host"]), text_of(message["Origin"]), text_of(message["Authorization"])},
                 text_of(message["X-Symplant-Run"]),
                 text_of(message["Content-Type"]),
                 message.body(),
                 accepts_gzip(list_of(message, "Accept-Encoding")),
                 text_of(message["X-Symplant-Name"])};
}

}  // namespace symplant::panel::web
