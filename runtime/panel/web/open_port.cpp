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

/// The tokens of a file, the trainer's first, then the trainee's and the viewer's; fresh ones for those that it does
/// not have, and without a file.
std::variant<Tokens, LinkError> tokens_of(const PanelOptions& options) {
  Tokens tokens;
  std::ifstream file;
  if (!options.token_file.empty()) {
    file.open(options.token_file);
    if (!file)
      return LinkError{LinkError::Kind::usage, fmt::format("cannot read a token from `{}`", options.token_file)};
  }
  for (const Role role : {Role::trainer, Role::trainee, Role::viewer}) {
    if (role != Role::trainer && !options.trainees) break;
    std::string& token = tokens[static_cast<std::size_t>(role)];
    if (options.token_file.empty() || !(file >> std::setw(kLongestToken + 1) >> token)) {
      if (role == Role::trainer && !options.token_file.empty()) {
        return LinkError{LinkError::Kind::usage, fmt::format("cannot read a token from `{}`", options.token_file)};
      }
      token = random_token();
    }
    if (!is_token(token)) {
      return LinkError{LinkError::Kind::usage,
                       fmt::format("the token in `{}` is not 32 to 256 letters, digits, `-` or `_`; make one with "
                                   "`openssl rand -hex 16`",
                                   options.token_file)};
    }
  }
  const auto& [viewer, trainee, trainer] = tokens;
  if (options.trainees && (trainer == trainee || trainer == viewer || trainee == viewer)) {
    return LinkError{LinkError::Kind::usage,
                     fmt::format("two tokens in `{}` are equal; the trainer's, the trainee's and the viewer's differ",
                                 options.token_file)};
  }
  return tokens;
}

/// HOST:PORT, where a port alone is one of the loopback address.
std::variant<link::net::HostPort, LinkError> address_of(const std::string& text) {
  const bool is_port =
      !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return link::net::parse_host_port(is_port ? "127.0.0.1:" + text : text);
}

}  // namespace

std::variant<OpenPort, LinkError> open_port(const PanelOptions& options) {
  auto tokens = tokens_of(options);
  if (auto* error = std::get_if<LinkError>(&tokens)) return std::move(*error);
  const auto address = address_of(options.address);
  if (const auto* error = std::get_if<LinkError>(&address)) return *error;
  auto listener = link::net::listen_on(std::get<link::net::HostPort>(address));
  if (auto* error = std::get_if<LinkError>(&listener)) return std::move(*error);
  auto& open = std::get<link::net::Listener>(listener);
  Access access(open.bound.host, open.bound.port, std::get<Tokens>(std::move(tokens)));
  return OpenPort{std::move(open), std::move(access)};
}

}  // namespace symplant::panel
