// One request and its reply at a time over a connection to a PLC.
#include "symplant/link/slmp/exchange.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "symplant/link/client/steady_now.hpp"
#include "symplant/link/slmp/other_answer.hpp"

namespace symplant::link::slmp {

using client::Fault;
using net::Ended;

namespace {

Fault lost(std::string message) { return {Fault::Kind::transport, std::move(message)}; }

}  // namespace

Exchange::Exchange(const Settings& settings)
    : address_(settings.address),
      transport_(settings.transport),
      framing_(settings.framing),
      timeout_(settings.timeout),
      writer_(settings.framing),
      short_(settings.times.poll),
      received_(2 * kLongestReply) {}

net::Deadline Exchange::deadline() const {
  return std::chrono::steady_clock::now() + std::chrono::nanoseconds(timeout_);
}

Fault Exchange::open() {
  size_ = 0;
  used_ = 0;
  switch (socket_.connect(address_, transport_, deadline())) {
    case Ended::done:
      short_.opened();
      return {};
    case Ended::interrupted:
      return {Fault::Kind::interrupted};
    case Ended::timeout:
      return lost("no connection to " + net::format_host_port(address_) +
                  ": no answer; check the address, the cable and the port settings of the PLC");
    case Ended::closed:
      break;
  }
  return lost("no connection to " + net::format_host_port(address_) + ": " + socket_.fault() +
              "; check that the PLC's port is set up for SLMP (MC protocol) and that no other program uses it; after a "
              "lost connection a PLC may refuse new ones for up to 45 s");
}

void Exchange::close() noexcept { socket_.close(); }

RequestWriter& Exchange::begin(Command command, bool bits) {
  writer_.begin(command, bits, ++serial_);
  return writer_;
}

Fault Exchange::failed(Ended ended, const char* doing) {
  if (ended == Ended::interrupted) return {Fault::Kind::interrupted};
  if (ended == Ended::closed) {
    closed_ = size_ == 0;
    return lost(std::string("connection lost ") + doing + ": " + socket_.fault());
  }
  if (answered_) return lost("the PLC does not answer any more; connecting again");
  if (size_ != 0) return lost("connected, but " + other_answer(std::span(received_).first(size_), framing_));
  const bool ascii = framing_.code == Code::ascii;
  return lost(
      std::string("connected, but the PLC does not answer: its port probably expects other frames; try `code=") +
      (ascii ? "binary" : "ascii") + "`" + (framing_.frame == FrameType::e4 ? " or `frame=3e`" : "") +
      ", or check that this port speaks SLMP");
}

Fault Exchange::unknown(const std::string& reason) const {
  if (answered_) return lost("the PLC's answer is invalid: " + reason + "; connecting again");
  return lost("connected, but " + other_answer(std::span(received_).first(size_), framing_));
}

Fault Exchange::transact(Reply& reply) {
  Fault fault = attempt(reply);
  if (!fault || !std::exchange(closed_, false) || !short_.may_reopen()) return fault;
  if (socket_.wait(short_.next()) == Ended::interrupted) return {Fault::Kind::interrupted};
  fault = open();
  return fault ? fault : attempt(reply);
}

Fault Exchange::attempt(Reply& reply) {
  closed_ = false;
  std::copy(received_.begin() + static_cast<std::ptrdiff_t>(used_),
            received_.begin() + static_cast<std::ptrdiff_t>(size_), received_.begin());
  size_ -= std::exchange(used_, 0);
  if (framing_.frame == FrameType::e3) {
    // Nothing in a reply says which request it answers: anything that is there already would be taken for it.
    const bool more = size_ != 0 || socket_.discard() != 0;
    if (more && transport_ == net::Transport::tcp) {
      return lost("the PLC sent more than one reply to a request; connecting again");
    }
    size_ = 0;
  }
  const net::Deadline end = deadline();
  sent_ = client::steady_now();
  const Ended sent = socket_.send(writer_.finish(), end);
  Fault fault = sent == Ended::done ? receive(reply, end) : failed(sent, "while sending");
  if (fault) return fault;
  at_ = client::steady_now();
  answered_ = true;
  short_.answered();
  return {};
}

Fault Exchange::receive(Reply& reply, net::Deadline end) {
  const bool datagrams = transport_ == net::Transport::udp;
  for (;;) {
    if (!datagrams || size_ != 0) {
      reply = parse_reply(std::span(received_).first(size_), framing_, serial_, datagrams);
      if (reply.kind == Reply::Kind::broken) {
        return unknown(reply.reason);
      }
      if (reply.kind == Reply::Kind::complete) {
        used_ = reply.consumed;
        return {};
      }
      if (reply.kind == Reply::Kind::late) {
        std::copy(received_.begin() + static_cast<std::ptrdiff_t>(reply.consumed),
                  received_.begin() + static_cast<std::ptrdiff_t>(size_), received_.begin());
        size_ -= reply.consumed;
        if (std::chrono::steady_clock::now() >= end) return failed(Ended::timeout, "");  // late replies without end
        continue;
      }
    }
    std::size_t count = 0;
    const Ended ended = socket_.receive(std::span(received_).subspan(size_), count, end);
    if (ended != Ended::done) return failed(ended, "while waiting for an answer");
    size_ += count;
  }
}

}  // namespace symplant::link::slmp
