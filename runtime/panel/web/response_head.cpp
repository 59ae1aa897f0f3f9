// The head of an answer.
#include "symplant/panel/web/response_head.hpp"

#include <fmt/format.h>

#include <boost/beast/http/status.hpp>
#include <iterator>

namespace symplant::panel::web {
namespace {

constexpr std::string_view kForAll =
    "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n"
    "Cache-Control: no-store\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\n";

}  // namespace

std::string text_of(const ResponseHead& head) {
  const auto reason = boost::beast::http::obsolete_reason(static_cast<boost::beast::http::status>(head.status));
  std::string text = fmt::format("HTTP/1.1 {} {}\r\nContent-Type: {}\r\n", head.status,
                                 std::string_view(reason.data(), reason.size()), head.content_type);
  text += kForAll;
  if (head.content_type == "image/svg+xml") text += "Content-Security-Policy: sandbox\r\n";  // it may have scripts
  if (head.packed) text += "Content-Encoding: gzip\r\n";
  if (head.by_encoding) text += "Vary: Accept-Encoding\r\n";
  if (!head.file_name.empty()) {
    fmt::format_to(std::back_inserter(text), "Content-Disposition: attachment; filename=\"{}\"\r\n", head.file_name);
  }
  if (head.length) fmt::format_to(std::back_inserter(text), "Content-Length: {}\r\n", *head.length);
  if (!head.keep_alive) text += "Connection: close\r\n";
  return text + "\r\n";
}

}  // namespace symplant::panel::web
