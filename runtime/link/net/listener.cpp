// Opens a listening TCP socket from HOST:PORT.
#include "symplant/link/net/listener.hpp"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "symplant/link/net/port_owner.hpp"

namespace symplant::link::net {

namespace {

constexpr int kFirstFreePort = 1024;  ///< ports below it need a privilege

LinkError usage(std::string message) { return {LinkError::Kind::usage, std::move(message)}; }
LinkError environment(std::string message) { return {LinkError::Kind::environment, std::move(message)}; }

/// Why a socket cannot be bound to `at`, an address of the host, and what to do.
LinkError bind_error(const HostPort& address, const sockaddr& at, int error) {
  const std::string port = "port " + std::to_string(address.port);
  if (error == EADDRINUSE) {
    const std::string in_use = port + " is in use on `" + address.host + "`";
    const auto owner = owner_of_port(at);
    if (owner && owner->process == ::getpid()) {
      return environment(in_use + " by this program itself (process " + std::to_string(owner->process) +
                         "): give each of its links its own port");
    }
    if (owner) {
      return environment(in_use + " by `" + owner->program + "` (process " + std::to_string(owner->process) +
                         "): end it, or give another port");
    }
    return environment(in_use + ": end the program that uses it (`sudo ss -ltnp` names it), or give another port");
  }
  if (error == EACCES && address.port < kFirstFreePort) {
    return environment("no permission for " + port +
                       ": give one from 1024 on, or allow this program the lower ones by `sudo setcap "
                       "cap_net_bind_service=+ep PROGRAM`");
  }
  if (error == EADDRNOTAVAIL) {
    return usage("host `" + address.host +
                 "` is not an address of this machine: give one that is, 127.0.0.1 for clients on it only");
  }
  return environment("cannot listen on `" + format_host_port(address) + "`: " + std::generic_category().message(error));
}

std::uint16_t port_of(int socket) {
  sockaddr_storage storage{};
  socklen_t size = sizeof storage;
  auto* generic = reinterpret_cast<sockaddr*>(&storage);
  if (::getsockname(socket, generic, &size) != 0) return 0;
  if (storage.ss_family == AF_INET6) return ntohs(reinterpret_cast<const sockaddr_in6*>(&storage)->sin6_port);
  return ntohs(reinterpret_cast<const sockaddr_in*>(&storage)->sin_port);
}

/// Nothing, with errno set, if the address is not available.
Descriptor listen_at(const addrinfo& address) {
  Descriptor socket(::socket(address.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!socket) return {};
  const int on = 1;  // connections of an earlier run that still close do not block the port
  ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (::bind(socket.get(), address.ai_addr, address.ai_addrlen) != 0) return {};
  if (::listen(socket.get(), SOMAXCONN) != 0) return {};
  return socket;
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
    Descriptor socket = listen_at(*one);
    if (socket) {
      const std::uint16_t port = port_of(socket.get());
      return Listener{std::move(socket), {address.host, port}};
    }
    error = errno;
    failed = one;
    if (!is_absent(error)) break;
  }
  return bind_error(address, *failed->ai_addr, error);
}

}  // namespace symplant::link::net
