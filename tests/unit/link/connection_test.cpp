// One client's stream, without a socket: any split, many frames at once, and a client that does not read.
#include "symplant/link/modbus/connection.hpp"

#include <algorithm>
#include <vector>

#include "support/catch.hpp"
#include "support/raw_client.hpp"

using namespace symplant::link::image;
using namespace symplant::link::modbus;
using symplant::test::Bytes;
using State = Connection::State;

namespace {

/// Answers every request with its own bytes.
class FixedEcho final : public Responder {
 public:
  Answer respond(const ClientId& /*client*/, std::span<const std::uint8_t> request,
                 std::span<std::uint8_t, kMaxPdu> reply) noexcept override {
    std::copy(request.begin(), request.end(), reply.begin());
    return {.size = request.size()};
  }
  void refused(std::span<const std::uint8_t> /*request*/) noexcept override { ++refusals; }

  int refusals = 0;
};

/// A peer that takes `window` bytes and then no more until its window grows.
class Peer final : public Sink {
 public:
  std::ptrdiff_t write(std::span<const std::uint8_t> bytes) noexcept override {
    if (gone) return -1;
    const std::size_t count = std::min(bytes.size(), window);
    window -= count;
    taken.insert(taken.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
    return static_cast<std::ptrdiff_t>(count);
  }

  Bytes taken;
  std::size_t window = SIZE_MAX;
  bool gone = false;
};

struct ConnectionBench {
  Connection connection;
  FixedEcho echo;
  Peer peer;

