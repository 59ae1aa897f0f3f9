// The loop of the server's thread: receives requests, sends the parts of replies when they are due.
#include "support/slmp/plc_loop.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace symplant::test::slmp {
namespace {

constexpr int kSendPatience = 1000;  // milliseconds until a client that does not read loses its connection
constexpr std::size_t kBufferSize = 65'536;

bool is_readable(const pollfd& each) { return (each.revents & (POLLIN | POLLHUP | POLLERR)) != 0; }

}  // namespace

void PlcSockets::Loop::run() {
  while (!stops_) {
    std::vector<pollfd> waiting = {
        {wake_read_.get(), POLLIN, 0}, {listener_.get(), POLLIN, 0}, {datagrams_.get(), POLLIN, 0}};
    for (const auto& [id, contact] : contacts_) {
      if (!contact.peer.is_udp) waiting.push_back({contact.socket.get(), POLLIN, 0});
    }
    ::poll(waiting.data(), waiting.size(), next_timeout());
    if (is_readable(waiting[0])) run_commands();
    read_connections();
    if (is_readable(waiting[2])) read_datagrams();
    if (is_readable(waiting[1]) && listener_.get() >= 0) accept_connection();
    send_due();
    remove_closed();
    if (refuses_until_ && Clock::now() >= *refuses_until_) set_refusing(false);
  }
}

/// Milliseconds until the next part is due, rounded up; -1: nothing is due.
int PlcSockets::Loop::next_timeout() const {
  std::optional<Clock::time_point> first = refuses_until_;
  for (const auto& [id, contact] : contacts_) {
    if (contact.pending.empty()) continue;
    const Clock::time_point due = contact.pending.front().due;
    if (!first || due < *first) first = due;
  }
  if (!first) return -1;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(*first - Clock::now()).count();
  return static_cast<int>(std::max<std::int64_t>(left, 0));
}

void PlcSockets::Loop::read_connections() {
  for (auto& [id, contact] : contacts_) {
    if (!contact.peer.is_udp && !contact.is_closed) read_connection(contact);
  }
}

void PlcSockets::Loop::read_connection(Contact& contact) {
  std::array<std::uint8_t, kBufferSize> buffer;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled by recv
  const std::size_t size_before = contact.received.size();
  bool has_ended = false;
  while (true) {
    const ssize_t count = ::recv(contact.socket.get(), buffer.data(), buffer.size(), 0);
    if (count > 0) {
      contact.received.insert(contact.received.end(), buffer.begin(), buffer.begin() + count);
      continue;
    }
    has_ended = count == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
    break;
  }
  if (contact.received.size() > size_before) {
    std::size_t used = 0;
    use(contact, contact.received, &used);
    contact.received.erase(contact.received.begin(), contact.received.begin() + static_cast<std::ptrdiff_t>(used));
  }
  if (has_ended) end(contact, false);
}

void PlcSockets::Loop::read_datagrams() {
  std::array<std::uint8_t, kBufferSize> buffer;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled by recvfrom
  while (true) {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    const ssize_t count =
        ::recvfrom(datagrams_.get(), buffer.data(), buffer.size(), 0, reinterpret_cast<sockaddr*>(&address), &size);
    if (count < 0) return;
    std::size_t used = 0;
    use(contact_of(address), std::span(buffer).first(static_cast<std::size_t>(count)), &used);
  }
}

PlcSockets::Loop::Contact& PlcSockets::Loop::contact_of(const sockaddr_in& address) {
  for (auto& [id, contact] : contacts_) {
    if (contact.peer.is_udp && contact.address.sin_port == address.sin_port) return contact;
  }
  Contact& contact = contacts_[next_id_];
  contact.peer = {next_id_++, true};
  contact.address = address;
  return contact;
}

void PlcSockets::Loop::use(Contact& contact, std::span<const std::uint8_t> bytes, std::size_t* used) {
  std::vector<Delivery> deliveries;
  contact.peer.awaits_reply = !contact.pending.empty();
  *used = handler_.received(contact.peer, bytes, deliveries);
  for (Delivery& delivery : deliveries) queue(contact, std::move(delivery));
  send_due();
}

void PlcSockets::Loop::queue(Contact& contact, Delivery delivery) {
  const Clock::time_point now = Clock::now();
  if (delivery.refuses_for) {
    listener_ = FileDescriptor();
    refuses_until_ = now + *delivery.refuses_for;
  }
  Clock::time_point due = contact.pending.empty() ? now : std::max(now, contact.pending.back().due);
  for (Delivery::Part& part : delivery.parts) {
    due += part.after;
    contact.pending.push_back({due, std::move(part.bytes), false});
  }
  if (delivery.resets) contact.pending.push_back({due, {}, true});
}

void PlcSockets::Loop::send_due() {
  const Clock::time_point now = Clock::now();
  for (auto& [id, contact] : contacts_) {
    while (!contact.pending.empty() && contact.pending.front().due <= now) {
      const Pending part = std::move(contact.pending.front());
      contact.pending.pop_front();
      if (contact.is_closed) continue;
      send_now(contact, part.bytes);
      if (part.resets && !contact.peer.is_udp) end(contact, true);
    }
  }
}

void PlcSockets::Loop::send_now(Contact& contact, const Bytes& bytes) {
  if (contact.peer.is_udp) {
    if (bytes.empty()) return;
    ::sendto(datagrams_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL,
             reinterpret_cast<const sockaddr*>(&contact.address), sizeof contact.address);
    return;
  }
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t count = ::send(contact.socket.get(), bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count > 0) {
      sent += static_cast<std::size_t>(count);
      continue;
    }
    pollfd room{contact.socket.get(), POLLOUT, 0};
    if (errno != EAGAIN || ::poll(&room, 1, kSendPatience) <= 0) return end(contact, true);
  }
}

}  // namespace symplant::test::slmp
