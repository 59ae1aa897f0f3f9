// The sockets of a Modbus TCP server and the thread that serves them.
#include "symplant/link/modbus/server.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace symplant::link::modbus {

namespace {

/// How long no client is accepted after the process ran out of descriptors.
constexpr int kPauseMilliseconds = 100;

/// A connected socket that takes what it can; a peer that is gone raises no signal.
class SocketSink final : public Sink {
 public:
  explicit SocketSink(int fd) noexcept : fd_(fd) {}

  std::ptrdiff_t write(std::span<const std::uint8_t> bytes) noexcept override {
    for (;;) {
      const ssize_t sent = ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent >= 0) return sent;
      if (errno == EAGAIN || errno == EWOULDBLOCK) return 0;
      if (errno != EINTR) return -1;
    }
  }

 private:
  int fd_;
};

Descriptor or_throw(Descriptor descriptor, const char* what) {
  if (!descriptor) throw std::system_error(errno, std::generic_category(), what);
  return descriptor;
}

void watch(int epoll, int operation, int fd, std::uint32_t events) {
  epoll_event event{};
  event.events = events;
  event.data.fd = fd;
  if (::epoll_ctl(epoll, operation, fd, &event) != 0) {
    throw std::system_error(errno, std::generic_category(), "epoll_ctl");
  }
}

/// Runs `start` with every signal blocked, which the thread it starts inherits: signals are the host's.
template <class Start>
std::thread without_signals(Start start) {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  try {
    std::thread thread = start();
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return thread;
  } catch (...) {
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    throw;
  }
}

}  // namespace

struct Server::Client {
  Descriptor socket;
  Connection connection;
  std::uint64_t last_use = 0;
  std::uint32_t watched = EPOLLIN;
};

Server::Server(Descriptor listener, Responder& responder, std::size_t max_connections)
    : listener_(std::move(listener)),
      responder_(responder),
      max_connections_(std::max<std::size_t>(max_connections, 1)),
      epoll_(or_throw(Descriptor(::epoll_create1(EPOLL_CLOEXEC)), "epoll_create1")),
      wake_(or_throw(Descriptor(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), "eventfd")) {
  watch(epoll_.get(), EPOLL_CTL_ADD, wake_.get(), EPOLLIN);
  watch(epoll_.get(), EPOLL_CTL_ADD, listener_.get(), EPOLLIN);
  thread_ = without_signals([this] { return std::thread([this] { serve(); }); });
}

Server::~Server() {
  const std::uint64_t one = 1;
  // A fresh eventfd takes a one: there is nothing to wait for or to repeat.
  [[maybe_unused]] const ssize_t written = ::write(wake_.get(), &one, sizeof one);
  thread_.join();
}

void Server::serve() {
  std::array<epoll_event, 64> events{};
  for (;;) {
    const int timeout = listening_ ? -1 : kPauseMilliseconds;
    const int count = ::epoll_wait(epoll_.get(), events.data(), static_cast<int>(events.size()), timeout);
    if (!listening_) listen(true);
    for (int i = 0; i < count; ++i) {
      const epoll_event& event = events[static_cast<std::size_t>(i)];
      if (event.data.fd == wake_.get()) return;
      if (event.data.fd == listener_.get()) continue;
      const auto client = clients_.find(event.data.fd);
      if (client != clients_.end()) serve_client(*client->second, event.events);
    }
    // Last, so that no event above can be taken for a client that got a closed one's descriptor.
    for (int i = 0; i < count; ++i) {
      if (events[static_cast<std::size_t>(i)].data.fd == listener_.get()) accept_clients();
    }
  }
}

void Server::accept_clients() {
  for (;;) {
    Descriptor socket(::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (socket) {
      add_client(std::move(socket));
      continue;
    }
    if (errno == EINTR || errno == ECONNABORTED) continue;
    if (errno == EAGAIN || errno == EWOULDBLOCK) return;
    // No descriptor or memory left: one of ours is given up, else the listener rests, as it stays readable.
    if (close_oldest()) continue;
    listen(false);
    return;
  }
}

void Server::add_client(Descriptor socket) {
  if (clients_.size() >= max_connections_) close_oldest();
  const int on = 1;
  ::setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  ::setsockopt(socket.get(), SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
  const int fd = socket.get();
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = fd;
  if (::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, fd, &event) != 0) return;
  auto client = std::make_unique<Client>();
  client->socket = std::move(socket);
  client->last_use = ++uses_;
  clients_.emplace(fd, std::move(client));
  open_.store(static_cast<std::uint32_t>(clients_.size()), std::memory_order_relaxed);
}

void Server::serve_client(Client& client, std::uint32_t events) {
  const std::uint64_t before = client.connection.requests();
  SocketSink sink(client.socket.get());
  bool open = true;
  if ((events & EPOLLOUT) != 0) open = client.connection.resume(responder_, sink) == Connection::State::open;
  if (open && (events & (EPOLLIN | EPOLLHUP | EPOLLERR)) != 0) open = read_from(client);
  if (client.connection.requests() != before) client.last_use = ++uses_;
  if (!open || !rearm(client)) close_client(client.socket.get());
}

bool Server::read_from(Client& client) {
  // One read a turn, so that a busy client does not keep the others waiting.
  const auto room = client.connection.room();
  if (room.empty()) return true;
  const ssize_t count = ::recv(client.socket.get(), room.data(), room.size(), 0);
  if (count < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
  if (count == 0) return false;
  SocketSink sink(client.socket.get());
  return client.connection.received(static_cast<std::size_t>(count), responder_, sink) == Connection::State::open;
}

bool Server::rearm(Client& client) {
  const bool to_read = !client.connection.room().empty();
  const bool to_send = client.connection.has_answers_to_send();
  const std::uint32_t wanted = (to_read ? std::uint32_t{EPOLLIN} : 0U) | (to_send ? std::uint32_t{EPOLLOUT} : 0U);
  if (wanted == client.watched) return true;
  epoll_event event{};
  event.events = wanted;
  event.data.fd = client.socket.get();
  client.watched = wanted;
  return ::epoll_ctl(epoll_.get(), EPOLL_CTL_MOD, client.socket.get(), &event) == 0;
}

void Server::close_client(int fd) {
  clients_.erase(fd);
  open_.store(static_cast<std::uint32_t>(clients_.size()), std::memory_order_relaxed);
}

bool Server::close_oldest() {
  const auto oldest = std::min_element(clients_.begin(), clients_.end(), [](const auto& one, const auto& other) {
    return one.second->last_use < other.second->last_use;
  });
  if (oldest == clients_.end()) return false;
  close_client(oldest->first);
  return true;
}

void Server::listen(bool on) {
  epoll_event event{};
  event.events = on ? std::uint32_t{EPOLLIN} : 0U;
  event.data.fd = listener_.get();
  listening_ = ::epoll_ctl(epoll_.get(), EPOLL_CTL_MOD, listener_.get(), &event) == 0 && on;
}

}  // namespace symplant::link::modbus
