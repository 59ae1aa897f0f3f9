// The PLC's connections: TCP and UDP, frames, codes, silence, refusals.
#include "support/catch.hpp"
#include "support/slmp/slmp_plc.hpp"
#include "unit/slmp_plc/requests.hpp"

using namespace symplant::test::slmp;

namespace {

Request one_word(Code code = Code::binary) { return Request(kRead, 0, code).device("D", 0).number(1, 2); }

Bytes reply_with(std::uint32_t word, const Request& request, Code code = Code::binary) {
  FieldWriter data(code);
  data.words({word});
  return encode_reply(request.frame(), code, 0, data.bytes());
}

/// Sends the request and expects exactly the right reply.
void check_served(const WireClient& client, const Request& request, Code code = Code::binary) {
  const Bytes reply = reply_with(0x1234, request, code);
  client.send(request.bytes());
  CHECK(client.receive(reply.size()) == reply);
}

}  // namespace

TEST_CASE("Frames 3E and 4E are served over TCP and UDP on the same port, in either code") {
  for (const Code code : {Code::binary, Code::ascii}) {
    SlmpPlc plc({.code = code});
    plc.memory().set_word("D", 0, 0x1234);
    for (const bool is_udp : {false, true}) {
      const WireClient client(plc.port(), is_udp);
      check_served(client, one_word(code), code);
      check_served(client, one_word(code).serial(0xABCD), code);
    }
    CHECK(plc.log().requests().at(3).is_udp);
    CHECK(plc.log().requests().at(3).is_4e);
    CHECK(plc.log().violations().empty());
  }
}

TEST_CASE("A request may come byte by byte, and two may come at once") {
  SlmpPlc plc;
  plc.memory().set_word("D", 0, 0x1234);
  const WireClient client(plc.port());
  const Bytes request = one_word().bytes();
  for (const std::uint8_t byte : request) client.send({byte});
  const Bytes reply = reply_with(0x1234, one_word());
  CHECK(client.receive(reply.size()) == reply);
  CHECK(plc.log().violations().empty());
  Bytes two = request;
  two.insert(two.end(), request.begin(), request.end());
  client.send(two);
  CHECK(client.receive(2 * reply.size()).size() == 2 * reply.size());
  CHECK(plc.log().most_outstanding() == 2);
  CHECK(plc.log().violations().size() == 1);
}

TEST_CASE("Two 4E requests at once are served in order without a violation") {
  SlmpPlc plc;
  const WireClient client(plc.port());
  Bytes two = one_word().serial(1).bytes();
  const Bytes second = one_word().serial(2).bytes();
  two.insert(two.end(), second.begin(), second.end());
  client.send(two);
  const Bytes replies = client.receive(2 * 17);
  CHECK(replies.at(2) == 1);
  CHECK(replies.at(17 + 2) == 2);
  CHECK(plc.log().violations().empty());
}

TEST_CASE("A request in the other code gets no reply, and the next one in the right code does") {
  for (const Code code : {Code::binary, Code::ascii}) {
    const Code other = code == Code::binary ? Code::ascii : Code::binary;
    SlmpPlc plc({.code = code});
    plc.memory().set_word("D", 0, 0x1234);
    for (const bool is_udp : {false, true}) {
      plc.log().clear();
      const WireClient client(plc.port(), is_udp);
      client.send(one_word(other).bytes());
      CHECK(plc.wait_until([&] { return plc.log().violations().size() == 1; }));
      check_served(client, one_word(code), code);
    }
  }
}

TEST_CASE("A PLC without 4E does not reply to it") {
  SlmpPlc plc({.profile = profile_of(Family::q)});
  plc.memory().set_word("D", 0, 0x1234);
  const WireClient client(plc.port());
  client.send(one_word().serial(1).bytes());
  CHECK(plc.wait_until([&] { return plc.log().count() == 1; }));
  check_served(client, one_word());
  CHECK_FALSE(plc.log().requests().front().has_reply);
}

TEST_CASE("A datagram that is not one whole request gets no reply") {
  SlmpPlc plc;
  plc.memory().set_word("D", 0, 0x1234);
  const WireClient client(plc.port(), true);
  Bytes longer = one_word().bytes();
  longer.push_back(0);
  client.send(longer);
  Bytes shorter = one_word().bytes();
  shorter.pop_back();
  client.send(shorter);
  check_served(client, one_word());
  CHECK(plc.log().violations().size() == 2);
}

TEST_CASE("A silent PLC executes nothing, a second 3E request meanwhile is a violation") {
  SlmpPlc plc;
  plc.set_silent(true);
  const WireClient client(plc.port());
  const Request write = Request(kWrite, 1).device("M", 0).number(1, 2).bits({1});
  client.send(write.bytes());
  CHECK(plc.wait_until([&] { return plc.log().count() == 1; }));
  client.send(write.bytes());
  CHECK(plc.wait_until([&] { return plc.log().count() == 2; }));
  CHECK(plc.log().most_outstanding() == 2);
  CHECK(plc.log().violations().size() == 1);
  plc.set_silent(false);
  CHECK_FALSE(plc.memory().bit("M", 0));
  client.send(write.bytes());
  CHECK(client.receive(11).size() == 11);
  CHECK(plc.memory().bit("M", 0));
}

TEST_CASE("The PLC closes connections, refuses them, and serves again on the same port") {
  SlmpPlc plc;
  plc.memory().set_word("D", 0, 0x1234);
  const WireClient first(plc.port());
  CHECK(plc.wait_until([&] { return plc.connections() == 1; }));
  plc.close_connections();
  CHECK(plc.connections() == 0);
  CHECK(first.is_closed());
  const WireClient second(plc.port());
  CHECK(plc.wait_until([&] { return plc.connections() == 1; }));
  plc.refuse_connections(true);
  CHECK_FALSE(WireClient(plc.port()).connected());
  plc.close_connections(true);
  CHECK(second.is_closed());
  plc.refuse_connections(false);
  check_served(WireClient(plc.port()), one_word());
  CHECK(plc.log().violations().empty());
}

TEST_CASE("A connection above the most is reset, one after a close is not") {
  SlmpPlc plc({.most_connections = 2});
  plc.memory().set_word("D", 0, 0x1234);
  {
    const WireClient first(plc.port());
    const WireClient second(plc.port());
    const WireClient third(plc.port());
    CHECK(third.is_closed());
    CHECK(plc.refused_connections() == 1);
    check_served(first, one_word());
    check_served(second, one_word());
  }
  for (int i = 0; i < 50; ++i) check_served(WireClient(plc.port()), one_word());
  CHECK(plc.refused_connections() == 1);
}

TEST_CASE("An error reply has the error information block") {
  SlmpPlc plc;
  const WireClient client(plc.port());
  client.send(Request(kRead, 0).device("D", 0).number(961, 2).bytes());
  CHECK(client.receive(20) ==
        Bytes{0xD0, 0, 0, 0xFF, 0xFF, 3, 0, 0x0B, 0, 0x51, 0xC0, 0, 0xFF, 0xFF, 3, 0, 1, 4, 0, 0});
}

TEST_CASE("A PLC can serve only TCP or only UDP") {
  SlmpPlc tcp({.udp = false});
  CHECK(WireClient(tcp.port()).connected());
  SlmpPlc udp({.tcp = false});
  CHECK_FALSE(WireClient(udp.port()).connected());
  CHECK_THROWS_AS(SlmpPlc({.port = tcp.port()}), std::runtime_error);
}
