// Host and port: their text, and the addresses of a host.
#include "symplant/link/net/host_port.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

#include "symplant/link/net/socket.hpp"

namespace symplant::link::net {

namespace {

constexpr std::string_view kLoopback = "127.0.0.1";

LinkError address_error(LinkError::Kind kind, std::string message) { return {kind, std::move(message)}; }

LinkError bad_address(std::string message) { return address_error(LinkError::Kind::usage, std::move(message)); }

}  // namespace

std::variant<HostPort, LinkError> parse_host_port(std::string_view text) {
  const std::string shown = "`" + std::string(text) + "`";
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos)
    return bad_address(shown + " has no port: give HOST:PORT, such as 127.0.0.1:5020");
  std::string_view host = text.substr(0, colon);
  const std::string_view digits = text.substr(colon + 1);

  HostPort result;
  const char* end = digits.data() + digits.size();
  const auto [stop, fault] = std::from_chars(digits.data(), end, result.port);
  if (digits.empty() || fault != std::errc() || stop != end) {
    return bad_address(shown + " does not end in a port: give a number from 0 to 65535, 0 for any free port");
  }
  const bool bracketed = host.size() > 2 && host.front() == '[' && host.back() == ']';
  if (bracketed) host = host.substr(1, host.size() - 2);
  if (host.find_first_of("[]/@?# ") != std::string_view::npos || (!bracketed && host.find(':') != host.npos)) {
    return bad_address(shown + " is not HOST:PORT: put an IPv6 address in brackets, such as [::1]:5020");
  }
  result.host = host.empty() ? kLoopback : host;
  return result;
}

std::string format_host_port(const HostPort& address) {
  const bool brackets = address.host.find(':') != std::string::npos;
  return (brackets ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port);
}

std::variant<Addresses, LinkError> resolve(const HostPort& address, int type, bool to_listen) {
  start_sockets();
  addrinfo hints{};
  hints.ai_socktype = type;
  hints.ai_flags = (to_listen ? AI_PASSIVE : 0) | AI_NUMERICSERV;
  addrinfo* list = nullptr;
  const int fault = ::getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &list);
  if (fault == 0) return Addresses(list);
  const std::string why = "host `" + address.host + "` has no address (" + ::gai_strerror(fault) + ")";
  if (fault != EAI_NONAME && fault != EAI_FAIL) {
    return address_error(LinkError::Kind::environment, why + ": try again, or give a numeric address");
  }
  return bad_address(why + (to_listen ? ": give a name or an address of this machine, 127.0.0.1 for clients on it only"
                                      : ": give the name or the address of the PLC, such as 192.168.3.39"));
}

std::vector<const addrinfo*> ipv4_first(const addrinfo* list) {
  std::vector<const addrinfo*> all;
  for (const addrinfo* one = list; one != nullptr; one = one->ai_next) all.push_back(one);
  std::stable_partition(all.begin(), all.end(), [](const addrinfo* one) { return one->ai_family == AF_INET; });
  return all;
}

}  // namespace symplant::link::net
