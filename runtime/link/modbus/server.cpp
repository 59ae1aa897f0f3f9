// The sockets of a Modbus TCP server and the thread that serves them.
#include "symplant/link/modbus/server.hpp"

#include <algorithm>
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
    const std::ptrdiff_t sent = net::send(fd_, bytes);
    return sent < 0 && net::would_wait(net::last_error()) ? 0 : sent;
  }

 private:
  int fd_;
};

}  // namespace

struct Server::Client {
  explicit Client(const ClientId& id) : connection(id) {}

  net::Descriptor socket;
  Connection connection;
  std::uint64_t last_use = 0;
  tables::Time last_request = 0;  ///< or the time when it was accepted
  tables::Time frame_begun = 0;   ///< begin of the frame that is still incomplete; 0: no such frame
  net::Wanted watched{.read = true};
  bool kept = false;
  bool ended = false;  ///< sends no more, but still gets its answers
};

Server::Server(net::Descriptor listener, Responder& responder, ServerOptions options)
    : listener_(std::move(listener)), responder_(responder), options_(std::move(options)) {
  options_.connections = std::max<std::size_t>(options_.connections, 1);
  net::make_room_for(options_.connections);
  if (!sockets_.add(wake_.socket(), {.read = true}) || !sockets_.add(listener_.get(), {.read = true})) {
    throw std::system_error(net::last_error(), std::generic_category(), "waiting for sockets");
  }
  const net::NoSignals blocked;
  thread_ = std::thread([this] { serve(); });
}

Server::~Server() {
  wake_.wake();
  thread_.join();
}

void Server::serve() {
  for (;;) {
    const std::span<const net::SocketSet::Ready> ready = sockets_.wait(milliseconds_to_wait());
    now_ = steady_now();
    if (!listening_) listen(true);
    if (cut_.load(std::memory_order_relaxed)) close_all();
    bool is_asked = false;
    for (const net::SocketSet::Ready& each : ready) {
      if (each.socket == wake_.socket()) return;
      if (each.socket == listener_.get()) is_asked = true;
      const auto client = clients_.find(each.socket);
      if (client != clients_.end()) serve_client(*client->second, each);
    }
    // Last, so that nothing above is mistaken for news of a new client with the descriptor of a closed one.
    if (is_asked) accept_clients();
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
    net::Descriptor socket = net::accept_client(listener_.get());
    if (socket) {
      gave_way_ = false;
      if (!cut_.load(std::memory_order_relaxed)) add_client(std::move(socket));
      continue;
    }
    switch (net::after_accept(net::last_error())) {
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
  if (!sockets_.add(fd, {.read = true})) return;
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

void Server::serve_client(Client& client, const net::SocketSet::Ready& ready) {
  const std::uint64_t before = client.connection.requests();
  SocketSink sink(client.socket.get());
  bool open = true;
  if (ready.write) open = client.connection.resume(responder_, sink) == Connection::State::open;
  if (open && ready.read) open = read_from(client);
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
  const std::ptrdiff_t count = net::receive(client.socket.get(), room);
  if (count < 0) return net::would_wait(net::last_error());
  if (count == 0) {
    client.ended = true;
    return true;
  }
  SocketSink sink(client.socket.get());
  return client.connection.received(static_cast<std::size_t>(count), responder_, sink) == Connection::State::open;
}

bool Server::rearm(Client& client) {
  const net::Wanted wanted{.read = !client.ended && !client.connection.room().empty(),
                           .write = client.connection.has_answers_to_send()};
  if (wanted == client.watched) return true;
  client.watched = wanted;
  return sockets_.change(client.socket.get(), wanted);
}

void Server::close_client(int fd) {
  const auto client = clients_.find(fd);
  responder_.left(client->second->connection.client());
  sockets_.remove(fd);
  clients_.erase(client);
  open_.store(static_cast<std::uint32_t>(clients_.size()), std::memory_order_relaxed);
}

void Server::close_all() {
  for (const auto& [fd, client] : clients_) {
    responder_.left(client->connection.client());
    sockets_.remove(fd);
  }
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

void Server::listen(bool on) { listening_ = sockets_.change(listener_.get(), {.read = on}) && on; }

}  // namespace symplant::link::modbus
