// Requests of a Modbus client and the replies that it takes.
#include "symplant/link/modbus/client_codec.hpp"

#include <array>
#include <vector>

#include "support/catch.hpp"

using namespace symplant::link::modbus;
using Catch::Matchers::ContainsSubstring;
using Kind = ClientRequest::Kind;
using ReplyBytes = std::vector<std::uint8_t>;

namespace {

constexpr ClientHeader kHeader{.transaction = 0x0102, .unit = 7};

ReplyBytes encoded(const ClientRequest& request, const std::vector<std::uint16_t>& values = {}) {
  std::array<std::uint8_t, kMaxFrame> frame{};
  const std::size_t size = request.kind == Kind::write ? encode_write(kHeader, request, values, frame)
                                                       : encode_request(kHeader, request, frame);
  return {frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size)};
}

/// A reply to transaction 0102 of unit 7.
ReplyBytes reply_of(const ReplyBytes& pdu) {
  ReplyBytes frame = {1, 2, 0, 0, 0, static_cast<std::uint8_t>(pdu.size() + 1), 7};
  frame.insert(frame.end(), pdu.begin(), pdu.end());
  return frame;
}

ClientReply::Kind kind_of(const ReplyBytes& bytes, const ClientRequest& request) {
  return parse_client_reply(bytes, kHeader, request).kind;
}

std::string reason_of(const ReplyBytes& pdu, const ClientRequest& request) {
  const ReplyBytes bytes = reply_of(pdu);
  const ClientReply reply = parse_client_reply(bytes, kHeader, request);
  return reply.kind == ClientReply::Kind::broken ? reply.reason : "taken";
}

}  // namespace

TEST_CASE("Requests have the bytes of the specification") {
  // The examples of the Application Protocol V1.1b3, sections 6.1 to 6.4, 6.11 and 6.12.
  CHECK(encoded({Kind::read, Area::coils, 0x13, 0x13}) == ReplyBytes{1, 2, 0, 0, 0, 6, 7, 1, 0, 0x13, 0, 0x13});
  CHECK(encoded({Kind::read, Area::discrete_inputs, 0xC4, 0x16}) ==
        ReplyBytes{1, 2, 0, 0, 0, 6, 7, 2, 0, 0xC4, 0, 0x16});
  CHECK(encoded({Kind::read, Area::holding_registers, 0x6B, 3}) == ReplyBytes{1, 2, 0, 0, 0, 6, 7, 3, 0, 0x6B, 0, 3});
  CHECK(encoded({Kind::read, Area::input_registers, 8, 1}) == ReplyBytes{1, 2, 0, 0, 0, 6, 7, 4, 0, 8, 0, 1});
  CHECK(encoded({Kind::write, Area::coils, 0x13, 10}, {1, 0, 1, 1, 0, 0, 1, 1, 1, 0}) ==
        ReplyBytes{1, 2, 0, 0, 0, 9, 7, 15, 0, 0x13, 0, 10, 2, 0xCD, 1});
  CHECK(encoded({Kind::write, Area::holding_registers, 1, 2}, {0x0A, 0x0102}) ==
        ReplyBytes{1, 2, 0, 0, 0, 11, 7, 16, 0, 1, 0, 2, 4, 0, 0x0A, 1, 2});
  CHECK(encoded({.kind = Kind::identify}) == ReplyBytes{1, 2, 0, 0, 0, 5, 7, 43, 14, 1, 0});
}

TEST_CASE("The largest requests fit into a frame") {
  const std::vector<std::uint16_t> ones(kMostBitsWritten, 1);
  CHECK(encoded({Kind::write, Area::coils, 0, kMostBitsWritten}, ones).size() == kMbapHeader + 6 + 246);
  const std::vector<std::uint16_t> values(kMostRegistersWritten, 0xFFFF);
  CHECK(encoded({Kind::write, Area::holding_registers, 0, kMostRegistersWritten}, values).size() ==
        kMbapHeader + 6 + 246);
}

TEST_CASE("A reply is complete only with its last byte, and what follows it is left") {
  const ClientRequest request{Kind::read, Area::holding_registers, 0x6B, 2};
  ReplyBytes bytes = reply_of({3, 4, 0x02, 0x2B, 0, 0x64});
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const ReplyBytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    CHECK(kind_of(part, request) == ClientReply::Kind::incomplete);
  }
  const std::size_t size = bytes.size();
  bytes.push_back(0xEE);
  const ClientReply reply = parse_client_reply(bytes, kHeader, request);
  CHECK(reply.kind == ClientReply::Kind::complete);
  CHECK(reply.consumed == size);
  CHECK(ReplyBytes(reply.data.begin(), reply.data.end()) == ReplyBytes{0x02, 0x2B, 0, 0x64});
}

