// The other end of an accepted TCP connection.
#include "symplant/link/net/peer.hpp"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <array>
#include <string_view>

namespace symplant::link::net {

namespace {

constexpr int kSilentSeconds = 10;
constexpr int kBetweenProbesSeconds = 5;
constexpr int kProbes = 3;
constexpr int kUnacknowledgedMilliseconds = 25'000;

void set(int socket, int level, int option, int value) noexcept {
  ::setsockopt(socket, level, option, &value, sizeof value);
}

}  // namespace

void prepare_peer(int socket) noexcept {
  set(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set(socket, IPPROTO_TCP, TCP_KEEPIDLE, kSilentSeconds);
  set(socket, IPPROTO_TCP, TCP_KEEPINTVL, kBetweenProbesSeconds);
  set(socket, IPPROTO_TCP, TCP_KEEPCNT, kProbes);
  set(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, kUnacknowledgedMilliseconds);
}

std::string peer_address(int socket) {
  sockaddr_storage storage{};
  socklen_t size = sizeof storage;
  auto* address = reinterpret_cast<sockaddr*>(&storage);
  std::array<char, NI_MAXHOST> text{};
  if (::getpeername(socket, address, &size) != 0 ||
      ::getnameinfo(address, size, text.data(), text.size(), nullptr, 0, NI_NUMERICHOST) != 0) {
    return {};
  }
  constexpr std::string_view kMapped = "::ffff:";
  const std::string_view shown = text.data();
  return std::string(shown.substr(0, kMapped.size()) == kMapped ? shown.substr(kMapped.size()) : shown);
}

}  // namespace symplant::link::net
