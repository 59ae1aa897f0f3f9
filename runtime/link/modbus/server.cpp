// The sockets of a Modbus TCP server and the thread that serves them.
#include "symplant/link/modbus/server.hpp"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>

#include "symplant/link/net/descriptors.hpp"
#include "symplant/link/net/no_signals.hpp"
#include "symplant/link/net/peer.hpp"

namespace symplant::link::modbus {

namespace {

/// No client is accepted for this long after the system had no descriptor or memory for one.
constexpr int kPauseMilliseconds = 100;
/// A client with a request within this time is not closed to get a descriptor for a new one.
constexpr tables::Time kQuiet = 10 * tables::kSecond;
/// Number of clients accepted before the existing ones are served again.
constexpr int kAcceptsATurn = 64;

tables::Time steady_now() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

/// A connected socket that takes what it can without waiting; a peer that is gone raises no signal.
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

net::Descriptor or_throw(net::Descriptor descriptor, const char* what) {
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

}  // namespace

struct Server::Client {
  explicit Client(const ClientId& id) : connection(id) {}

  net::Descriptor socket;
  Connection connection;
  std::uint64_t last_use = 0;
  tables::Time last_request = 0;  ///< or the time when it was accepted
  tables::Time frame_begun = 0;   ///< begin of the frame that is still incomplete; 0: no such frame
  std::uint32_t watched = EPOLLIN;
  bool kept = false;
  bool ended = false;  ///< sends no more, but still gets its answers
};

Server::Server(net::Descriptor listener, Responder& responder, ServerOptions options)
    : listener_(std::move(listener)),
      responder_(responder),
      options_(std::move(options)),
      epoll_(or_throw(net::Descriptor(::epoll_create1(EPOLL_CLOEXEC)), "epoll_create1")),
      wake_(or_throw(net::Descriptor(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), "eventfd")) {
  options_.connections = std::max<std::size_t>(options_.connections, 1);
  net::make_room_for(options_.connections);
  watch(epoll_.get(), EPOLL_CTL_ADD, wake_.get(), EPOLLIN);
  watch(epoll_.get(), EPOLL_CTL_ADD, listener_.get(), EPOLLIN);
  const net::NoSignals blocked;
  thread_ = std::thread([this] { serve(); });
}

Server::~Server() {
  const std::uint64_t one = 1;
  // A write of 1 to a new eventfd never blocks and never fails, so it needs no retry.
  [[maybe_unused]] const ssize_t written = ::write(wake_.get(), &one, sizeof one);
  thread_.join();
}

void Server::serve() {
  std::array<epoll_event, 64> events{};
  for (;;) {
    const int count =
        ::epoll_wait(epoll_.get(), events.data(), static_cast<int>(events.size()), milliseconds_to_wait());
    now_ = steady_now();
    if (!listening_) listen(true);
    if (cut_.load(std::memory_order_relaxed)) close_all();
    for (int i = 0; i < count; ++i) {
      const epoll_event& event = events[static_cast<std::size_t>(i)];
      if (event.data.fd == wake_.get()) return;
      if (event.data.fd == listener_.get()) continue;
      const auto client = clients_.find(event.data.fd);
      if (client != clients_.end()) serve_client(*client->second, event.events);
    }
    // Last, so that no event above is mistaken for one of a new client with the descriptor of a closed one.
    for (int i = 0; i < count; ++i) {
      if (events[static_cast<std::size_t>(i)].data.fd == listener_.get()) accept_clients();
    }
    if (now_ >= next_sweep_) close_overdue();
  }
}

int Server::milliseconds_to_wait() const noexcept {
  if (!listening_) return kPauseMilliseconds;
  if (clients_.empty()) return -1;
  const tables::Time left = std::max<tables::Time>(next_sweep_ - now_, 0);
  return static_cast<int>((left + tables::kMillisecond - 1) / tables::kMillisecond);
}

void Server::accept_clients() {
  for (int i = 0; i < kAcceptsATurn; ++i) {
    net::Descriptor socket(::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (socket) {
      gave_way_ = false;
      if (!cut_.load(std::memory_order_relaxed)) add_client(std::move(socket));
      continue;
    }
    switch (net::after_accept(errno)) {
      case net::AfterAccept::again:
        continue;
      case net::AfterAccept::serve:
        return;
      case net::AfterAccept::give_way:
        // Only once until an accept succeeds: closing a client may not free what is short.
        if (!gave_way_ && make_room(kQuiet)) {
          gave_way_ = true;
          continue;
        }
        break;
      case net::AfterAccept::pause:
        break;
    }
    listen(false);  // the listener stays readable
    return;
  }
}

void Server::add_client(net::Descriptor socket) {
  if (clients_.size() >= options_.connections && !make_room(0)) {
    crowded_out_.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  net::prepare_peer(socket.get());
  const int fd = socket.get();
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = fd;
  if (::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, fd, &event) != 0) return;
  auto client = std::make_unique<Client>(ClientId{++accepted_, net::peer_ipv4(fd)});
  client->socket = std::move(socket);
  client->last_use = ++uses_;
  client->last_request = now_;
  client->kept = !options_.keep.empty() &&
                 std::find(options_.keep.begin(), options_.keep.end(), net::peer_address(fd)) != options_.keep.end();
  if (clients_.empty()) next_sweep_ = now_;
  clients_.emplace(fd, std::move(client));
  open_.store(static_cast<std::uint32_t>(clients_.size()), std::memory_order_relaxed);
}

void Server::serve_client(Client& client, std::uint32_t events) {
  const std::uint64_t before = client.connection.requests();
  SocketSink sink(client.socket.get());
  bool open = true;
  if ((events & EPOLLOUT) != 0) open = client.connection.resume(responder_, sink) == Connection::State::open;
  if (open && (events & (EPOLLIN | EPOLLHUP | EPOLLERR)) != 0) open = read_from(client);
  note_progress(client, before);
  if (client.ended && !client.connection.has_answers_to_send()) open = false;
  if (!open || !rearm(client)) close_client(client.socket.get());
}

void Server::note_progress(Client& client, std::uint64_t requests_before) noexcept {
  const bool answered = client.connection.requests() != requests_before;
  if (answered) {
    client.last_use = ++uses_;
    client.last_request = now_;
  }
  // A request that waits until the peer takes its answers does not count as an incomplete frame.
  const bool partial = client.connection.holds_part_of_frame() && !client.connection.has_answers_to_send();
  if (!partial) {
    client.frame_begun = 0;
  } else if (client.frame_begun == 0 || answered) {
    client.frame_begun = now_;
  }
}

bool Server::read_from(Client& client) {
  // One read per turn, so that a busy client does not delay the others.
  const auto room = client.connection.room();
  if (room.empty()) return true;
  const ssize_t count = ::recv(client.socket.get(), room.data(), room.size(), 0);
  if (count < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
  if (count == 0) {
    client.ended = true;
    return true;
  }
  SocketSink sink(client.socket.get());
  return client.connection.received(static_cast<std::size_t>(count), responder_, sink) == Connection::State::open;
}

bool Server::rearm(Client& client) {
  const bool to_read = !client.ended && !client.connection.room().empty();
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
  const auto client = clients_.find(fd);
  responder_.left(client->second->connection.client());
  clients_.erase(client);
  open_.store(static_cast<std::uint32_t>(clients_.size()), std::memory_order_relaxed);
}

void Server::close_all() {
  for (const auto& [fd, client] : clients_) responder_.left(client->connection.client());
  clients_.clear();
  open_.store(0, std::memory_order_relaxed);
}

bool Server::make_room(tables::Time quiet) {
  const auto rank = [](const Client& client) { return std::pair(client.connection.requests() != 0, client.last_use); };
  Client* victim = nullptr;
  for (const auto& [fd, client] : clients_) {
    const bool asks = client->connection.requests() != 0 && now_ - client->last_request < quiet;
    if (!client->kept && !asks && (victim == nullptr || rank(*client) < rank(*victim))) victim = client.get();
  }
  if (victim == nullptr) return false;
  close_client(victim->socket.get());
  crowded_out_.fetch_add(1, std::memory_order_relaxed);
  return true;
}

void Server::close_overdue() {
  tables::Time shortest = options_.frame;
  if (options_.idle > 0) shortest = std::min(shortest, options_.idle);
  next_sweep_ = now_ + std::clamp<tables::Time>(shortest / 4, 5 * tables::kMillisecond, tables::kSecond);
  std::vector<int> overdue;
  for (const auto& [fd, client] : clients_) {
    const bool idle = options_.idle > 0 && now_ - client->last_request > options_.idle;
    const bool stuck = client->frame_begun != 0 && now_ - client->frame_begun > options_.frame;
    if (idle || stuck) overdue.push_back(fd);
  }
  for (const int fd : overdue) close_client(fd);
}

void Server::listen(bool on) {
  epoll_event event{};
  event.events = on ? std::uint32_t{EPOLLIN} : 0U;
  event.data.fd = listener_.get();
  listening_ = ::epoll_ctl(epoll_.get(), EPOLL_CTL_MOD, listener_.get(), &event) == 0 && on;
}

}  // namespace symplant::link::modbus
