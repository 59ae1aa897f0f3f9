// URLs of the links of OPC UA.
#include "symplant/link/opc_ua/address.hpp"

#include <utility>

namespace symplant::link::opc_ua {

std::variant<Address, LinkError> parse_address(std::string_view rest, std::string_view scheme) {
  if (rest.substr(0, 2) != "//") {
    return LinkError{LinkError::Kind::usage, "`" + std::string(rest) + "` after `" + std::string(scheme) +
                                                 ":` is not an address: give //HOST:PORT"};
  }
  rest.remove_prefix(2);
  const std::size_t question = rest.find('?');
  const std::string_view before = rest.substr(0, question);
  const std::size_t slash = before.find('/');
  auto at = net::parse_host_port(before.substr(0, slash));
  if (auto* error = std::get_if<LinkError>(&at)) return std::move(*error);
  auto parameters = parse_parameters(question == std::string_view::npos ? "" : rest.substr(question + 1));
  if (auto* error = std::get_if<LinkError>(&parameters)) return std::move(*error);
  return Address{std::move(std::get<net::HostPort>(at)),
                 slash == std::string_view::npos ? std::string() : std::string(before.substr(slash)),
                 std::move(std::get<std::vector<UrlParameter>>(parameters))};
}

}  // namespace symplant::link::opc_ua
