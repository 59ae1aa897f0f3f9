// A PLC that serves Modbus TCP on the loopback.
#include "support/modbus/modbus_plc.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace symplant::test::modbus {

namespace {

constexpr std::size_t kHeader = 7;

void close_with_reset(int socket) {
  const linger now{1, 0};
  ::setsockopt(socket, SOL_SOCKET, SO_LINGER, &now, sizeof now);
  ::close(socket);
}

}  // namespace

ModbusPlc::ModbusPlc(PlcSetup setup)
    : setup_(std::move(setup)),
      listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)),
      wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const generic = reinterpret_cast<sockaddr*>(&address);
  if (::bind(listener_, generic, size) != 0 || ::listen(listener_, 16) != 0 ||
      ::getsockname(listener_, generic, &size) != 0) {
    throw std::runtime_error("the test PLC has no port");
  }
  port_ = ntohs(address.sin_port);
  thread_ = std::thread([this] { run(); });
}

ModbusPlc::~ModbusPlc() {
  stop_ = true;
  ::eventfd_write(wake_, 1);
  thread_.join();
  for (const Connection& connection : connections_) ::close(connection.socket);
  ::close(listener_);
  ::close(wake_);
}

void ModbusPlc::with(const std::function<void(PlcMemory&)>& use) {
  const std::scoped_lock lock(mutex_);
  use(setup_.memory);
}

void ModbusPlc::with_abilities(const std::function<void(PlcAbilities&)>& use) {
  const std::scoped_lock lock(mutex_);
  use(setup_.abilities);
}

void ModbusPlc::lie(const Lies& lies) {
  const std::scoped_lock lock(mutex_);
  lies_ = lies;
  random_.seed(lies.seed);
}

void ModbusPlc::close_connections() {
  const std::scoped_lock lock(mutex_);
  for (const Connection& connection : connections_) ::shutdown(connection.socket, SHUT_RDWR);
}

std::vector<Bytes> ModbusPlc::requests() {
  const std::scoped_lock lock(mutex_);
  return requests_;
}

std::vector<Written> ModbusPlc::written() {
  const std::scoped_lock lock(mutex_);
  return written_;
}

void ModbusPlc::forget_log() {
  const std::scoped_lock lock(mutex_);
  requests_.clear();
  written_.clear();
}

bool ModbusPlc::wait_until(const std::function<bool(PlcMemory&)>& holds) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, std::chrono::seconds(20), [&] { return holds(setup_.memory); });
}

void ModbusPlc::run() {
  while (!stop_) {
    std::vector<pollfd> watched = {{wake_, POLLIN, 0}, {listener_, POLLIN, 0}};
    for (const Connection& connection : connections_) watched.push_back({connection.socket, POLLIN, 0});
    ::poll(watched.data(), watched.size(), 1);
    const std::scoped_lock lock(mutex_);
    if (watched[1].revents != 0) {
      const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
      const int on = 1;
      ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
      if (socket >= 0) {
        connections_.push_back({socket});
        ++accepted_;
      }
    }
    for (auto connection = connections_.begin(); connection != connections_.end();) {
      const bool open = serve(*connection);
      if (!open) ::close(connection->socket);
      connection = open ? std::next(connection) : connections_.erase(connection);
    }
    if (setup_.program) setup_.program(setup_.memory);
    changed_.notify_all();
  }
}

/// False if the connection has ended.
bool ModbusPlc::serve(Connection& connection) {
  if (!connection.late.empty() && Clock::now() >= connection.due) {
    if (!send_now(connection, std::exchange(connection.late, {}))) return false;
  }
  std::array<std::uint8_t, 4096> part{};
  const ssize_t count = ::recv(connection.socket, part.data(), part.size(), 0);
  if (count == 0) return false;
  if (count < 0) return errno == EAGAIN || errno == EINTR;
  Bytes& received = connection.received;
  received.insert(received.end(), part.begin(), part.begin() + count);
  while (received.size() >= kHeader) {
    const std::size_t size = 6 + static_cast<std::size_t>(received[4]) * 256 + received[5];
    if (size < kHeader + 1 || size > 260 || received[2] != 0 || received[3] != 0) return false;
    if (received.size() < size) break;
    const auto end = received.begin() + static_cast<std::ptrdiff_t>(size);
    const Bytes frame(received.begin(), end);
    received.erase(received.begin(), end);
    if (!answer(connection, frame)) return false;
  }
  return true;
}

/// False if the connection is to be closed.
bool ModbusPlc::answer(Connection& connection, const Bytes& frame) {
  const Bytes request(frame.begin() + kHeader, frame.end());
  requests_.push_back(request);
  if (frame[6] != setup_.unit) return true;
  if (setup_.abilities.closing_functions.count(request[0]) != 0) return false;
  PlcAnswer answer = answer_of(request, setup_.memory, setup_.abilities);
  written_.insert(written_.end(), answer.written.begin(), answer.written.end());
  if (answer.reply.empty()) return true;
  Bytes reply(frame.begin(), frame.begin() + kHeader);
  reply[4] = 0;
  reply[5] = static_cast<std::uint8_t>(answer.reply.size() + 1);
  reply.insert(reply.end(), answer.reply.begin(), answer.reply.end());
  const Lying lying = lie_of(next_lie(), reply, connection.before, random_);
  connection.before = reply;
  if (lying.resets) {
    close_with_reset(std::exchange(connection.socket, -1));
    return false;
  }
  if (lying.is_late) {
    connection.late = reply;
    connection.due = Clock::now() + lies_.late_by;
    return true;
  }
  const bool sent = std::all_of(lying.segments.begin(), lying.segments.end(),
                                [&](const Bytes& segment) { return send_now(connection, segment); });
  return sent && ++connection.answers != setup_.abilities.closes_after;
}

bool ModbusPlc::send_now(const Connection& connection, const Bytes& bytes) const {
  const ssize_t sent = ::send(connection.socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  return sent == static_cast<ssize_t>(bytes.size());
}

Lie ModbusPlc::next_lie() {
  if (random_() % 1000 >= lies_.per_thousand) return Lie::none;
  const Lie lie =
      lies_.kinds.empty() ? static_cast<Lie>(1 + random_() % (kLies - 1)) : lies_.kinds[random_() % lies_.kinds.size()];
  ++lies_sent_;
  ++count_[static_cast<std::size_t>(lie)];
  return lie;
}

}  // namespace symplant::test::modbus