TEST_CASE("A reply that fails any check is not taken") {
  const ClientRequest request{Kind::read, Area::coils, 0, 9};
  const ReplyBytes good = {1, 2, 0xFF, 1};
  CHECK(reason_of(good, request) == "taken");
  CHECK_THAT(reason_of({1, 1, 0xFF, 1}, request), ContainsSubstring("number of bytes"));
  CHECK_THAT(reason_of({1, 2, 0xFF}, request), ContainsSubstring("number of bytes"));
  CHECK_THAT(reason_of({1, 2, 0xFF, 1, 0}, request), ContainsSubstring("number of bytes"));
  CHECK_THAT(reason_of({2, 2, 0xFF, 1}, request), ContainsSubstring("another function"));
  CHECK_THAT(reason_of({0x82, 2}, request), ContainsSubstring("another function"));
  CHECK_THAT(reason_of({0x81}, request), ContainsSubstring("no code"));
  CHECK_THAT(reason_of({0x81, 0}, request), ContainsSubstring("no code"));
  ReplyBytes bytes = reply_of(good);
  bytes[6] = 8;
  CHECK(kind_of(bytes, request) == ClientReply::Kind::broken);
  bytes = reply_of(good);
  bytes[3] = 1;
  CHECK(kind_of(bytes, request) == ClientReply::Kind::broken);
  bytes = reply_of(good);
  bytes[4] = 0xFF;
  CHECK(kind_of(bytes, request) == ClientReply::Kind::broken);
  bytes = reply_of(good);
  bytes[1] = 1;  // the transaction before
  CHECK(kind_of(bytes, request) == ClientReply::Kind::foreign);
}

TEST_CASE("A confirmation of a write repeats its addresses") {
  const ClientRequest request{Kind::write, Area::coils, 0x13, 10};
  CHECK(reason_of({15, 0, 0x13, 0, 10}, request) == "taken");
  CHECK_THAT(reason_of({15, 0, 0x13, 0, 9}, request), ContainsSubstring("other addresses"));
  CHECK_THAT(reason_of({15, 0, 0x12, 0, 10}, request), ContainsSubstring("other addresses"));
  CHECK_THAT(reason_of({15, 0, 0x13, 0}, request), ContainsSubstring("other addresses"));
}

TEST_CASE("Exceptions are complete replies and say what to do") {
  const ClientRequest request{Kind::read, Area::input_registers, 0, 1};
  const ReplyBytes bytes = reply_of({0x84, 2});
  CHECK(parse_client_reply(bytes, kHeader, request).exception == 2);
  CHECK_THAT(exception_text(1, request), ContainsSubstring("does not support function 4"));
  CHECK_THAT(exception_text(2, request), ContainsSubstring("illegal data address") && ContainsSubstring("offset"));
  CHECK_THAT(exception_text(11, request), ContainsSubstring("check `unit`"));
  CHECK_THAT(exception_text(99, request), ContainsSubstring("exception 99") && ContainsSubstring("manual"));
}

TEST_CASE("Bits of a reply are copied to any position and nothing else is changed") {
  const ReplyBytes data = {0xCD, 0x6B, 0xB2, 0x0E, 0x1B, 0x55, 0xAA, 0x0F, 0xF0, 0x3C};
  for (const std::uint32_t count : {1U, 8U, 37U, 64U, 65U, 80U}) {
    for (std::uint32_t first = 0; first < 70; ++first) {
      std::array<std::uint64_t, 4> words{};
      const ReplyBytes part(data.begin(), data.begin() + (count + 7) / 8);
      copy_bits(part, count, words, first);
      for (std::uint32_t i = 0; i < 256; ++i) {
        const bool inside = i >= first && i < first + count;
        const bool expected = inside && (data[(i - first) / 8] >> (i - first) % 8 & 1) != 0;
        if (((words[i / 64] >> i % 64) & 1) != (expected ? 1 : 0)) FAIL(count << " bits at " << first << ": bit " << i);
      }
    }
  }
}

TEST_CASE("The texts of a device identification are shown without bytes that are not text") {
  CHECK(identification_text(ReplyBytes{2, 0, 4, 'A', 'c', 'm', 'e', 1, 3, 'X', 0x1B, '9'}) == "Acme X9");
  CHECK(identification_text(ReplyBytes{3, 0, 200, 'A'}).empty());
  CHECK(identification_text(ReplyBytes{}).empty());
}
