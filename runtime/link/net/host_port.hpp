// Host and port: their text, and the addresses of a host.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/link/link.hpp"
#include "symplant/link/net/system.hpp"

namespace symplant::link::net {

struct HostPort {
  std::string host;  ///< a name or an address; an IPv6 address without brackets
  std::uint16_t port = 0;
};

/// Splits HOST:PORT, [IPv6]:PORT or :PORT (the loopback address). Errors are of kind usage.
std::variant<HostPort, LinkError> parse_host_port(std::string_view text);

/// HOST:PORT as in a URL.
std::string format_host_port(const HostPort& address);

struct FreeAddresses {
  void operator()(addrinfo* list) const noexcept { ::freeaddrinfo(list); }
};
using Addresses = std::unique_ptr<addrinfo, FreeAddresses>;

/// The addresses of the host, to listen on (`to_listen`) or to connect to, for sockets of `type`. May wait for a name
/// server. An unknown host is an error of kind usage.
std::variant<Addresses, LinkError> resolve(const HostPort& address, int type, bool to_listen);

/// IPv4 first: most PLCs know only IPv4, and `localhost` resolves to IPv6 first on many systems.
std::vector<const addrinfo*> ipv4_first(const addrinfo* list);

}  // namespace symplant::link::net
