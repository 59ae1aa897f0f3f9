// Sockets by Winsock.
#include "symplant/link/net/socket.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <system_error>

#include "symplant/link/net/system.hpp"

namespace symplant::link::net {
namespace {

struct Error {
  int windows;
  int posix;
  const char* text;
};
constexpr std::array kErrors{
    Error{WSAEWOULDBLOCK, EAGAIN, "the call would wait"},
    Error{WSAEINTR, EINTR, "interrupted by a signal"},
    Error{WSAEACCES, EACCES, "no permission"},
    Error{WSAEMFILE, EMFILE, "too many sockets"},
    Error{WSAENOBUFS, ENOBUFS, "no memory for sockets"},
    Error{WSAEADDRINUSE, EADDRINUSE, "address in use"},
    Error{WSAEADDRNOTAVAIL, EADDRNOTAVAIL, "not an address of this machine"},
    Error{WSAEAFNOSUPPORT, EAFNOSUPPORT, "this kind of addresses is not supported"},
    Error{WSAECONNREFUSED, ECONNREFUSED, "Connection refused"},
    Error{WSAECONNRESET, ECONNRESET, "Connection reset by peer"},
    Error{WSAECONNABORTED, ECONNABORTED, "Software caused connection abort"},
    Error{WSAETIMEDOUT, ETIMEDOUT, "Connection timed out"},
    Error{WSAEHOSTUNREACH, EHOSTUNREACH, "No route to host"},
    Error{WSAENETUNREACH, ENETUNREACH, "Network is unreachable"},
    Error{WSAENETDOWN, ENETDOWN, "Network is down"},
    Error{WSAENOTCONN, ENOTCONN, "Not connected"},
};

int posix_of(int windows) noexcept {
  const auto known = std::find_if(kErrors.begin(), kErrors.end(), [&](const Error& e) { return e.windows == windows; });
  return known == kErrors.end() ? windows : known->posix;
}

Descriptor prepared(SOCKET socket) noexcept {
  if (socket == INVALID_SOCKET) return {};
  u_long on = 1;
  ::ioctlsocket(socket, static_cast<long>(FIONBIO), &on);
  ::SetHandleInformation(reinterpret_cast<HANDLE>(socket), HANDLE_FLAG_INHERIT, 0);
  return Descriptor(static_cast<int>(socket));
}

/// For select(): the time left, not negative.
timeval time_left(Deadline deadline) noexcept {
  using std::chrono::microseconds;
  const auto left = std::chrono::ceil<microseconds>(deadline - std::chrono::steady_clock::now()).count();
  const std::int64_t bounded = std::clamp<std::int64_t>(left, 0, std::int64_t{INT_MAX} * 1'000'000);
  return {.tv_sec = static_cast<long>(bounded / 1'000'000), .tv_usec = static_cast<long>(bounded % 1'000'000)};
}

/// A set of few sockets for select().
struct Sockets {
  void add(int socket) noexcept { set.fd_array[set.fd_count++] = native(socket); }
  bool has(int socket) noexcept { return FD_ISSET(native(socket), &set) != 0; }
  fd_set set{};
};

}  // namespace

void start_sockets() noexcept {
  static const int started = [] {
    WSADATA about{};
    return ::WSAStartup(MAKEWORD(2, 2), &about);
  }();
  static_cast<void>(started);
}

void close_socket(int socket) noexcept { ::closesocket(native(socket)); }

int last_error() noexcept { return posix_of(::WSAGetLastError()); }

std::string error_text(int error) {
  const auto known = std::find_if(kErrors.begin(), kErrors.end(), [&](const Error& e) { return e.posix == error; });
  return known == kErrors.end() ? std::system_category().message(error) : known->text;
}

bool would_wait(int error) noexcept { return error == EAGAIN; }
bool is_connecting(int error) noexcept { return error == EAGAIN; }

Descriptor open_socket(int family, int type) noexcept {
  start_sockets();
  return prepared(::socket(family, type, 0));
}

Descriptor accept_client(int listener) noexcept { return prepared(::accept(native(listener), nullptr, nullptr)); }

// SO_REUSEADDR would let two programs listen on one port here.
void take_port_soon(int socket) noexcept {
  const BOOL on = TRUE;
  ::setsockopt(native(socket), SOL_SOCKET, SO_EXCLUSIVEADDRUSE, reinterpret_cast<const char*>(&on), sizeof on);
}

// Another program's exclusive port may be reported as a lack of permission.
bool is_taken(int error) noexcept { return error == EADDRINUSE || error == EACCES; }

std::string how_to_get_port(std::uint16_t /*port*/) {
  return "Windows keeps it for another program, or for Hyper-V, WSL or Docker (`netsh interface ipv4 show "
         "excludedportrange protocol=tcp` lists these): give another port";
}

int pending_error(int socket) noexcept {
  int error = 0;
  int size = sizeof error;
  ::getsockopt(native(socket), SOL_SOCKET, SO_ERROR, reinterpret_cast<char*>(&error), &size);
  return posix_of(error);
}

std::ptrdiff_t receive(int socket, std::span<std::uint8_t> room) noexcept {
  const int count = ::recv(native(socket), reinterpret_cast<char*>(room.data()), static_cast<int>(room.size()), 0);
  if (count < 0 && ::WSAGetLastError() == WSAEMSGSIZE) return static_cast<std::ptrdiff_t>(room.size());
  return count;
}

std::ptrdiff_t send(int socket, std::span<const std::uint8_t> bytes) noexcept {
  return ::send(native(socket), reinterpret_cast<const char*>(bytes.data()), static_cast<int>(bytes.size()), 0);
}

// A datagram socket that is connected to itself.
Wakeup::Wakeup() : read_(open_socket(AF_INET, SOCK_DGRAM)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  int size = sizeof address;
  if (!read_ || ::bind(native(socket()), generic, size) != 0 || ::getsockname(native(socket()), generic, &size) != 0 ||
      ::connect(native(socket()), generic, size) != 0) {
    throw std::system_error(last_error(), std::generic_category(), "socket");
  }
}

void Wakeup::wake() noexcept {
  const std::uint8_t one = 1;
  send(socket(), {&one, 1});
}

// WSAPoll() of Windows before version 2004 does not report a connection that failed; select() does.
Readiness wait_for(int wakeup, int socket, Wanted wanted, Deadline deadline) noexcept {
  Sockets read;
  Sockets write;
  Sockets failed;
  read.add(wakeup);
  if (wanted.read) read.add(socket);
  if (wanted.write) write.add(socket);
  if (wanted.write) failed.add(socket);
  timeval left = time_left(deadline);
  if (::select(0, &read.set, &write.set, &failed.set, &left) <= 0) return {};
  return {read.has(wakeup), read.has(socket) || write.has(socket) || failed.has(socket)};
}

}  // namespace symplant::link::net
