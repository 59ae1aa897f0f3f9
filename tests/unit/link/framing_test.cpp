// MBAP frames in a stream: the rows of the messaging guide.
#include "symplant/link/modbus/framing.hpp"

#include <algorithm>
#include <vector>

#include "support/catch.hpp"
#include "support/raw_client.hpp"

using namespace symplant::link::image;
using namespace symplant::link::modbus;
using symplant::test::Bytes;
using Kind = Frame::Kind;

TEST_CASE("A complete frame is taken, with the fields to echo") {
  const Bytes bytes = {0x12, 0x34, 0, 0, 0, 6, 0xFF, 1, 0, 0, 0, 1};
  const Frame frame = parse_frame(bytes);
  CHECK(frame.kind == Kind::complete);
  CHECK(frame.consumed == 12);
  CHECK(frame.transaction == 0x1234);
  CHECK(frame.unit == 0xFF);
  CHECK(Bytes(frame.pdu.begin(), frame.pdu.end()) == Bytes{1, 0, 0, 0, 1});
}

TEST_CASE("An incomplete frame is waited for, at every length") {
  const Bytes bytes = {0x12, 0x34, 0, 0, 0, 6, 0xFF, 1, 0, 0, 0, 1};
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Frame frame = parse_frame(std::span(bytes).first(size));
    CHECK(frame.kind == Kind::incomplete);
    CHECK(frame.consumed == 0);
  }
}

TEST_CASE("Only the first of several frames is taken") {
  const Bytes bytes = {0, 1, 0, 0, 0, 2, 1, 7, 0, 2, 0, 0, 0, 2, 1, 8};
  const Frame frame = parse_frame(bytes);
  CHECK(frame.consumed == 8);
  CHECK(frame.pdu.size() == 1);
  CHECK(frame.pdu[0] == 7);
}

TEST_CASE("A frame of another protocol is foreign, once it is complete") {
  const Bytes bytes = {0, 1, 0, 1, 0, 3, 1, 1, 2};
  CHECK(parse_frame(std::span(bytes).first(8)).kind == Kind::incomplete);
  CHECK(parse_frame(bytes).kind == Kind::foreign);
  CHECK(parse_frame(bytes).consumed == 9);
}

TEST_CASE("An invalid length breaks the stream as soon as it is seen") {
  const auto length = GENERATE(0, 1, 255, 256, 1000, 0xFFFF);
  const Bytes bytes = {0, 1, 0, 0, static_cast<std::uint8_t>(length >> 8), static_cast<std::uint8_t>(length & 0xFF)};
  CHECK(parse_frame(bytes).kind == Kind::broken);
}

TEST_CASE("The shortest and the longest frame are taken") {
  Bytes shortest = {0, 1, 0, 0, 0, 2, 1, 7};
  CHECK(parse_frame(shortest).kind == Kind::complete);
  Bytes longest(kMaxFrame, 0);
  longest[5] = 254;
  CHECK(parse_frame(longest).kind == Kind::complete);
  CHECK(parse_frame(longest).pdu.size() == kMaxPdu);
}

TEST_CASE("A reply's header has the request's transaction and unit, and its own length") {
  Frame frame;
  frame.transaction = 0xABCD;
  frame.unit = 0x11;
  std::array<std::uint8_t, kMbapHeader> header{};
  write_header(frame, 253, header);
  CHECK(Bytes(header.begin(), header.end()) == Bytes{0xAB, 0xCD, 0, 0, 0, 254, 0x11});
}
