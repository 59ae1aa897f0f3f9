// The PLC that distorts its replies: each kind of lie alone, and the seeded schedule.
#include "support/catch.hpp"
#include "support/slmp/lying_plc.hpp"
#include "unit/slmp_plc/requests.hpp"

using namespace symplant::test::slmp;

namespace {

Request counter(std::uint16_t serial = 7) { return Request(kRead, 0).device("D", 0).number(1, 2).serial(serial); }

/// The honest reply to counter().
Bytes truth(std::uint32_t word, std::uint16_t serial = 7) {
  FieldWriter data(Code::binary);
  data.words({word});
  return encode_reply(counter(serial).frame(), Code::binary, 0, data.bytes());
}

/// The bytes that come for one distorted reply, up to the honest reply after it or the end of the connection.
Bytes lie_of(Distortion distortion, const LieOptions& options = {}) {
  LyingPlc plc({}, options);
  plc.lie_always(Distortion::honest);
  plc.plc().memory().set_word("D", 0, 0x1234);
  const WireClient client(plc.port());
  plc.lie_once(distortion);
  client.send(counter().bytes());
  CHECK(plc.plc().wait_until([&] { return plc.plc().log().count() == 1; }));
  plc.plc().memory().set_word("D", 0, 0x5678);
  client.send(counter(8).bytes());
  const Bytes end = truth(0x5678, 8);
  Bytes all;
  while (all.size() < end.size() || !std::equal(end.rbegin(), end.rend(), all.rbegin())) {
    const Bytes part = client.receive_some();
    if (part.empty()) return all;
    all.insert(all.end(), part.begin(), part.end());
  }
  all.resize(all.size() - end.size());
  return all;
}

LieOptions short_delays() { return {.late_by = std::chrono::milliseconds(5)}; }

Bytes twice(const Bytes& bytes) {
  Bytes all = bytes;
  all.insert(all.end(), bytes.begin(), bytes.end());
  return all;
}

Bytes with_byte(std::size_t at, std::uint8_t value) {
  Bytes bytes = truth(0x1234);
  bytes.at(at) = value;
  return bytes;
}

}  // namespace

TEST_CASE("Whole replies can come late, held back, doubled or in pieces") {
  const Bytes reply = truth(0x1234);
  for (const Distortion distortion :
       {Distortion::honest, Distortion::late, Distortion::held, Distortion::bytewise, Distortion::halved}) {
    INFO(name_of(distortion));
    CHECK(lie_of(distortion, short_delays()) == reply);
  }
  CHECK(lie_of(Distortion::doubled) == twice(reply));
}

TEST_CASE("Fields of the header can be wrong") {
  const Bytes reply = truth(0x1234);
  CHECK(lie_of(Distortion::foreign_serial) == with_byte(2, 6));
  CHECK(lie_of(Distortion::wrong_subheader) == with_byte(0, 0xD0));
  const Bytes route = lie_of(Distortion::wrong_route);
  REQUIRE(route.size() == reply.size());
  CHECK(route[7] != 0xFF);
  const Bytes too_long = lie_of(Distortion::length_too_long);
  REQUIRE(too_long.size() == reply.size());
  CHECK(too_long[11] > 4);
  const Bytes too_short = lie_of(Distortion::length_too_short);
  REQUIRE(too_short.size() == reply.size());
  CHECK(too_short[11] < 4);
  const Bytes huge = lie_of(Distortion::length_huge);
  CHECK(huge.at(11) == 0xFF);
  CHECK(huge.at(12) == 0xFF);
}

TEST_CASE("Replies can be cut, end in a reset, or not come") {
  const Bytes reply = truth(0x1234);
  const Bytes cut = lie_of(Distortion::truncated);
  CHECK(cut.size() < reply.size());
  CHECK(std::equal(cut.begin(), cut.end(), reply.begin()));
  CHECK(lie_of(Distortion::reset_within).size() < reply.size());
  CHECK(lie_of(Distortion::silent).empty());
  CHECK(lie_of(Distortion::reset).empty());
}

TEST_CASE("Error replies can lack their block or a part of it") {
  CHECK(lie_of(Distortion::bare_error) == Bytes{0xD4, 0, 7, 0, 0, 0, 0, 0xFF, 0xFF, 3, 0, 2, 0, 0xE0, 0xCE});
  const Bytes partial = lie_of(Distortion::short_error);
  CHECK(partial.size() > 15);
  CHECK(partial.size() < 24);
  CHECK(partial.at(11) == partial.size() - 13);
}

TEST_CASE("Data can be more or less than asked for, or in the other code") {
  const Bytes more = lie_of(Distortion::extra_data);
  CHECK(more.size() == truth(0).size() + 2);
  CHECK(more.at(11) == 6);
  const Bytes less = lie_of(Distortion::missing_data);
  CHECK(less.size() == truth(0).size() - 2);
  CHECK(less.at(11) == 2);
  const Bytes trailing = lie_of(Distortion::trailing_bytes);
  CHECK(trailing.size() > truth(0).size());
  CHECK(lie_of(Distortion::other_code).at(0) == 'D');
  CHECK_FALSE(lie_of(Distortion::garbage).empty());
}

TEST_CASE("After a refusal the PLC serves again on the same port") {
  LyingPlc plc({}, {.refuses_for = std::chrono::milliseconds(5)});
  plc.lie_always(Distortion::honest);
  plc.lie_once(Distortion::refused);
  const WireClient first(plc.port());
  first.send(counter().bytes());
  CHECK(first.is_closed());
  while (!WireClient(plc.port()).connected()) {
  }
  CHECK(plc.count(Distortion::refused) == 1);
}

TEST_CASE("A held reply comes over UDP as a datagram before the next reply") {
  LyingPlc plc;
  plc.lie_always(Distortion::honest);
  plc.lie_once(Distortion::held);
  const WireClient client(plc.port(), true);
  client.send(counter(1).bytes());
  CHECK(plc.plc().wait_until([&] { return plc.plc().log().count() == 1; }));
  client.send(counter(2).bytes());
  CHECK(client.receive_some() == truth(0, 1));
  CHECK(client.receive_some() == truth(0, 2));
}

TEST_CASE("A schedule of the same seed gives the same lies") {
  const auto counts = [](std::uint64_t seed) {
    LyingPlc plc({}, {.seed = seed,
                      .lies_per_thousand = 600,
                      .kinds = {Distortion::bytewise, Distortion::foreign_serial, Distortion::wrong_route}});
    const WireClient client(plc.port());
    std::vector<Bytes> replies;
    for (int i = 0; i < 200; ++i) {
      client.send(counter().bytes());
      replies.push_back(client.receive(truth(0).size()));
    }
    CHECK(plc.lies() + plc.count(Distortion::honest) == 200);
    CHECK(plc.lies() > 80);
    CHECK(plc.lies() < 160);
    return replies;
  };
  CHECK(counts(1) == counts(1));
  CHECK(counts(1) != counts(2));
}
