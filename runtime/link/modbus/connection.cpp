// One client of the server: reads its requests and sends its answers, each at its own pace.
#include "symplant/link/modbus/connection.hpp"

#include <algorithm>

namespace symplant::link::modbus {

std::span<std::uint8_t> Connection::room() noexcept {
  if (queued_.size() >= kMaxQueued) return {};
  return std::span(in_).subspan(in_size_);
}

Connection::State Connection::received(std::size_t count, Responder& responder, Sink& sink) {
  in_size_ += count;
  return work(responder, sink);
}

Connection::State Connection::resume(Responder& responder, Sink& sink) {
  if (!flush(sink)) return State::closed;
  return work(responder, sink);
}

Connection::State Connection::work(Responder& responder, Sink& sink) {
  std::size_t begin = 0;
  State state = State::open;
  while (state == State::open) {
    // Answers are sent before a request is rejected for their number: a peer that reads gets all its answers.
    if (queued_.size() >= kMaxInFlight && !flush(sink)) return State::closed;
    if (queued_.size() >= kMaxQueued) break;
    const Frame frame = parse_frame(std::span(in_).subspan(begin, in_size_ - begin));
    if (frame.kind == Frame::Kind::incomplete) break;
    if (frame.kind == Frame::Kind::broken) state = State::closed;
    if (frame.kind == Frame::Kind::complete) answer(frame, responder);
    begin += frame.consumed;
  }
  std::copy(in_.begin() + static_cast<std::ptrdiff_t>(begin), in_.begin() + static_cast<std::ptrdiff_t>(in_size_),
            in_.begin());
  in_size_ -= begin;
  // Also before closing: the requests before the broken frame were valid.
  return flush(sink) ? state : State::closed;
}

void Connection::answer(const Frame& frame, Responder& responder) {
  std::array<std::uint8_t, kMaxFrame> bytes{};
  const auto header = std::span(bytes).first<kMbapHeader>();
  const auto reply = std::span(bytes).subspan<kMbapHeader>();
  ++requests_;
  Answer result;
  if (queued_.size() < kMaxInFlight) {
    result = responder.respond(client_, frame.pdu, reply);
  } else {
    result = refuse_request(frame.pdu, Exception::server_device_busy, reply);
    responder.refused(frame.pdu);
  }
  if (result.size == 0) return;
  write_header(frame, result.size, header);
  out_.insert(out_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(kMbapHeader + result.size));
  queued_.push_back(out_.size());
}

bool Connection::flush(Sink& sink) {
  while (sent_ < out_.size()) {
    const std::ptrdiff_t taken = sink.write(std::span(out_).subspan(sent_));
    if (taken < 0) return false;
    if (taken == 0) break;
    sent_ += static_cast<std::size_t>(taken);
  }
  while (!queued_.empty() && queued_.front() <= sent_) queued_.pop_front();
  // Removes what was sent, so that the buffer never holds more than the answers in the queue.
  out_.erase(out_.begin(), out_.begin() + static_cast<std::ptrdiff_t>(sent_));
  for (std::size_t& end : queued_) end -= sent_;
  sent_ = 0;
  return true;
}

}  // namespace symplant::link::modbus
