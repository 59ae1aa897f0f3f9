// The settings of a link `opc-ua`.
#include "symplant/link/opc_ua/client_settings.hpp"

#include <array>
#include <utility>

#include "symplant/link/opc_ua/address.hpp"
#include "symplant/link/opc_ua/node_id.hpp"

namespace symplant::link::opc_ua {

namespace {

/// The node ids of the tags of an S7-1500. Its namespace usually has the number 3, but may have another one.
constexpr std::string_view kS7 = "nsu=http://www.siemens.com/simatic-s7-opcua;s=\"{symbol}\"";

Problem read_nodes(std::string_view text, ClientSettings& settings) {
  settings.nodes = text == "s7" ? kS7 : text;
  return template_problem(settings.nodes);
}

using Key = UrlKey<ClientSettings>;
constexpr auto kKeys = joined(
    std::array{
        Key{"nodes", read_nodes},
        Key{"poll", [](std::string_view text, ClientSettings& s) { return read_time(text, s.times.poll, false); }},
        Key{"refresh",
            [](std::string_view text, ClientSettings& s) { return read_time(text, s.times.refresh, false); }},
        Key{"read-back",
            [](std::string_view text, ClientSettings& s) { return read_time(text, s.times.read_back, true); }},
        Key{"retry",
            [](std::string_view text, ClientSettings& s) { return read_time(text, s.times.first_retry, false); }},
        Key{"timeout", [](std::string_view text, ClientSettings& s) { return read_time(text, s.timeout, false); }},
        Key{"at-end", [](std::string_view text, ClientSettings& s) { return read_at_end(text, s.times.zero_at_end); }}},
    security_keys<ClientSettings>());

}  // namespace

std::variant<ClientSettings, LinkError> read_client_settings(std::string_view rest) {
  auto parsed = parse_address(rest, kClientScheme);
  if (auto* error = std::get_if<LinkError>(&parsed)) return std::move(*error);
  auto& address = std::get<Address>(parsed);
  if (address.at.port == 0) return usage_error("port 0 is not a port of a PLC: give the one in its parameters");
  ClientSettings settings;
  settings.address = std::move(address.at);
  settings.path = std::move(address.path);
  for (const UrlParameter& parameter : address.parameters) {
    Problem problem = read_parameter(parameter, kKeys, settings, "a link `opc-ua`", "docs/opc-ua.md");
    if (!problem.empty()) return usage_error(std::move(problem));
  }
  if (Problem problem = contradiction(settings.security); !problem.empty()) return usage_error(std::move(problem));
  return settings;
}

std::string client_fault(std::string_view rest) {
  const auto settings = read_client_settings(rest);
  const auto* const error = std::get_if<LinkError>(&settings);
  return error == nullptr ? std::string() : error->message;
}

}  // namespace symplant::link::opc_ua
