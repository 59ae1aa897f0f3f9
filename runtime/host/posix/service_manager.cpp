// The datagrams of sd_notify(3).
#include "symplant/host/service_manager.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

namespace symplant::host {
namespace {

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): no thread sets variables
  return value == nullptr ? std::string_view() : value;
}

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

tables::Time watchdog_of_environment() {
  constexpr std::uint64_t kMost = 1'000'000'000'000;  // us; so that nanoseconds fit
  const auto pid = number(variable("WATCHDOG_PID"));
  if (pid && *pid != static_cast<std::uint64_t>(getpid())) return 0;
  const auto us = number(variable("WATCHDOG_USEC"));
  return us && *us < kMost ? static_cast<tables::Time>(*us) * tables::kMicrosecond : 0;
}

}  // namespace

ServiceManager ServiceManager::of_environment() {
  return {std::string(variable("NOTIFY_SOCKET")), watchdog_of_environment()};
}

ServiceManager::ServiceManager(const std::string& socket, tables::Time watchdog) {
  sockaddr_un address{};
  if (socket.size() < 2 || socket.size() >= sizeof address.sun_path) return;
  if (socket.front() != '/' && socket.front() != '@') return;
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, socket.data(), socket.size());
  if (socket.front() == '@') address.sun_path[0] = '\0';  // an abstract name has no terminator, only a length
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + socket.size());
  socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (socket_ < 0) return;
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), size) == 0) {
    watchdog_ = watchdog;
  } else {
    ::close(std::exchange(socket_, -1));
  }
}

ServiceManager::ServiceManager(ServiceManager&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), watchdog_(other.watchdog_) {}

ServiceManager::~ServiceManager() {
  if (socket_ >= 0) ::close(socket_);
}

bool ServiceManager::report(const std::string& state) const noexcept {
  return socket_ >= 0 && ::send(socket_, state.data(), state.size(), MSG_NOSIGNAL | MSG_DONTWAIT) >= 0;
}

}  // namespace symplant::host