  /// The bytes that the connection had room for.
  std::size_t feed(const Bytes& bytes) {
    const auto room = connection.room();
    const std::size_t count = std::min(room.size(), bytes.size());
    std::copy_n(bytes.begin(), count, room.begin());
    if (count != 0) state = connection.received(count, echo, peer);
    return count;
  }
  State state = State::open;
};

Bytes frame(int transaction, const Bytes& pdu, int protocol = 0) {
  Bytes bytes;
  for (const int field : {transaction, protocol, static_cast<int>(pdu.size()) + 1}) {
    bytes.push_back(static_cast<std::uint8_t>(field >> 8));
    bytes.push_back(static_cast<std::uint8_t>(field & 0xFF));
  }
  bytes.push_back(9);
  for (const std::uint8_t byte : pdu) bytes.push_back(byte);
  return bytes;
}

Bytes join(const std::vector<Bytes>& parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

TEST_CASE("A request's answer has its transaction and unit") {
  ConnectionBench bench;
  bench.feed(frame(0x1234, {3, 1, 2}));
  CHECK(bench.peer.taken == frame(0x1234, {3, 1, 2}));
}

TEST_CASE("Bytes that arrive one at a time are answered the same") {
  ConnectionBench bench;
  const Bytes all = join({frame(1, {3, 1, 2}), frame(2, {4}), frame(3, {5, 6})});
  for (const std::uint8_t byte : all) CHECK(bench.feed({byte}) == 1);
  CHECK(bench.peer.taken == all);
}

TEST_CASE("Frames split at every offset are answered the same") {
  const Bytes all = join({frame(1, {3, 1, 2}), frame(2, {4}), frame(3, Bytes(kMaxPdu, 7))});
  for (std::size_t split = 1; split < all.size(); ++split) {
    ConnectionBench bench;
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(split);
    bench.feed(Bytes(all.begin(), middle));
    bench.feed(Bytes(middle, all.end()));
    REQUIRE(bench.peer.taken == all);
  }
}

TEST_CASE("Many frames in one segment are all answered in order to a client that reads") {
  ConnectionBench bench;
  std::vector<Bytes> frames;
  for (int i = 0; i < 64; ++i) frames.push_back(frame(i, {3, static_cast<std::uint8_t>(i)}));
  CHECK(bench.feed(join(frames)) == join(frames).size());
  CHECK(bench.peer.taken == join(frames));
  CHECK(bench.echo.refusals == 0);
}

TEST_CASE("A frame of another protocol is dropped without an answer, and the next one is served") {
  ConnectionBench bench;
  const auto protocol = GENERATE(1, 0x0100, 0xFFFF);
  bench.feed(join({frame(1, {3}, protocol), frame(2, {4})}));
  CHECK(bench.peer.taken == frame(2, {4}));
  CHECK(bench.state == State::open);
}

TEST_CASE("An invalid length closes the connection, after the answers before it") {
  const auto length = GENERATE(0, 1, 255, 0xFFFF);
  ConnectionBench bench;
  bench.feed(join(
      {frame(1, {3}), {0, 2, 0, 0, static_cast<std::uint8_t>(length >> 8), static_cast<std::uint8_t>(length & 0xFF)}}));
  CHECK(bench.peer.taken == frame(1, {3}));
  CHECK(bench.state == State::closed);
}

TEST_CASE("A peer that has disconnected closes the connection") {
  ConnectionBench bench;
  bench.peer.gone = true;
  bench.feed(frame(1, {3}));
  CHECK(bench.state == State::closed);
}

TEST_CASE("An answer that the peer takes in parts arrives complete") {
  ConnectionBench bench;
  bench.peer.window = 0;
  const Bytes all = join({frame(1, {3, 1, 2}), frame(2, {4, 4})});
  bench.feed(all);
  CHECK(bench.connection.has_answers_to_send());
  while (bench.connection.has_answers_to_send()) {
    bench.peer.window = 1;
    CHECK(bench.connection.resume(bench.echo, bench.peer) == State::open);
  }
  CHECK(bench.peer.taken == all);
}

TEST_CASE("Requests after 16 untaken answers are rejected as busy, and none is lost") {
  ConnectionBench bench;
  bench.peer.window = 0;
  for (int i = 0; i < 20; ++i) bench.feed(frame(i, {3}));
  bench.peer.window = SIZE_MAX;
  bench.connection.resume(bench.echo, bench.peer);
  bench.feed(frame(20, {3}));
  std::vector<Bytes> expected;
  for (int i = 0; i < 16; ++i) expected.push_back(frame(i, {3}));
  for (int i = 16; i < 20; ++i) expected.push_back(frame(i, {0x83, 6}));
  expected.push_back(frame(20, {3}));
  CHECK(bench.peer.taken == join(expected));
  CHECK(bench.echo.refusals == 4);
}

TEST_CASE("A client that sends without reading is paused, and is served again when it reads") {
  ConnectionBench bench;
  bench.peer.window = 0;
  std::vector<Bytes> sent;
  while (!bench.connection.room().empty()) {
    sent.push_back(join({frame(1, {3}), frame(2, {3}), frame(3, {3})}));
    REQUIRE(bench.feed(sent.back()) == sent.back().size());
    REQUIRE(sent.size() < 1000);
  }
  CHECK(bench.connection.requests() == Connection::kMaxQueued);
  bench.peer.window = SIZE_MAX;
  CHECK(bench.connection.resume(bench.echo, bench.peer) == State::open);
  CHECK_FALSE(bench.connection.room().empty());
  CHECK(bench.connection.requests() == 3 * sent.size());
}

TEST_CASE("Answers taken in odd parts repeatedly are not counted as waiting afterwards") {
  ConnectionBench bench;
  std::vector<Bytes> sent;
  for (int round = 0; round < 100; ++round) {
    bench.peer.window = 5;
    for (int i = 0; i < 3; ++i) {
      sent.push_back(frame(round, {3, static_cast<std::uint8_t>(i)}));
      bench.feed(sent.back());
    }
    bench.peer.window = 7;
    bench.connection.resume(bench.echo, bench.peer);
    bench.peer.window = SIZE_MAX;
    bench.connection.resume(bench.echo, bench.peer);
  }
  CHECK(bench.echo.refusals == 0);
  CHECK(bench.peer.taken == join(sent));
}
