// From a message of HTTP to a request of the panel.
#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <variant>

#include "symplant/panel/answer.hpp"
#include "symplant/panel/web/routes.hpp"

namespace symplant::panel::web {

using Message = boost::beast::http::request<boost::beast::http::string_body>;

/// The request, which refers to the message; or an error after which the connection must be closed: the headers do not
/// say clearly where the message ends, or a header that decides about access is there twice.
std::variant<Request, Answer> read_request(const Message& message);

}  // namespace symplant::panel::web
