// The settings of a link `opc-ua-server`.
#include "symplant/link/opc_ua/server_settings.hpp"

#include <utility>

#include "symplant/link/opc_ua/address.hpp"

namespace symplant::link::opc_ua {

std::variant<ServerSettings, LinkError> read_server_settings(std::string_view rest) {
  auto parsed = parse_address(rest, kServerScheme);
  if (auto* error = std::get_if<LinkError>(&parsed)) return std::move(*error);
  auto& address = std::get<Address>(parsed);
  if (!address.path.empty()) {
    return usage_error("`" + address.path + "` after the port: the address of this server has no path, remove it");
  }
  ServerSettings settings;
  settings.address = std::move(address.at);
  constexpr auto kServerKeys = security_keys<ServerSettings>();
  for (const UrlParameter& parameter : address.parameters) {
    Problem problem = read_parameter(parameter, kServerKeys, settings, "a link `opc-ua-server`", "docs/opc-ua.md");
    if (!problem.empty()) return usage_error(std::move(problem));
  }
  if (Problem problem = contradiction(settings.security); !problem.empty()) return usage_error(std::move(problem));
  if (settings.security.security != Security::none && settings.security.user.empty()) {
    return usage_error("`security=sign` and `security=encrypt` need a user name: give `user=NAME&password-file=FILE`");
  }
  return settings;
}

}  // namespace symplant::link::opc_ua
