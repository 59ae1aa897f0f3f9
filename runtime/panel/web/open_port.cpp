// Opens the port of a panel.
#include "symplant/panel/web/open_port.hpp"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <string>
#include <utility>

#include "symplant/panel/picture/json_text.hpp"

namespace symplant::panel {
namespace {

using link::LinkError;

/// The token of a file, or an error; a fresh token without a file.
std::variant<std::string, LinkError> token_of(const PanelOptions& options) {
  if (options.token_file.empty()) return random_token();
  std::ifstream file(options.token_file);
  std::string token;
  if (!file || !(file >> std::setw(kLongestToken + 1) >> token)) {
    return LinkError{LinkError::Kind::usage, fmt::format("cannot read a token from `{}`", options.token_file)};
  }
  if (is_token(token)) return token;
  return LinkError{LinkError::Kind::usage,
                   fmt::format("the token in `{}` is not 32 to 256 letters, digits, `-` or `_`; make one with "
                               "`openssl rand -hex 16`",
                               options.token_file)};
}

/// HOST:PORT, where a port alone is one of the loopback address.
std::variant<link::net::HostPort, LinkError> address_of(const std::string& text) {
  const bool is_port =
      !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return link::net::parse_host_port(is_port ? "127.0.0.1:" + text : text);
}

}  // namespace

std::variant<OpenPort, LinkError> open_port(const PanelOptions& options) {
  auto token = token_of(options);
  if (auto* error = std::get_if<LinkError>(&token)) return std::move(*error);
  const auto address = address_of(options.address);
  if (const auto* error = std::get_if<LinkError>(&address)) return *error;
  auto listener = link::net::listen_on(std::get<link::net::HostPort>(address));
  if (auto* error = std::get_if<LinkError>(&listener)) return std::move(*error);
  auto& open = std::get<link::net::Listener>(listener);
  Access access(open.bound.host, open.bound.port, std::get<std::string>(std::move(token)));
  return OpenPort{std::move(open), std::move(access)};
}

}  // namespace symplant::panel
