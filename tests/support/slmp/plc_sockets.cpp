// The sockets of a PLC: opening, accepting, closing.
#include "support/slmp/plc_sockets.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <future>
#include <stdexcept>
#include <string>

#include "support/slmp/plc_loop.hpp"

namespace symplant::test::slmp {
namespace {

constexpr int kPortAttempts = 50;

void make_nonblocking(int descriptor) {
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK);
  ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);
}

/// A socket bound on the loopback; no descriptor if the port is taken.
FileDescriptor bound(int type, std::uint16_t port, bool listens) {
  FileDescriptor socket(::socket(AF_INET, type, 0));
  make_nonblocking(socket.get());
  const int on = 1;
  if (type == SOCK_STREAM) ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return FileDescriptor();
  if (listens && ::listen(socket.get(), 16) != 0) return FileDescriptor();
  return socket;
}

std::uint16_t port_of(const FileDescriptor& socket) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  ::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
}

void reset_at_close(int descriptor) {
  const linger now{1, 0};
  ::setsockopt(descriptor, SOL_SOCKET, SO_LINGER, &now, sizeof now);
}

}  // namespace

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

FileDescriptor::~FileDescriptor() {
  if (number_ >= 0) ::close(number_);
}

PlcSockets::PlcSockets(const SocketOptions& options, PeerHandler& handler)
    : loop_(std::make_unique<Loop>(options, handler)) {}
PlcSockets::~PlcSockets() = default;

std::uint16_t PlcSockets::port() const { return loop_->port(); }
std::size_t PlcSockets::connections() const { return loop_->connections(); }

void PlcSockets::close_connections(bool with_reset) {
  loop_->run_inside([&] { loop_->close_all(with_reset); });
}

void PlcSockets::refuse_connections(bool on) {
  loop_->run_inside([&] { loop_->set_refusing(on); });
}

PlcSockets::Loop::Loop(const SocketOptions& options, PeerHandler& handler) : options_(options), handler_(handler) {
  open_ports();
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe for the PLC server");
  wake_read_ = FileDescriptor(ends[0]);
  wake_write_ = FileDescriptor(ends[1]);
  make_nonblocking(ends[0]);
  make_nonblocking(ends[1]);
  thread_ = std::thread([this] { run(); });
}

PlcSockets::Loop::~Loop() {
  stops_ = true;
  [[maybe_unused]] const ssize_t count = ::write(wake_write_.get(), "x", 1);
  thread_.join();
}

void PlcSockets::Loop::open_ports() {
  for (int attempt = 0; attempt < (options_.port == 0 ? kPortAttempts : 1); ++attempt) {
    if (open_both_on(options_.port)) return;
  }
  throw std::runtime_error("port " + std::to_string(options_.port) + " is taken");
}

bool PlcSockets::Loop::open_both_on(std::uint16_t port) {
  listener_ = FileDescriptor();
  reserved_ = FileDescriptor();
  datagrams_ = FileDescriptor();
  if (options_.tcp) {
    reserved_ = bound(SOCK_STREAM, port, false);
    if (reserved_.get() < 0) return false;
    port = port_of(reserved_);
    listener_ = bound(SOCK_STREAM, port, true);
    if (listener_.get() < 0) return false;
  }
  if (options_.udp) {
    datagrams_ = bound(SOCK_DGRAM, port, false);
    if (datagrams_.get() < 0) return false;
    port = port_of(datagrams_);
  }
  port_ = port;
  return true;
}

void PlcSockets::Loop::run_inside(const std::function<void()>& function) {
  std::promise<void> done;
  {
    const std::lock_guard lock(commands_mutex_);
    commands_.emplace_back([&] {
      function();
      done.set_value();
    });
  }
  [[maybe_unused]] const ssize_t count = ::write(wake_write_.get(), "x", 1);
  done.get_future().wait();
}

void PlcSockets::Loop::run_commands() {
  std::array<char, 64> bytes{};
  while (::read(wake_read_.get(), bytes.data(), bytes.size()) > 0) {
  }
  std::vector<std::function<void()>> commands;
  {
    const std::lock_guard lock(commands_mutex_);
    commands.swap(commands_);
  }
  for (const auto& command : commands) command();
}

void PlcSockets::Loop::close_all(bool with_reset) {
  for (auto& [id, contact] : contacts_) {
    if (!contact.peer.is_udp) end(contact, with_reset);
  }
  remove_closed();
}

void PlcSockets::Loop::set_refusing(bool on) {
  refuses_until_.reset();
  if (on) listener_ = FileDescriptor();
  if (!on) listen_again();
}

void PlcSockets::Loop::listen_again() {
  if (options_.tcp && listener_.get() < 0) listener_ = bound(SOCK_STREAM, port_, true);
}

void PlcSockets::Loop::accept_connection() {
  FileDescriptor socket(::accept(listener_.get(), nullptr, nullptr));
  if (socket.get() < 0) return;
  make_nonblocking(socket.get());
  const int on = 1;
  ::setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  // A connection that its client has closed before this attempt does not count any longer.
  read_connections();
  remove_closed();
  if (connection_count_ >= options_.most_connections) {
    reset_at_close(socket.get());
    handler_.refused_connection();
    return;
  }
  Contact& contact = contacts_[next_id_];
  contact.peer = {next_id_++, false};
  contact.socket = std::move(socket);
  ++connection_count_;
  handler_.accepted(contact.peer);
}

void PlcSockets::Loop::end(Contact& contact, bool with_reset) {
  if (contact.is_closed) return;
  if (with_reset) reset_at_close(contact.socket.get());
  contact.socket = FileDescriptor();
  contact.is_closed = true;
  --connection_count_;
  handler_.closed(contact.peer);
}

void PlcSockets::Loop::remove_closed() {
  std::erase_if(contacts_, [](const auto& each) { return each.second.is_closed; });
}

}  // namespace symplant::test::slmp
