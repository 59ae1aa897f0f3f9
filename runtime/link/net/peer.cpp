// The other end of an accepted TCP connection.
#include "symplant/link/net/peer.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <string_view>

#include "symplant/link/net/system.hpp"

namespace symplant::link::net {

namespace {

constexpr int kSilentSeconds = 10;
constexpr int kBetweenProbesSeconds = 5;
constexpr int kProbes = 3;
constexpr int kUnacknowledgedSeconds = 25;

void set(int socket, int level, int option, int value) noexcept {
  ::setsockopt(native(socket), level, option, reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

void prepare_peer(int socket) noexcept {
  set(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set(socket, IPPROTO_TCP, kKeepIdle, kSilentSeconds);
  set(socket, IPPROTO_TCP, kKeepInterval, kBetweenProbesSeconds);
  set(socket, IPPROTO_TCP, kKeepCount, kProbes);
  set(socket, IPPROTO_TCP, kLongestSilence, kUnacknowledgedSeconds * kSilenceUnits);
}

std::string peer_address(int socket) {
  sockaddr_storage storage{};
  socklen_t size = sizeof storage;
  auto* address = reinterpret_cast<sockaddr*>(&storage);
  std::array<char, NI_MAXHOST> text{};
  if (::getpeername(native(socket), address, &size) != 0 ||
      ::getnameinfo(address, size, text.data(), static_cast<socklen_t>(text.size()), nullptr, 0, NI_NUMERICHOST) != 0) {
    return {};
  }
  constexpr std::string_view kMapped = "::ffff:";
  const std::string_view shown = text.data();
  return std::string(shown.substr(0, kMapped.size()) == kMapped ? shown.substr(kMapped.size()) : shown);
}

std::uint32_t peer_ipv4(int socket) noexcept {
  sockaddr_storage storage{};
  socklen_t size = sizeof storage;
  if (::getpeername(native(socket), reinterpret_cast<sockaddr*>(&storage), &size) != 0) return 0;
  if (storage.ss_family == AF_INET) {
    sockaddr_in address{};
    std::memcpy(&address, &storage, sizeof address);
    return ntohl(address.sin_addr.s_addr);
  }
  sockaddr_in6 address{};
  std::memcpy(&address, &storage, sizeof address);
  if (storage.ss_family != AF_INET6 || IN6_IS_ADDR_V4MAPPED(&address.sin6_addr) == 0) return 0;
  constexpr std::size_t kMappedAt = 12;
  std::uint32_t ipv4 = 0;
  std::memcpy(&ipv4, &address.sin6_addr.s6_addr[kMappedAt], sizeof ipv4);
  return ntohl(ipv4);
}

}  // namespace symplant::link::net
