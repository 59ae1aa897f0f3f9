// Opens a listening TCP socket from HOST:PORT.
#include "symplant/link/net/listener.hpp"

#include <cerrno>

#include "symplant/link/net/port_owner.hpp"
#include "symplant/link/net/system.hpp"

namespace symplant::link::net {

namespace {

LinkError usage(std::string message) { return {LinkError::Kind::usage, std::move(message)}; }
LinkError environment(std::string message) { return {LinkError::Kind::environment, std::move(message)}; }

/// Why a socket cannot be bound to `at`, an address of the host, and what to do.
LinkError bind_error(const HostPort& address, const sockaddr& at, int error) {
  const std::string port = "port " + std::to_string(address.port);
  const auto owner = is_taken(error) ? owner_of_port(at) : std::nullopt;
  const std::string in_use = port + " is in use on `" + address.host + "`";
  if (owner && owner->is_this) {
    return environment(in_use + " by this program itself (process " + std::to_string(owner->process) +
                       "): give each of its links its own port");
  }
  if (owner) {
    return environment(in_use + " by `" + owner->program + "` (process " + std::to_string(owner->process) +
                       "): end it, or give another port");
  }
  if (error == EADDRINUSE) {
    return environment(in_use + ": end the program that uses it (`" + std::string(how_to_find_owner()) +
                       "` names it), or give another port");
  }
  if (error == EACCES) return environment("no permission for " + port + ": " + how_to_get_port(address.port));
  if (error == EADDRNOTAVAIL) {
    return usage("host `" + address.host +
                 "` is not an address of this machine: give one that is, 127.0.0.1 for clients on it only");
  }
  return environment("cannot listen on `" + format_host_port(address) + "`: " + error_text(error));
}

std::uint16_t port_of(int socket) {
  sockaddr_storage storage{};
  socklen_t size = sizeof storage;
  auto* generic = reinterpret_cast<sockaddr*>(&storage);
  if (::getsockname(native(socket), generic, &size) != 0) return 0;
  if (storage.ss_family == AF_INET6) return ntohs(reinterpret_cast<const sockaddr_in6*>(&storage)->sin6_port);
  return ntohs(reinterpret_cast<const sockaddr_in*>(&storage)->sin_port);
}

/// Listens with a new socket. Returns 0, or why the address is not available.
int listen_at(const addrinfo& address, Descriptor& socket) {
  socket = open_socket(address.ai_family, SOCK_STREAM);
  if (!socket) return last_error();
  take_port_soon(socket.get());
  if (::bind(native(socket.get()), address.ai_addr, static_cast<socklen_t>(address.ai_addrlen)) != 0)
    return last_error();
  return ::listen(native(socket.get()), SOMAXCONN) == 0 ? 0 : last_error();
}

/// Whether the machine does not have the address. Only then the next one is tried: if a port is in use at one address
/// and free at another, masters would reach the program at the first.
bool is_absent(int error) { return error == EADDRNOTAVAIL || error == EAFNOSUPPORT; }

}  // namespace

std::variant<Listener, LinkError> listen_on(const HostPort& address) {
  auto resolved = resolve(address, SOCK_STREAM, true);
  if (auto* error = std::get_if<LinkError>(&resolved)) return std::move(*error);
  const addrinfo* failed = nullptr;
  int error = EADDRNOTAVAIL;
  for (const addrinfo* one : ipv4_first(std::get<Addresses>(resolved).get())) {
    Descriptor socket;
    error = listen_at(*one, socket);
    if (error == 0) {
      const std::uint16_t port = port_of(socket.get());
      return Listener{std::move(socket), {address.host, port}};
    }
    failed = one;
    if (!is_absent(error)) break;
  }
  return bind_error(address, *failed->ai_addr, error);
}

}  // namespace symplant::link::net
